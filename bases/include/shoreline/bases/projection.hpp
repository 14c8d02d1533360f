#pragma once
// The L2 projection of values at points onto a basis.

#include <span>
#include <vector>

#include "shoreline/bases/basis.hpp"

namespace shoreline {

/// Points with weights, each in a cell: an integration rule over cells, or material points with their volumes.
struct WeightedPoints {
  std::vector<Index> cell;     ///< (m)
  std::vector<Vec2> x;         ///< (m) [m]
  std::vector<double> weight;  ///< (m) positive [m²]
};

/// Gauss points in every cell of a grid of rectangles or triangles, exact for polynomials up to @p degree on each.
/// Triangles take the rule of the square, collapsed onto one of their vertices.
///
/// @throws InvalidArgument with the degree unless 0 <= degree <= 63
[[nodiscard]] WeightedPoints integration_points(const Grid& grid, int degree);

/// Points given by hand, in their order.
///
/// @param weight  one a point, positive [m²]
/// @throws InvalidArgument with the first point outside the grid, its number and position
[[nodiscard]] WeightedPoints points_in(const Grid& grid, std::span<const Vec2> x, std::span<const double> weight);

/// Which matrix a projection divides by.
enum class Mass {
  consistent,  ///< Σ_p w_p φ_i φ_j: the best approximation
  lumped,      ///< its row sums Σ_p w_p φ_i: means of the values, which stay within their extremes
};

/// Coefficients whose field is nearest to given values, (P.1), or (lumped) whose coefficients are means of them, (P.2):
///
///     Σ_j (Σ_p w_p φ_i(x_p) φ_j(x_p)) c_j = Σ_p w_p φ_i(x_p) f_p        c_i = Σ_p w_p φ_i(x_p) f_p / Σ_p w_p φ_i(x_p)
///
/// Determined are the functions of elements (cells, main triangles) that hold points; all others have coefficient 0.
/// Polynomials that the basis reproduces come out as they are with the consistent mass, not with the lumped one.
///
/// @param value  (points, fields) one column a field
/// @return       (functions, fields)
/// @throws InvalidArgument if there is no point, or not a value for each; naming a function by number and position if
/// it sees no point although its element holds one,
///         or (consistent) if the points do not tell it from its neighbours, so that the mass is singular
[[nodiscard]] Eigen::MatrixXd project(const Basis& basis, const WeightedPoints& points, const Eigen::MatrixXd& value,
                                      Mass mass);

}  // namespace shoreline
