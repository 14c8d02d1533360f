#pragma once
// The parameters at which a span crosses the lines of a grid.

#include "shoreline/bases/grid.hpp"
#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// 0 = u_0 < u_1 < … = 1 such that the span meets no line of the grid within (u_i, u_{i+1}) except by a touch or a run
/// along it.
[[nodiscard]] std::vector<double> split_at_lines(const CubicSpan& span, const Grid& grid);

}  // namespace shoreline
