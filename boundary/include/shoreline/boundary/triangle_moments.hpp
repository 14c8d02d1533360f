#pragma once
// How much of each triangle of a grid, or of each of k² sub-cells of it, lies inside the outline.

#include <array>
#include <span>
#include <vector>

#include "shoreline/bases/triangle_grid.hpp"
#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// Corners of a sub-cell, counter-clockwise [m]. The lines λ_i = j/k of its barycentric coordinates cut each cell into
/// k² triangles alike; those of cell c have the numbers c·k² … (c + 1)·k² − 1, row by row from vertex 0.
///
/// @param divisions  k >= 1
[[nodiscard]] std::array<Vec2, 3> sub_cell(const TriangleGrid& grid, int divisions, Index number);

/// Moments of the covered part of sub-cells, in coordinates about the centroid of each.
struct TriangleMoments {
  std::vector<Index> sub_cell;                      ///< of which more than 1e-13 of the area is covered, ascending
  Eigen::Matrix<double, 6, Eigen::Dynamic> moment;  ///< (6, sub-cells): ∫ {1, ξ, η, ξ², ξη, η²} dA
};

/// ∫_{T ∩ Ω} {1, ξ, η, ξ², ξη, η²} dA of every covered sub-cell T by Green's theorem on the cubics themselves, (R.4):
///
///     ∫ f dA = 1/(d + 2) ∮ f (ξ dη − η dξ) over the boundary of T ∩ Ω, f of degree d.
///
/// Each part of the curve in T adds its own integral and closes along ∂T, so no topology of cut cells is needed,
/// (R.5). Where the outline bulges out of the grid, within the grid's border_slack, the nearest cell's sub-cells have
/// what lies outside, and the areas sum to that of the region. A sub-cell that no curve meets is whole, exactly.
///
/// @param curves     that close into loops which do not cross
/// @param divisions  k: k² sub-cells a cell
/// @throws OutsideGrid if a curve leaves the grid, InvalidArgument if divisions is not positive
[[nodiscard]] TriangleMoments triangle_moments(std::span<const SplineCurve> curves, const TriangleGrid& grid,
                                               int divisions);

}  // namespace shoreline
