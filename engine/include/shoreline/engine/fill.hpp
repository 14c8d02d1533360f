#pragma once
// Material points from the outline.

#include <span>

#include "shoreline/boundary/region.hpp"
#include "shoreline/engine/case.hpp"
#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// One point in each sub-cell that the body covers, (V.1).
///
/// `clipped`: at the centroid of the covered part, with its area; the volumes sum to the area of the body. `lattice`:
/// at the centre of the sub-cell where that lies inside, with the whole sub-cell.
///
/// @param curves    that close into loops
/// @param per_cell  sub-cells of a grid cell in x and y
[[nodiscard]] MaterialPoints fill_lattice(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid,
                                          const Case::LatticeFill& fill);

/// Points on the nodes of a lattice anchored at the lower left of the body, whose outer layer lies on the outline,
/// (V.2). Each has the part of its sub-cell that the body covers (halves on edges, quarters at corners), or the whole
/// sub-cell.
///
/// @throws InvalidArgument if the body is not a whole number of sub-cells wide and high, or if points in it do not
///         account for its area: then no lattice of this spacing has its outer layer on the outline
[[nodiscard]] MaterialPoints fill_vertex(std::span<const SplineCurve> curves, const Vec2& cell_size,
                                         const Case::VertexFill& fill);

/// Marks points that lie on the outline to within @p tolerance [m]; they belong to the cell on the body's side.
void mark_outline(const Region& region, double tolerance, MaterialPoints& points);

}  // namespace shoreline
