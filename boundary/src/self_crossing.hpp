#pragma once
// Whether spans that form loops cross or touch themselves or one another.

#include <optional>
#include <span>

#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// A span of a loop, and the piece that it belongs to.
struct LoopSpan {
  CubicSpan span;
  int piece;
};

/// A place where the curves of two pieces, or of one, cross or touch.
struct Crossing {
  int piece;
  int other;
  Vec2 x;
};

/// The first crossing or touch found among loops of spans, each in order; the end that a span shares with the next of
/// its loop is none, unless they leave it side by side.
///
/// Spans are cut where x turns back: a part cannot cross itself. Two parts do not meet if a line separates their
/// control polygons by more than a small tolerance; else both are halved, down to rounding, where they count as
/// crossing. Neighbours meet nowhere else if one direction is ahead for both of them.
///
/// @param size  of the outline [m], with which tolerances scale
[[nodiscard]] std::optional<Crossing> find_crossing(std::span<const std::vector<LoopSpan>> loops, double size);

}  // namespace shoreline
