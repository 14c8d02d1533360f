#include "self_crossing.hpp"

#include <algorithm>

#include "cubic.hpp"
#include "span_tree.hpp"

namespace shoreline {
namespace {

constexpr double gap_tolerance = 1e-13;   // of the outline's size: hulls with a smaller gap touch
constexpr double smallest_part = 1e-10;   // parts of this size that still touch cross
constexpr double smallest_corner = 1e-6;  // how near to a shared end crossings are sought

double extent(const CubicSpan& span) {
  const Box box = span.bounds();
  return (box.upper - box.lower).maxCoeff();
}

/// Whether a line across @p axis separates the control polygons by more than @p gap.
bool separated_along(const Vec2& axis, const CubicSpan& a, const CubicSpan& b, double gap) {
  const auto [a_low, a_high] = std::ranges::minmax(coordinate(a, axis).b);
  const auto [b_low, b_high] = std::ranges::minmax(coordinate(b, axis).b);
  return std::max(b_low - a_high, a_low - b_high) > gap;
}

bool separated(const CubicSpan& a, const CubicSpan& b, double gap) {
  const auto across = [](const CubicSpan& span) {
    const Vec2 chord = span.control[3] - span.control[0];
    return Vec2(-chord.y(), chord.x()).normalized();
  };
  return separated_along(Vec2::UnitX(), a, b, gap) || separated_along(Vec2::UnitY(), a, b, gap) ||
         separated_along(across(a), a, b, gap) || separated_along(across(b), a, b, gap);
}

/// A common point of two parts that share no end.
std::optional<Vec2> meeting(const CubicSpan& a, const CubicSpan& b, double size) {
  if (separated(a, b, gap_tolerance * size)) return std::nullopt;
  if (extent(a) < extent(b)) return meeting(b, a, size);
  if (extent(a) <= smallest_part * size) return a.position(0.5);
  if (const std::optional<Vec2> x = meeting(part(a, 0.0, 0.5), b, size)) return x;
  return meeting(part(a, 0.5, 1.0), b, size);
}

/// Whether all of a lies behind its end, and all of b ahead of its start, in one direction.
bool leads_ahead(const CubicSpan& a, const CubicSpan& b) {
  const Vec2 ahead = a.derivative(1.0).normalized() + b.derivative(0.0).normalized();
  const auto runs_ahead = [&](const CubicSpan& span) {
    const Cubic f = coordinate(span, ahead);
    return f.b[0] < f.b[1] && f.b[1] < f.b[2] && f.b[2] < f.b[3];
  };
  return runs_ahead(a) && runs_ahead(b);
}

/// A common point of two parts, other than the end of a that is the start of b.
std::optional<Vec2> neighbours_meeting(const CubicSpan& a, const CubicSpan& b, double size) {
  if (leads_ahead(a, b) || std::max(extent(a), extent(b)) <= smallest_corner * size) return std::nullopt;
  const CubicSpan a_far = part(a, 0.0, 0.5);
  const CubicSpan b_far = part(b, 0.5, 1.0);
  const CubicSpan b_near = part(b, 0.0, 0.5);
  if (const std::optional<Vec2> x = meeting(a_far, b_far, size)) return x;
  if (const std::optional<Vec2> x = meeting(a_far, b_near, size)) return x;
  const CubicSpan a_near = part(a, 0.5, 1.0);
  if (const std::optional<Vec2> x = meeting(a_near, b_far, size)) return x;
  return neighbours_meeting(a_near, b_near, size);
}

/// A span cut where x turns back, so that no part can cross itself, and in the middle, so that every loop has at least
/// three parts even if it has two spans. Cuts next to another are left out: they would make parts of no length.
std::vector<CubicSpan> forward_parts(const CubicSpan& span) {
  constexpr double shortest = 1e-6;
  const MonotoneParts parts = monotone_parts(coordinate(span, Vec2::UnitX()));
  std::vector<double> u{0.5};
  u.insert(u.end(), parts.u.begin() + 1, parts.u.begin() + parts.count);
  std::ranges::sort(u);
  u.push_back(1.0);
  std::vector<CubicSpan> spans;
  double begin = 0.0;
  for (const double end : u) {
    if (end - begin < shortest || (end < 1.0 && 1.0 - end < shortest)) continue;
    spans.push_back(part(span, begin, end));
    begin = end;
  }
  return spans;
}

/// The parts of all loops.
struct Parts {
  std::vector<CubicSpan> span;
  std::vector<int> piece;
  std::vector<std::size_t> next;  ///< the part that starts where this one ends
};

Parts parts_of(std::span<const std::vector<LoopSpan>> loops) {
  Parts parts;
  for (const std::vector<LoopSpan>& loop : loops) {
    const std::size_t first = parts.span.size();
    for (const LoopSpan& whole : loop)
      for (const CubicSpan& forward : forward_parts(whole.span)) {
        parts.span.push_back(forward);
        parts.piece.push_back(whole.piece);
        parts.next.push_back(parts.span.size());
      }
    if (parts.span.size() > first) parts.next.back() = first;
  }
  for (std::size_t k = 0; k < parts.span.size(); ++k) parts.span[parts.next[k]].control[0] = parts.span[k].control[3];
  return parts;
}

}  // namespace

std::optional<Crossing> find_crossing(std::span<const std::vector<LoopSpan>> loops, double size) {
  const Parts parts = parts_of(loops);
  const SpanTree tree(parts.span);
  const Vec2 margin = Vec2::Constant(gap_tolerance * size);
  std::optional<Crossing> found;
  for (std::size_t k = 0; k < parts.span.size() && !found; ++k) {
    const Box box = parts.span[k].bounds();
    tree.for_each_in({box.lower - margin, box.upper + margin}, [&](std::size_t other) {
      if (found || other <= k) return;
      const CubicSpan& a = parts.span[k];
      const CubicSpan& b = parts.span[other];
      const std::optional<Vec2> x = parts.next[k] == other   ? neighbours_meeting(a, b, size)
                                    : parts.next[other] == k ? neighbours_meeting(b, a, size)
                                                             : meeting(a, b, size);
      if (x) found = Crossing{parts.piece[k], parts.piece[other], *x};
    });
  }
  return found;
}

}  // namespace shoreline
