#include "shoreline/boundary/triangle_moments.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "closed_spans.hpp"
#include "contour_moments.hpp"
#include "cubic.hpp"
#include "grid_crossings.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/trace.hpp"

namespace shoreline {
namespace {

using Triangle = std::array<Vec2, 3>;

Vec2 centroid(const Triangle& p) { return (p[0] + p[1] + p[2]) / 3.0; }
double area_of(const Triangle& p) { return 0.5 * twice_area(p[0], p[1], p[2]); }

/// A part of the outline in one sub-cell.
struct Run {
  Index sub_cell;
  CubicSpan curve;
  bool outside;  ///< beside the grid
};

/// The lines λ_i = j/k within a cell.
std::vector<Line> inner_lines(const Triangle& p, int divisions) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 edge = p[(i + 2) % 3] - p[(i + 1) % 3];
    const Vec2 inward = Vec2(-edge.y(), edge.x()).normalized();
    const double base = inward.dot(p[(i + 1) % 3]);
    const double height = inward.dot(p[i]) - base;
    for (int j = 1; j < divisions; ++j) lines.push_back({inward, base + height * j / divisions});
  }
  return lines;
}

/// Which sub-cell of a cell holds x, or is nearest: row i from vertex 0, place b in the row, upright or inverted.
Index place_in(const Triangle& p, const Vec2& x, int divisions) {
  const double scale = divisions / twice_area(p[0], p[1], p[2]);
  const double from_side_0 = scale * twice_area(x, p[1], p[2]);
  const double from_side_1 = scale * twice_area(p[0], x, p[2]);
  const int a = static_cast<int>(std::clamp(from_side_0, 0.0, divisions - 1.0));
  const int row = divisions - 1 - a;
  const int b = static_cast<int>(std::clamp(from_side_1, 0.0, 1.0 * row));
  const bool inverted = b < row && (from_side_0 - a) + (from_side_1 - b) > 1.0;
  return row * row + 2 * b + (inverted ? 1 : 0);
}

bool lies_outside(const Triangle& p, const Vec2& x, double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2& a = p[k];
    const Vec2& b = p[(k + 1) % 3];
    if (twice_area(a, b, x) < -tolerance * (b - a).norm()) return true;
  }
  return false;
}

/// Which sub-cell of a cell holds the place u of a segment; along a line between two, the one on the left.
Index place_at(const CubicSpan& segment, double u, const Triangle& p, double nudge, int divisions) {
  const Vec2 along = segment.derivative(u).normalized();
  return place_in(p, segment.position(u) + nudge * Vec2(-along.y(), along.x()), divisions);
}

/// The runs of a segment, which lies in one cell.
void add_runs(const CubicSpan& segment, Index cell, const TriangleGrid& grid, int divisions, std::vector<Run>& runs) {
  const double nudge = 1e-9 * grid.size(cell);  // as in trace
  const Triangle p = corners(grid.mesh(), cell);
  const std::vector<double> u = split_at_lines(segment, inner_lines(p, divisions));
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    const Index place =
        by_majority(u[i], u[i + 1], [&](double at) { return place_at(segment, at, p, nudge, divisions); });
    runs.push_back({cell * divisions * divisions + place, part(segment, u[i], u[i + 1]),
                    lies_outside(p, segment.position(0.5 * (u[i] + u[i + 1])), 10.0 * nudge)});
  }
}

/// All of the outline, in the order of sub-cells.
std::vector<Run> runs_in_sub_cells(std::span<const SplineCurve> curves, const TriangleGrid& grid, int divisions) {
  const SplineCurve outline{.spans = closed_spans(curves), .knots = {}};
  std::vector<Run> runs;
  for (const Segment& s : trace(outline, grid, "outline")) {
    const CubicSpan& span = outline.spans[static_cast<std::size_t>(s.span)];
    add_runs(part(span, s.begin, s.end), s.cell, grid, divisions, runs);
  }
  std::ranges::stable_sort(runs, {}, &Run::sub_cell);
  return runs;
}

Foot nearest_corner(const Triangle& p, const Vec2& x) {
  const auto nearest = std::ranges::min_element(p, {}, [&](const Vec2& corner) { return (corner - x).squaredNorm(); });
  return {static_cast<std::size_t>(nearest - p.begin()), *nearest};
}

