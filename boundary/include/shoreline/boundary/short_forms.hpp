#pragma once
// Short forms that place the tracking points of lines, arcs and circles.

#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// Equally spaced points on a straight line, both ends included; an open piece without a name.
/// @param points  at least 2
/// @throws InvalidArgument with the value that breaks a precondition
[[nodiscard]] Piece line(const Vec2& from, const Vec2& to, int points = 2);

/// Points at equal angles on an arc, both ends included, with the arc's own tangents at its ends; an open piece without
/// a name. Multiples of 90° are met exactly: the arc about (0, 0) ends at (0, r), not near it.
///
/// @param radius        > 0 [m]
/// @param from_degrees  angle from the x axis [°]
/// @param to_degrees    the arc runs counter-clockwise if it is above from_degrees, clockwise below; |to − from| < 360
/// @param points        at least 2
/// @throws InvalidArgument with the value that breaks a precondition
[[nodiscard]] Piece arc(const Vec2& centre, double radius, double from_degrees, double to_degrees, int points);

/// Points at equal angles on a circle that starts at centre + (radius, 0); a closed piece without a name. It runs
/// counter-clockwise around a body, clockwise (hole) around a hole in one.
///
/// @param radius  > 0 [m]
/// @param points  at least 3
/// @throws InvalidArgument with the value that breaks a precondition
[[nodiscard]] Piece circle(const Vec2& centre, double radius, int points, bool hole);

}  // namespace shoreline
