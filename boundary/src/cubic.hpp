#pragma once
// One coordinate of a cubic span (values, monotone parts, crossings of a level), and the parts of a span.

#include <array>

#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// f(u) = Σ B_k³(u) b_k.
struct Cubic {
  std::array<double, 4> b;

  [[nodiscard]] double value(double u) const;  ///< exactly b_0 at u = 0 and b_3 at u = 1
  [[nodiscard]] double slope(double u) const;
};

/// direction · C(u).
[[nodiscard]] Cubic coordinate(const CubicSpan& span, const Vec2& direction);

/// [begin, end] cut where f' changes its sign: part i is [u[i], u[i+1]], and f runs there from value[i] to value[i+1].
struct MonotoneParts {
  int count;  ///< 1 to 3
  std::array<double, 4> u;
  std::array<double, 4> value;
};

[[nodiscard]] MonotoneParts monotone_parts(const Cubic& f, double begin = 0.0, double end = 1.0);

/// Whether f passes @p level on a monotone part. The level belongs to the upper side, so that of two parts that meet on
/// it either none or both pass it (a touch), or exactly one (a passage).
[[nodiscard]] inline bool passes(double value_begin, double value_end, double level) {
  return (value_begin >= level) != (value_end >= level);
}

/// The u in [begin, end] with f(u) = level, to rounding: Newton's method within a bracket.
/// @pre f is monotone on [begin, end] and passes the level there
[[nodiscard]] double crossing(const Cubic& f, double begin, double end, double level);

/// The span's part [begin, end] as a span of its own. Parts that meet at a parameter share that point exactly.
[[nodiscard]] CubicSpan part(const CubicSpan& span, double begin, double end);

/// The parts of a span on which the coordinate along @p axis is monotone.
[[nodiscard]] std::vector<CubicSpan> monotone_spans(const CubicSpan& span, int axis);

}  // namespace shoreline
