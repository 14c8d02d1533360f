#pragma once
// A basis: functions on the cells of a grid.

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "shoreline/bases/grid.hpp"
#include "shoreline/bases/lanes.hpp"

namespace shoreline {

/// Upper bound of the functions that see one point (bicubic B-splines).
inline constexpr int max_support = 16;

using ShortIndices = Eigen::Matrix<Index, Eigen::Dynamic, 1, 0, max_support, 1>;
using ShortVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_support, 1>;
using ShortGradients = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, max_support>;
using ShortCurvatures = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, max_support>;

/// The functions that see one point, with the basis there; n functions, n <= max_support. Never on the heap.
struct Support {
  ShortIndices function;    ///< (n)
  ShortVector value;        ///< (n), sums to 1
  ShortGradients gradient;  ///< (2, n) [1/m], rows sum to 0

  /// Σ value_i · coefficient_i of a vector field with coefficients (2, functions).
  [[nodiscard]] Vec2 interpolate(const Eigen::Matrix2Xd& coefficient) const;
  /// ∇u with (∇u)_ij = ∂u_i/∂x_j of such a field.
  [[nodiscard]] Mat2 gradient_of(const Eigen::Matrix2Xd& coefficient) const;
};

/// A cell whose functions are products X_i(ξ) Y_j(η) of polynomials of degree p, (ξ, η) = (x − corner)/size. Function
/// (i, j) is the one at i + j·(p + 1).
struct ProductCell {
  Vec2 corner;                ///< [m]
  Vec2 size;                  ///< [m]
  std::span<const double> x;  ///< ((p + 1)²) coefficients of X_i, function fastest, then power; the basis owns them
  std::span<const double> y;  ///< likewise of Y_j
};

/// Functions φ_i on the cells of a grid. Two questions: which cell holds x (the grid's), and what is there (evaluate).
///
/// Partition of unity, Σ φ_i = 1, and linear reproduction, Σ φ_i(x) control_point(i) = x, hold on every cell.
class Basis {
 public:
  virtual ~Basis() = default;

  [[nodiscard]] virtual const Grid& grid() const = 0;

  /// Number of functions on the whole grid.
  [[nodiscard]] virtual Index functions() const = 0;

  /// Functions per cell, the same for all cells; at most max_support.
  [[nodiscard]] virtual int functions_per_cell() const = 0;

  /// Polynomial degree p along a grid line: 1 for bilinear. Complete polynomials of this degree are reproduced.
  [[nodiscard]] virtual int degree() const = 0;

  /// Order r of the derivatives that are continuous across faces: 0 for bilinear.
  [[nodiscard]] virtual int continuity() const = 0;

  /// Total degree of the gradients on a cell: 0 for linear triangles, 1 for bilinear and Powell-Sabin functions.
  [[nodiscard]] virtual int gradient_degree() const = 0;

  /// The functions that do not vanish on a cell, in the order in which evaluate returns them.
  [[nodiscard]] virtual ShortIndices functions_of(Index cell) const = 0;

  /// The point X_i with Σ φ_i X_i = x (the node of a nodal basis) [m].
  [[nodiscard]] virtual Vec2 control_point(Index function) const = 0;

  /// Values and gradients at many points by the polynomials of one cell, also outside it (continued).
  ///
  /// @param x         (m) positions [m]
  /// @param value     (m · n), function fastest: value[q·n + a]
  /// @param gradient  (m · 2n), ∂x then ∂y of each function: gradient[q·2n + 2a + d] [1/m]; null: values alone
  virtual void evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const = 0;

  /// The same at points side by side, which takes little more time than one of each four.
  virtual void evaluate(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const = 0;

  /// The factors of a cell's functions; none where they are not such products, or cheap without.
  [[nodiscard]] virtual std::optional<ProductCell> product_cell(Index /*cell*/) const { return std::nullopt; }

  /// Second derivatives (∂xx, ∂yy, ∂xy) at one point by the polynomials of one cell [1/m²].
  [[nodiscard]] virtual ShortCurvatures curvatures(Index cell, const Vec2& x) const = 0;

  /// Everything at one point by the polynomials of one cell.
  [[nodiscard]] Support support(Index cell, const Vec2& x) const;
};

}  // namespace shoreline
