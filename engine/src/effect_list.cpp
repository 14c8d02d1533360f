#include "effect_list.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace shoreline {
namespace {

bool held_by_grid(const BoundaryPiece& b) {
  const auto* condition = std::get_if<Essential>(&b.condition);
  return condition != nullptr && condition->method == EssentialMethod::grid;
}

template <class Lines, class Second>
std::string in_two_columns(const Lines& lines, Second&& second) {
  std::size_t width = 20;
  for (const auto& line : lines) width = std::max(width, line.name.size() + 2);
  std::string text;
  for (const auto& line : lines) text += fmt::format("  {:<{}}{}\n", line.name, width, second(line));
  return text.empty() ? "  nothing\n" : text;
}

}  // namespace

void EffectList::add(bool named, const std::string& name, const std::string& needs, const std::string& why) {
  if (named)
    built.push_back({name, needs});
  else
    left_out.push_back({name, why});
}

void add_common_effects(const Case& problem, const Scene& scene, EffectList& list) {
  for (const auto& effect : scene.contributions) list.built.push_back({effect->name(), effect->needs()});
  if (std::ranges::any_of(scene.boundary, held_by_grid))
    list.built.push_back({"grid", "functions that see the edges of cells under a piece"});
  list.add(scene.fitted, "fitted_weights", "moments of the outline; an edge cut at the lines of the grid",
           "material_points.volumes is not \"fitted\"");
  list.add(problem.exact.has_value(), "errors", "the exact solution where errors are measured", "no key exact");
  list.add(!problem.probes.empty(), "probes", "the state of one point each, every step", "no key probes");
  list.add(problem.error_estimate, "error_estimate", "values at the material points; a mass matrix",
           "diagnostics.error_estimate is false");
  list.add(problem.output.strain, "strain", "three more numbers a material point", "output.fields does not list it");
  list.add(problem.output.pictures, "pictures", "results.h5, read by Python", "output.pictures is false");
}

std::string text_of(const EffectList& list) {
  return fmt::format("will run{:<14}which needs\n{}\nwill not run{:<10}because\n{}", "",
                     in_two_columns(list.built, [](const auto& line) { return line.needs; }), "",
                     in_two_columns(list.left_out, [](const auto& line) { return line.why; }));
}

}  // namespace shoreline
