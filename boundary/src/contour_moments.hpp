#pragma once
// What parts of a contour add to moments, (R.4), and how runs of a curve through a convex cell close along its border,
// (R.5).

#include <cmath>
#include <concepts>
#include <span>

#include "shoreline/boundary/spline.hpp"

namespace shoreline {

using Moments = Eigen::Vector<double, 6>;  ///< ∫ {1, ξ, η, ξ², ξη, η²} dA
using Corners = std::span<const Vec2>;     ///< of a convex cell, counter-clockwise, no two equal [m]

/// What the straight line from a to b adds, (R.4).
[[nodiscard]] inline Moments along_line(const Vec2& a, const Vec2& b) {
  const Vec2 c = a + b;  // ∫ x² along the line is (a² + b² + c²)/6
  Moments sum;
  sum << 0.5, c.x() / 6.0, c.y() / 6.0, (a.x() * a.x() + b.x() * b.x() + c.x() * c.x()) / 24.0,
      (a.x() * a.y() + b.x() * b.y() + c.x() * c.y()) / 24.0, (a.y() * a.y() + b.y() * b.y() + c.y() * c.y()) / 24.0;
  return cross(a, b) * sum;
}

/// What a curve adds, (R.4), in coordinates about @p centre.
[[nodiscard]] Moments along_curve(const CubicSpan& curve, const Vec2& centre);

/// A place on the border of a cell, on the side from corner `side`.
struct Foot {
  std::size_t side;
  Vec2 place;
};

/// The place on the border that is nearest to x.
[[nodiscard]] Foot nearest_place(Corners corners, const Vec2& x);

/// Ψ of (R.5): along the border from corner 0 to a foot, and from there to x.
[[nodiscard]] Moments along_border(Corners corners, const Foot& foot, const Vec2& x);

/// What a run of a curve through a cell adds, closed along its border. A run along a side encloses nothing.
[[nodiscard]] Moments closed_run(const CubicSpan& run, Corners corners, const Vec2& centre);

/// m of (R.5): how many whole cells the closed runs lack, so that none to one is covered.
/// @param turns          area of the closed runs, in whole cells
/// @param centre_inside  () → whether the cell's centroid is inside, which decides where the area is none or all
template <std::predicate Inside>
[[nodiscard]] double missing_wholes(double turns, Inside&& centre_inside) {
  constexpr double unclear = 1e-6;  // of the area: so near to none or all
  const double nearest = std::round(turns);
  if (std::abs(turns - nearest) > unclear) return -std::floor(turns);
  return (centre_inside() ? 1.0 : 0.0) - nearest;
}

}  // namespace shoreline