/// A run closed along ∂T. Beside the grid it closes by corners, which the sub-cells on both sides of its ends share.
Moments closed(const Run& run, const Triangle& p, const Vec2& centre) {
  const auto border = [&](const Vec2& end) -> Moments {
    const Vec2 x = end - centre;
    return along_border(p, run.outside ? nearest_corner(p, x) : nearest_place(p, x), x);
  };
  return along_curve(run.curve, centre) + border(run.curve.control[0]) - border(run.curve.control[3]);
}

/// Moments of a whole triangle about its centroid.
Moments whole_triangle(const Triangle& p) {
  return along_line(p[0], p[1]) + along_line(p[1], p[2]) + along_line(p[2], p[0]);
}

/// A triangle about its centroid.
Triangle centred(const Triangle& p) {
  const Vec2 centre = centroid(p);
  return {p[0] - centre, p[1] - centre, p[2] - centre};
}

/// Moments of T ∩ Ω from all runs in T.
Moments covered(const Triangle& corners, std::span<const Run> runs, const Region& region) {
  const Vec2 centre = centroid(corners);
  const Triangle p = centred(corners);
  const Moments whole = whole_triangle(p);
  Moments inside = Moments::Zero();
  Moments beside = Moments::Zero();
  for (const Run& run : runs) {
    const Moments found = closed(run, p, centre);
    if (run.outside)
      beside += found - whole * std::round(found[0] / whole[0]);
    else
      inside += found;
  }
  const double missing = missing_wholes(inside[0] / whole[0], [&] { return region.contains(centre); });
  return inside + beside + whole * missing;
}

}  // namespace

std::array<Vec2, 3> sub_cell(const TriangleGrid& grid, int divisions, Index number) {
  const Index per_cell = divisions * divisions;
  const Triangle p = corners(grid.mesh(), number / per_cell);
  const Index place = number % per_cell;
  const auto row = static_cast<Index>(std::sqrt(place));
  const Index b = (place - row * row) / 2;
  const Index c = row - b;
  const auto node = [&](Index towards_1, Index towards_2) -> Vec2 {
    return p[0] + (towards_1 * (p[1] - p[0]) + towards_2 * (p[2] - p[0])) / divisions;
  };
  const bool inverted = (place - row * row) % 2 == 1;
  if (inverted) return {node(b + 1, c), node(b, c), node(b + 1, c - 1)};
  return {node(b, c), node(b + 1, c), node(b, c + 1)};
}

TriangleMoments triangle_moments(std::span<const SplineCurve> curves, const TriangleGrid& grid, int divisions) {
  constexpr double least = 1e-13;  // of the area
  if (divisions < 1)
    throw InvalidArgument("triangle_moments: divisions must be positive, got " + std::to_string(divisions));
  const Region region(curves);
  const std::vector<Run> runs = runs_in_sub_cells(curves, grid, divisions);
  const Index per_cell = divisions * divisions;
  std::vector<Index> numbers;
  std::vector<Moments> moments;
  auto run = runs.begin();
  for (Index cell = 0; cell < grid.cells(); ++cell) {
    const Index end = (cell + 1) * per_cell;
    const bool met = run != runs.end() && run->sub_cell < end;
    if (!met && !region.contains(centroid(corners(grid.mesh(), cell)))) continue;
    for (Index number = cell * per_cell; number < end; ++number) {
      const auto first = run;
      while (run != runs.end() && run->sub_cell == number) ++run;
      const Triangle p = sub_cell(grid, divisions, number);
      const Moments found = met ? covered(p, {first, run}, region) : whole_triangle(centred(p));
      if (found[0] <= least * area_of(p)) continue;
      numbers.push_back(number);
      moments.push_back(found);
    }
  }
  TriangleMoments result{std::move(numbers), {6, static_cast<Eigen::Index>(moments.size())}};
  for (std::size_t k = 0; k < moments.size(); ++k) result.moment.col(static_cast<Eigen::Index>(k)) = moments[k];
  return result;
}

}  // namespace shoreline
