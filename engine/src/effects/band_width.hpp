#pragma once
// How wide the band of an essential condition is along its edge.

#include <algorithm>
#include <map>

#include "shoreline/boundary/conditions.hpp"
#include "shoreline/engine/contribution.hpp"
#include "shoreline/engine/material.hpp"

namespace shoreline {

/// Volume of the material points of a cell [m²].
[[nodiscard]] inline double volume_in(const StepState& step, Index cell) {
  const auto& cells = step.supports.cell;
  const auto found = std::ranges::lower_bound(cells, cell);
  if (found == cells.end() || *found != cell) return 0.0;
  const auto c = static_cast<std::size_t>(found - cells.begin());
  double volume = 0.0;
  for (Index k = step.supports.first[c]; k < step.supports.first[c + 1]; ++k)
    volume += step.points.volume[step.supports.point[static_cast<std::size_t>(k)]];
  return volume;
}

/// δ of each segment of an edge [m]. On bases whose gradients jump a condition that narrows has no more than
///
///     δ/h = ⅔ (γ E/C_nn + ℓ/h),  ℓ the volume in the segment's cell over the length of the edge there, (D.10),
///
/// half of what a straight layer bears, as two pieces may share the cell.
///
/// @param gamma  γ of the ghost penalty
[[nodiscard]] inline std::vector<double> band_widths(const StepState& step, const Edge& edge,
                                                     const Essential& condition, const Material& material,
                                                     double gamma) {
  constexpr double narrowest = 1e-6;  // of a cell
  std::vector<double> widths;
  for (const Segment& segment : edge.segments) widths.push_back(condition.band * step.basis.grid().size(segment.cell));
  if (!condition.narrows || step.basis.continuity() > 0) return widths;

  std::map<Index, double> length;
  for (std::size_t k = 0; k < edge.points.size(); ++k)
    length[edge.support_cell[edge.segment_of(k)]] += edge.points[k].weight;
  const double penalty = gamma * material.stiffness() / material.tangent(Stress::Zero())(0, 0);
  for (std::size_t s = 0; s < widths.size(); ++s) {
    const Index cell = edge.support_cell[s];
    const double h = step.basis.grid().size(cell);
    const double bearable = 2.0 / 3.0 * (penalty * h + volume_in(step, cell) / length[cell]);
    widths[s] = std::min(widths[s], std::max(bearable, narrowest * h));
  }
  return widths;
}

}  // namespace shoreline
