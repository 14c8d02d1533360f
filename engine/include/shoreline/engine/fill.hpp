#pragma once
// Material points from the outline.

#include <array>
#include <span>

#include "shoreline/bases/triangle_grid.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// How the volumes of material points follow from the outline.
enum class VolumeRule {
  lattice,  ///< points keep the whole sub-cell
  clipped,  ///< a point has the part of its sub-cell that the body covers
  equal,    ///< every point has the same share of the body's area
  fitted    ///< of a lattice: Gauss points in whole cells, more and clipped ones in cut cells; else as clipped
};

/// Points in the sub-cells of every cell.
struct LatticeFill {
  std::array<int, 2> per_cell{};
  VolumeRule volumes = VolumeRule::clipped;
};

/// Points in the sub-cells of every rectangle of a grid, however triangles cut it.
struct BlockFill {
  std::array<int, 2> per_block{};
  VolumeRule volumes = VolumeRule::clipped;
};

/// Points in the sub-cells of the box that bounds the body, whatever the grid.
struct AcrossFill {
  std::array<int, 2> across{};
  VolumeRule volumes = VolumeRule::clipped;
};

/// Points on the nodes of a lattice whose outer layer lies on the outline.
struct VertexFill {
  std::array<int, 2> count{};  ///< sub-cells in a cell size; or, if across, points from side to side of the body
  bool across = false;
  VolumeRule volumes = VolumeRule::clipped;
};

/// Points on the nodes of a lattice in polar coordinates, whose outer layer lies on the outline.
struct PolarFill {
  Vec2 centre = Vec2::Zero();   ///< [m]
  std::array<int, 2> across{};  ///< points along the radius and along the angle, both outer layers included
  VolumeRule volumes = VolumeRule::clipped;
};

/// Points anywhere in the elements.
struct RandomFill {
  enum class Volumes {
    voronoi,  ///< a point has the part of the body that is nearer to it than to all others
    equal     ///< every point has the same share of the body's area
  };
  int per_element = 1;  ///< 1 to 1000
  int seed = 1;         ///< >= 0
  Volumes volumes = Volumes::voronoi;
};

/// One point in each sub-cell that the body covers, (V.1).
///
/// `clipped`: at the centroid of the covered part, with its area; the volumes sum to the area of the body. `lattice`:
/// at the centre of the sub-cell where that lies inside, with the whole sub-cell. `equal`: there, with |Ω|/N.
///
/// @param curves  that close into loops
[[nodiscard]] MaterialPoints fill_lattice(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid,
                                          const LatticeFill& fill);

/// Points for weights that are fitted to the outline, (V.8): per_cell Gauss points in each direction of a rectangle
/// that the body covers whole, three in such a triangle (its sub-cells' centroids where per_cell makes more than four);
/// in a cell that the outline cuts the points of `clipped` with at least 2p + 2 sub-cells in each direction
/// (triangles: 3).
///
/// @param degree  p of the basis
[[nodiscard]] MaterialPoints fill_fitted(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid,
                                         const std::array<int, 2>& per_cell, int degree);
[[nodiscard]] MaterialPoints fill_fitted(std::span<const SplineCurve> curves, const TriangleGrid& grid,
                                         const std::array<int, 2>& per_cell, int degree);

/// One point in each part of a triangle that the body covers, (V.4). Each cell is cut into k² triangles alike, where k
/// is per_cell on a main triangle that is one cell, and half of it, rounded up, on each of the six cells of a
/// Powell-Sabin triangle. The rules mean what they mean for rectangles.
///
/// @param fill  with the same number in both directions
/// @throws InvalidArgument with the two numbers if they differ
[[nodiscard]] MaterialPoints fill_lattice(std::span<const SplineCurve> curves, const TriangleGrid& grid,
                                          const LatticeFill& fill);

/// The number k of sub-cells along an edge of a cell for points per_cell, see fill_lattice.
/// @throws InvalidArgument with the two numbers if they differ
[[nodiscard]] int divisions_of(const std::array<int, 2>& per_cell, const TriangleGrid& grid);

/// The same in the sub-cells s of the box that bounds the body, from side to side, (V.5).
[[nodiscard]] MaterialPoints fill_lattice(std::span<const SplineCurve> curves, const AcrossFill& fill);

/// Points anywhere in the body, uniformly in the part E ∩ Ω that it covers of each element E (rectangle or main
/// triangle), (V.7): round(per_element · |E ∩ Ω|/|E|) of them, at least one where that part is more than 1e-8 of E.
///
/// Each element draws by itself, from a generator seeded by `seed` and its number: the same points on every machine, in
/// any order of elements. A part of less than 1e-4 of its cell has its point at its centroid, where that lies inside;
/// no point stands for one that 100 000 draws miss. Volumes are those of voronoi_areas, (V.6), or |Ω|/N; either way
/// they sum to the area of the body.
///
/// @throws InvalidArgument with both areas if the body reaches over a hole of the triangles
[[nodiscard]] MaterialPoints fill_random(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid,
                                         const RandomFill& fill);
[[nodiscard]] MaterialPoints fill_random(std::span<const SplineCurve> curves, const TriangleGrid& grid,
                                         const RandomFill& fill);

/// Points on the nodes of a lattice anchored at the lower left of the body, whose outer layer lies on the outline,
/// (V.2). `clipped`: each has the part of its sub-cell that the body covers (halves on edges, quarters at corners);
/// `lattice`: the whole sub-cell; `equal`: |Ω|/N.
///
/// @param cell_size  of the grid [m]; not used by a lattice that is given across the body
/// @throws InvalidArgument if the body is not a whole number of sub-cells wide and high, if there are fewer than 2
///         points across it, or if points in it do not account for its area: then no lattice of this spacing has its
///         outer layer on the outline
[[nodiscard]] MaterialPoints fill_vertex(std::span<const SplineCurve> curves, const Vec2& cell_size,
                                         const VertexFill& fill);

/// Points on the nodes of a polar lattice in a sector of a ring, a <= r <= b, θ_0 <= θ <= θ_1, that the tracking points
/// on the outline give; its outer layers lie on the outline and are marked as on it, (V.3). A full ring has no first
/// and last angle: the angles wrap, from 0 on.
///
/// `clipped`: the sector about the node, halved at the ends; the volumes sum to (b² − a²)(θ_1 − θ_0)/2. `lattice`: that
/// sector whole, also at the ends. `equal`: the same share of the ring's sector.
///
/// @throws InvalidArgument with what was found and expected if a tracking point lies on none of the two radii and two
///         angles (to 1e-6 of b), if the outline bounds another area (by more than 1e-3), or if there are too few
///         points
[[nodiscard]] MaterialPoints fill_polar(std::span<const SplineCurve> curves, const PolarFill& fill);

/// Marks points that lie on the outline to within @p tolerance [m]; they belong to the cell on the body's side.
void mark_outline(const Region& region, double tolerance, MaterialPoints& points);

}  // namespace shoreline
