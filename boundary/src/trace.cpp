#include "shoreline/boundary/trace.hpp"

#include "grid_crossings.hpp"
#include "message.hpp"
#include "shoreline/bases/counters.hpp"

namespace shoreline {
namespace {

/// The unit normal to the left of a derivative.
Vec2 left_of(const Vec2& derivative) { return Vec2(-derivative.y(), derivative.x()).normalized(); }

/// The cell of a place on the curve, and whether a line of the grid passes within a rounding error of it.
struct Place {
  Index cell;
  bool on_line;
};

/// On a line, the cell on the body's side.
std::optional<Place> place_at(const CubicSpan& span, double u, const Grid& grid, Index hint) {
  const Vec2 x = span.position(u);
  const Vec2 nudge = 1e-9 * grid.size(hint) * left_of(span.derivative(u));
  const std::optional<Index> inward = grid.locate(x + nudge, hint);
  const std::optional<Index> outward = grid.locate(x - nudge, inward.value_or(hint));
  const std::optional<Index> cell = inward ? inward : grid.locate(x, hint);
  if (!cell) return std::nullopt;
  return Place{*cell, inward != outward};
}

std::string outside_message(const std::string& name, const Vec2& x, const Grid& grid) {
  const Box box = grid.bounds();
  return quoted(name) + ": leaves the grid at " + text(x) + "; the grid reaches from " + text(box.lower) + " to " +
         text(box.upper);
}

}  // namespace

std::vector<Segment> trace(const SplineCurve& curve, const Grid& grid, const std::string& name) {
  count(Work::traces);
  std::vector<Segment> segments;
  segments.reserve(2 * curve.spans.size());
  Index hint = 0;
  for (std::size_t k = 0; k < curve.spans.size(); ++k) {
    const std::vector<double> u = split_at_lines(curve.spans[k], grid);
    for (std::size_t i = 0; i + 1 < u.size(); ++i) {
      const auto at = [&](double place) {
        const std::optional<Place> found = place_at(curve.spans[k], place, grid, hint);
        if (!found) throw OutsideGrid(outside_message(name, curve.spans[k].position(place), grid));
        return *found;
      };
      const Place middle = at(0.5 * (u[i] + u[i + 1]));
      const Index cell =
          middle.on_line ? by_majority(u[i], u[i + 1], [&](double place) { return at(place).cell; }) : middle.cell;
      hint = cell;
      if (i > 0 && segments.back().cell == cell)  // the line was touched or is not an edge here
        segments.back().end = u[i + 1];
      else
        segments.push_back({static_cast<int>(k), u[i], u[i + 1], cell});
    }
  }
  return segments;
}

std::vector<BoundaryPoint> boundary_points(const SplineCurve& curve, const std::vector<Segment>& segments,
                                           const QuadratureRule& rule) {
  std::vector<BoundaryPoint> points;
  points.reserve(segments.size() * static_cast<std::size_t>(rule.point.size()));
  for (const Segment& segment : segments) {
    const CubicSpan& span = curve.spans[static_cast<std::size_t>(segment.span)];
    const double width = segment.end - segment.begin;
    for (Eigen::Index q = 0; q < rule.point.size(); ++q) {
      const double u = segment.begin + width * rule.point[q];
      const Vec2 derivative = span.derivative(u);
      points.push_back({.x = span.position(u),
                        .normal = left_of(derivative),
                        .weight = rule.weight[q] * derivative.norm() * width,
                        .cell = segment.cell,
                        .span = segment.span,
                        .u = u});
    }
  }
  return points;
}

}  // namespace shoreline
