#pragma once
// A small triangle around given points.

#include <array>
#include <span>
#include <vector>

#include "shoreline/bases/grid.hpp"

namespace shoreline {

/// A triangle of small area that holds all @p points, with given sides.
///
/// Candidates have two or three sides in common with the points' convex hull and the given sides; where it is two, the
/// third is orthogonal to their bisector, through the farthest point. The candidate of least area is taken ([de
/// Koster] §3.2). Without given sides its area is within a fifth of the least possible, mostly within a percent.
///
/// @param points  not all on one line [m]
/// @param sides   none, one or two lines, normals inward, with all points on their inner side; two are not parallel
/// @return        corners, counter-clockwise [m]
/// @throws InvalidArgument if all points lie on one line
[[nodiscard]] std::array<Vec2, 3> control_triangle(std::span<const Vec2> points, std::span<const Line> sides);

}  // namespace shoreline
