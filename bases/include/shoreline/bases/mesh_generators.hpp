#pragma once
// Triangle meshes made from rectangles and from points.

#include "shoreline/bases/quadrilateral_grid.hpp"
#include "shoreline/bases/triangle_mesh.hpp"

namespace shoreline {

/// How a rectangle is cut into triangles.
enum class TrianglePattern {
  diagonal,  ///< in two, from the lower left to the upper right corner: all diagonals one way
  four,      ///< in four, which meet at its centre
};

/// Cuts every cell of a grid of rectangles. Vertices are the grid's nodes with their numbers, then (pattern four) the
/// centres in the order of the cells; the triangles of a cell follow each other, in the order of the cells.
[[nodiscard]] TriangleMesh triangulate(const QuadrilateralGrid& rectangles, TrianglePattern pattern);

/// The Delaunay triangulation of points: no point lies in the circumcircle of a triangle. Vertices are the points.
///
/// Triangles on the border with an angle below 1° are left out: between points that should lie on one straight side of
/// the hull, rounding makes such triangles. Points on a common circle may be joined either way.
///
/// @param points   positions [m], not all on one line; those closer than 1e-9 of their extent count as one
/// @param outline  numbers of points around the meshed area, counter-clockwise; triangles outside are left out. Empty:
///                 the points' hull
/// @throws MeshError naming the part of the outline that is no edge of the triangulation; by check of the result, so
///         where points coincide, an inner triangle is a sliver or a point lies outside the outline
[[nodiscard]] TriangleMesh delaunay(const std::vector<Vec2>& points, const std::vector<Index>& outline = {});

}  // namespace shoreline
