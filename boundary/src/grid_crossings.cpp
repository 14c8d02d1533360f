#include "grid_crossings.hpp"

#include <algorithm>

#include "cubic.hpp"

namespace shoreline {

std::vector<double> split_at_lines(const CubicSpan& span, const Grid& grid) {
  constexpr double shortest = 1e-12;
  std::vector<double> u{0.0};
  Vec2 normal = Vec2::Zero();
  Cubic f{};
  MonotoneParts parts{};
  for (const Line& line : grid.lines_near(span.bounds())) {
    if (line.normal != normal) {  // parallel lines share the monotone parts
      normal = line.normal;
      f = coordinate(span, normal);
      parts = monotone_parts(f);
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(parts.count); ++k)
      if (passes(parts.value[k], parts.value[k + 1], line.offset))
        u.push_back(crossing(f, parts.u[k], parts.u[k + 1], line.offset));
  }
  std::ranges::sort(u);
  const auto repeated = std::ranges::unique(u, [](double kept, double next) { return next - kept < shortest; });
  u.erase(repeated.begin(), repeated.end());
  while (u.size() > 1 && 1.0 - u.back() < shortest) u.pop_back();
  u.push_back(1.0);
  return u;
}

}  // namespace shoreline
