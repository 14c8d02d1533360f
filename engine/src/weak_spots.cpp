#include "weak_spots.hpp"

#include <algorithm>
#include <map>

namespace shoreline {
namespace {

std::optional<Diagnostics::Cut> smallest_cut(const StepState& step) {
  const std::vector<CutFraction> cuts = cut_fractions(step);
  if (cuts.empty()) return std::nullopt;
  const CutFraction& least = *std::ranges::min_element(cuts, {}, &CutFraction::fraction);
  return Diagnostics::Cut{least.fraction, least.element, element_centre(step.basis.grid(), least.element)};
}

std::optional<Diagnostics::Pivot> smallest_pivot(const StepState& step, const StepSystem& system) {
  if (system.assembler.equations() == 0) return std::nullopt;
  const Index unknown = system.assembler.unknown(system.solver.smallest_pivot_equation());
  return Diagnostics::Pivot{system.solver.smallest_pivot(), step.basis.control_point(unknown / 2), unknown % 2};
}

/// Material points of each element that holds any.
std::map<Index, std::vector<Index>> points_by_element(const StepState& step) {
  std::map<Index, std::vector<Index>> points;
  for (std::size_t c = 0; c < step.supports.cell.size(); ++c) {
    std::vector<Index>& of_element = points[step.supports.cell[c] / step.basis.grid().parts()];
    for (auto k = step.supports.first[c]; k < step.supports.first[c + 1]; ++k)
      of_element.push_back(step.supports.point[static_cast<std::size_t>(k)]);
  }
  return points;
}

/// Points that alone see two functions or more: three strains cannot hold the four components, (L.6).
void find_stray_points(const StepState& step, const std::map<Index, std::vector<Index>>& points, Diagnostics& found) {
  const int parts = step.basis.grid().parts();
  std::vector<Index> seen(static_cast<std::size_t>(step.basis.functions()), 0);  // by so many points
  for (const auto& [element, of_element] : points)
    for (const Index f : step.basis.functions_of(element * parts))
      seen[static_cast<std::size_t>(f)] += static_cast<Index>(of_element.size());
  for (const auto& [element, of_element] : points) {
    if (of_element.size() > 1) continue;
    const ShortIndices functions = step.basis.functions_of(element * parts);
    const auto alone =
        std::ranges::count_if(functions, [&](Index f) { return seen[static_cast<std::size_t>(f)] == 1; });
    if (alone < 2) continue;
    if (++found.stray_points == 1) found.first_stray = step.points.position.col(of_element[0]);
  }
}

}  // namespace

std::vector<CutFraction> cut_fractions(const StepState& step) {
  std::vector<SplineCurve> curves;
  for (const Edge& edge : step.edges) curves.push_back(edge.curve);
  if (curves.empty()) return {};
  return cut_fractions(curves, step.basis.grid());
}

Diagnostics weak_spots(const StepState& step, const StepSystem& system) {
  Diagnostics found{.smallest_cut = smallest_cut(step), .smallest_pivot = smallest_pivot(step, system)};
  const std::map<Index, std::vector<Index>> points = points_by_element(step);
  find_stray_points(step, points, found);
  const auto size = [](const auto& entry) { return entry.second.size(); };
  found.fewest_points = static_cast<Index>(size(*std::ranges::min_element(points, {}, size)));
  return found;
}

}  // namespace shoreline
