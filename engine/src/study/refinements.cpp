#include "refinements.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case_file/keys.hpp"
#include "shoreline/engine/case_reader.hpp"

namespace shoreline {
namespace {

std::string assignment(const std::string& path, const Json& value) { return path + "=" + value.dump(); }

/// A number or each of a list, multiplied.
template <class Number>
Json scaled(const Json& value, Number factor) {
  if (value.is_number()) return value.get<Number>() * factor;
  Json list = Json::array();
  for (const Json& entry : value) list.push_back(scaled(entry, factor));
  return list;
}

void add(std::vector<Refinement>& all, const std::string& part, std::vector<std::string> settings) {
  if (!settings.empty()) all.push_back({part, std::move(settings)});
}

std::vector<std::string> finer_grid(const Json& json) {
  if (!json["grid"].contains("cell_size")) return {};
  return {assignment("grid.cell_size", scaled(json["grid"]["cell_size"], 0.5))};
}

std::vector<std::string> more_points(const Json& json) {
  const Json points = json.value("material_points", Json::object());
  const bool random = points.value("fill", Json()) == "random";
  for (const std::string key : {"per_cell", "per_block", "across"})
    if (points.contains(key)) return {assignment("material_points." + key, scaled(points[key], random ? 4L : 2L))};
  return {};
}

/// Twice as many spans on every arc and circle.
std::vector<std::string> more_tracking_points(const Json& json) {
  std::vector<std::string> settings;
  const Json boundaries = json.value("boundaries", Json::array());
  for (std::size_t b = 0; b < boundaries.size(); ++b)
    for (const std::string form : {"arc", "circle"})
      if (boundaries[b].contains(form)) {
        const long points = boundaries[b][form]["points"];
        settings.push_back(
            assignment(fmt::format("boundaries.{}.{}.points", b, form), form == "arc" ? 2 * points - 1 : 2 * points));
      }
  return settings;
}

/// How a piece is held; null where it is not.
const Essential* support_of(const Case::Boundary& boundary) {
  if (const auto* displacement = std::get_if<Case::Displacement>(&boundary.condition)) return &displacement->support;
  return std::get_if<Essential>(&boundary.condition);
}

bool held_on_grid_lines(const Case::Boundary& boundary) {
  const Essential* held = support_of(boundary);
  return held != nullptr && held->method == EssentialMethod::grid;
}

std::vector<std::string> narrower_bands(const Case& problem) {
  std::vector<std::string> settings;
  for (std::size_t b = 0; b < problem.boundaries.size(); ++b)
    if (const Essential* held = support_of(problem.boundaries[b]);
        held != nullptr && held->method != EssentialMethod::grid)
      settings.push_back(assignment(fmt::format("boundaries.{}.condition.band", b), 0.1 * held->band));
  return settings;
}

std::vector<std::string> smaller_steps(const Case& problem) {
  if (const auto* steps = std::get_if<QuasiStatic>(&problem.analysis))
    return {assignment("analysis.load_steps", 2 * steps->load_steps)};
  const auto* dynamics = std::get_if<ExplicitDynamics>(&problem.analysis);
  if (dynamics == nullptr) return {};
  if (dynamics->time_step) return {assignment("analysis.time_step", 0.5 * *dynamics->time_step)};
  return {assignment("analysis.safety", 0.5 * dynamics->safety)};
}

}  // namespace

std::vector<Refinement> refinements_of(const Json& json) {
  Json complete = json;
  keys::check(keys::case_keys(), complete, "case");  // fills in what the case leaves to its defaults
  const Case problem = parse_case(json.dump(), "case", {});
  std::vector<Refinement> all;
  add(all, "grid", finer_grid(complete));
  add(all, "points", more_points(complete));
  add(all, "boundary points", more_tracking_points(complete));
  add(all, "band", narrower_bands(problem));
  add(all, "time step", smaller_steps(problem));
  return all;
}

std::vector<std::string> shifted_grid(const Json& json) {
  const Json& grid = json["grid"];
  if (!grid.contains("cell_size") ||
      std::ranges::any_of(parse_case(json.dump(), "case").boundaries, held_on_grid_lines))
    return {};
  const auto size = [&](std::size_t axis) {
    const Json& cell = grid["cell_size"];
    return (cell.is_number() ? cell : cell[axis]).get<double>();
  };
  const Json lower{grid["lower"][0].get<double>() - 0.37 * size(0), grid["lower"][1].get<double>() - 0.21 * size(1)};
  return {assignment("grid.lower", lower)};
}

}  // namespace shoreline
