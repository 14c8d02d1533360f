#pragma once
// The parameters at which a span crosses the lines of a grid, or any lines.

#include <span>

#include "shoreline/bases/grid.hpp"
#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// 0 = u_0 < u_1 < … = 1 such that the span meets no line of the grid within (u_i, u_{i+1}) except by a touch or a run
/// along it.
[[nodiscard]] std::vector<double> split_at_lines(const CubicSpan& span, const Grid& grid);

/// The same for given lines.
[[nodiscard]] std::vector<double> split_at_lines(const CubicSpan& span, std::span<const Line> lines);

/// What @p at gives at two of three places between two crossings, one of which may touch a line; else in the middle.
template <class At>
[[nodiscard]] auto by_majority(double begin, double end, At&& at) {
  const auto between = [&](double share) { return at(begin + share * (end - begin)); };
  const auto middle = between(0.5);
  const auto before = between(0.3);
  if (middle == before) return middle;
  return before == between(0.7) ? before : middle;
}

}  // namespace shoreline
