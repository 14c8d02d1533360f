#include "grid_crossings.hpp"

#include <algorithm>

#include "cubic.hpp"

namespace shoreline {
namespace {

double area_of(const Box& box) { return (box.upper - box.lower).prod(); }

void add_crossings(const CubicSpan& span, double begin, double end, std::span<const Line> lines,
                   std::vector<double>& u) {
  Vec2 normal = Vec2::Zero();
  Cubic f{};
  MonotoneParts parts{};
  for (const Line& line : lines) {
    if (line.normal != normal) {  // parallel lines share the monotone parts
      normal = line.normal;
      f = coordinate(span, normal);
      parts = monotone_parts(f, begin, end);
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(parts.count); ++k)
      if (passes(parts.value[k], parts.value[k + 1], line.offset))
        u.push_back(crossing(f, parts.u[k], parts.u[k + 1], line.offset));
  }
}

/// Crossings on a part of a span, found in halves as long as these have smaller boxes: the box of a long span holds
/// many lines that the span never meets.
void add_crossings_of_grid(const CubicSpan& span, double begin, double end, const Grid& grid, std::vector<double>& u) {
  constexpr double few_cells = 8.0;
  constexpr std::size_t few_lines = 32;
  constexpr double shortest = 1e-3;
  const double middle = 0.5 * (begin + end);
  const auto box_of = [&](double from, double to) { return part(span, from, to).bounds(); };
  const auto halve = [&] {
    add_crossings_of_grid(span, begin, middle, grid, u);
    add_crossings_of_grid(span, middle, end, grid, u);
  };
  const Box box = box_of(begin, end);
  const double area = area_of(box);
  const bool worthwhile =
      end - begin > shortest && area_of(box_of(begin, middle)) + area_of(box_of(middle, end)) < 0.8 * area;
  const double mean_cell = area_of(grid.bounds()) / grid.cells();
  if (worthwhile && area > few_cells * mean_cell) return halve();
  const std::vector<Line> lines = grid.lines_near(box);
  if (worthwhile && lines.size() > few_lines) return halve();
  add_crossings(span, begin, end, lines, u);
}

/// Sorts crossings and closes the list with the ends of the span.
std::vector<double> cuts(std::vector<double> u) {
  constexpr double shortest = 1e-12;
  u.push_back(0.0);
  std::ranges::sort(u);
  const auto repeated = std::ranges::unique(u, [](double kept, double next) { return next - kept < shortest; });
  u.erase(repeated.begin(), repeated.end());
  while (u.size() > 1 && 1.0 - u.back() < shortest) u.pop_back();
  u.push_back(1.0);
  return u;
}

}  // namespace

std::vector<double> split_at_lines(const CubicSpan& span, const Grid& grid) {
  if (grid.lines_run_through()) return split_at_lines(span, grid.lines_near(span.bounds()));
  std::vector<double> u;
  add_crossings_of_grid(span, 0.0, 1.0, grid, u);
  return cuts(std::move(u));
}

std::vector<double> split_at_lines(const CubicSpan& span, std::span<const Line> lines) {
  std::vector<double> u;
  add_crossings(span, 0.0, 1.0, lines, u);
  return cuts(std::move(u));
}

}  // namespace shoreline
