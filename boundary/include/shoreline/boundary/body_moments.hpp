#pragma once
// How much of each cell of a grid lies inside the outline, whatever the cells are.

#include <span>
#include <vector>

#include "shoreline/bases/grid.hpp"
#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// Moments of the covered part of cells.
struct BodyMoments {
  std::vector<Index> cell;  ///< cells of which more than 1e-13 of the area is covered, ascending
  Eigen::Matrix2Xd centre;  ///< (2, cells) about which moments are taken: the centroid of the cell [m]
  Eigen::VectorXd whole;    ///< (cells) area of the cell [m²]
  Eigen::MatrixXd moment;  ///< (monomials, cells): ∫ ξ^a η^b dA, a + b <= order, ordered (0,0) (1,0) (0,1) (2,0) …
};

/// ∫_{cell ∩ Ω} ξ^a η^b dA of every covered cell, by (R.2) on rectangles and (R.5) on triangles. What bulges out of the
/// grid, within border_slack, counts for the cell at the border.
///
/// @param curves  that close into loops
/// @param order   highest a + b, 0 to highest_order
/// @throws OutsideGrid if a curve leaves a grid of triangles, or one of rectangles by more than a cell; InvalidArgument
/// if the order is out of range
[[nodiscard]] BodyMoments body_moments(std::span<const SplineCurve> curves, const Grid& grid, int order);

/// 8 on rectangles, 2 on triangles.
[[nodiscard]] int highest_order(const Grid& grid);

/// How many monomials have a degree up to an order.
[[nodiscard]] constexpr Eigen::Index monomials(int order) { return (order + 1) * (order + 2) / 2; }

}  // namespace shoreline
