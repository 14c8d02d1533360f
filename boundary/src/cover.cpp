#include "cover.hpp"

#include <algorithm>

#include "closed_spans.hpp"
#include "cubic.hpp"
#include "grid_crossings.hpp"

namespace shoreline {
namespace {

/// The lines along the sides of a cell, but for sides so short that rounding turns them.
std::vector<Line> lines_along(Corners corners, const Vec2& centre, double shortest) {
  std::vector<Line> lines;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 edge = corners[(k + 1) % corners.size()] - corners[k];
    if (edge.norm() < shortest) continue;
    const Vec2 inward = Vec2(-edge.y(), edge.x()).normalized();
    lines.push_back({inward, inward.dot(corners[k] + centre)});
  }
  return lines;
}

bool in_front(std::span<const Line> lines, const Vec2& x) {
  return std::ranges::all_of(lines, [&](const Line& line) { return line.normal.dot(x) >= line.offset; });
}

/// Whether a line has all of a span behind it.
bool keeps_off(std::span<const Line> lines, const CubicSpan& span) {
  return std::ranges::any_of(lines, [&](const Line& line) {
    return std::ranges::all_of(span.control, [&](const Vec2& x) { return line.normal.dot(x) < line.offset; });
  });
}

Box box_of(Corners corners, const Vec2& centre) {
  Box box{corners[0], corners[0]};
  for (const Vec2& x : corners) {
    box.lower = box.lower.cwiseMin(x);
    box.upper = box.upper.cwiseMax(x);
  }
  return {box.lower + centre, box.upper + centre};
}

/// The span's runs through a cell, each closed along its border.
Moments closed_runs(const CubicSpan& span, Corners corners, std::span<const Line> lines, const Vec2& centre) {
  const std::vector<double> u = split_at_lines(span, lines);
  Moments sum = Moments::Zero();
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    const bool inside = by_majority(u[i], u[i + 1], [&](double at) { return in_front(lines, span.position(at)); });
    if (inside) sum += closed_run(part(span, u[i], u[i + 1]), corners, centre);
  }
  return sum;
}

}  // namespace

Cover::Cover(std::span<const SplineCurve> curves) : region_(curves), spans_(closed_spans(curves)), tree_(spans_) {}

Moments Cover::moments(Corners corners, const Vec2& centre, double shortest) const {
  const Moments whole = along_border(corners, {corners.size() - 1, corners[0]}, corners[0]);
  const std::vector<Line> lines = lines_along(corners, centre, shortest);
  Moments runs = Moments::Zero();
  bool met = false;
  tree_.for_each_in(box_of(corners, centre), [&](std::size_t k) {
    if (keeps_off(lines, spans_[k])) return;
    met = true;
    runs += closed_runs(spans_[k], corners, lines, centre);
  });
  const auto centroid_inside = [&] { return region_.contains(centre + whole.segment<2>(1) / whole[0]); };
  if (!met) return centroid_inside() ? whole : Moments(Moments::Zero());
  return runs + whole * missing_wholes(runs[0] / whole[0], centroid_inside);
}

}  // namespace shoreline
