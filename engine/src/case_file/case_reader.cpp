#include "shoreline/engine/case_reader.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "boundary_reader.hpp"
#include "keys.hpp"
#include "overrides.hpp"

namespace shoreline {
namespace {

std::string text_of(const std::filesystem::path& file) {
  const Place place{file.string(), {}};
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) place.fail("found a folder, expected a case file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) place.fail(fmt::format("cannot be read ({}), expected a case file", std::strerror(errno)));
  return {std::istreambuf_iterator<char>(stream), {}};
}

Constants read_constants(const Node& node) {
  Constants constants;
  for (const auto& [name, number] : node.value.items()) {
    const Constants one{{name, number.get<double>()}};
    node[name.c_str()].made([&one] { return Expression("0", one); });
    constants.merge(Constants(one));
  }
  return constants;
}

Case::Material read_material(const Node& node) {
  Case::Material material{.youngs_modulus = node["youngs_modulus"].as<double>(),
                          .poissons_ratio = node["poissons_ratio"].as<double>(),
                          .density = std::nullopt};
  if (node.has("density")) material.density = node["density"].as<double>();
  return material;
}

/// A value given once for both directions, or once each.
template <class T>
std::array<T, 2> pair_of(const Node& node) {
  if (node.value.is_array()) return node.as<std::array<T, 2>>();
  return {node.as<T>(), node.as<T>()};
}

/// Columns and rows that cover the grid; as doubles, which hold any number of them.
Vec2 whole_cells(const Case::Grid& grid) {
  return ((grid.upper - grid.lower).cwiseQuotient(grid.cell_size).array() - 1e-9).ceil().max(1.0);
}

Case::Grid read_grid(const Node& node) {
  constexpr double most = 1e8;
  const auto size = pair_of<double>(node["cell_size"]);
  const Case::Grid grid{node["lower"].vector(), node["upper"].vector(), {size[0], size[1]}};
  for (const Eigen::Index axis : {0, 1})
    if (grid.upper[axis] <= grid.lower[axis])
      node["upper"]
          .entry(static_cast<std::size_t>(axis))
          .place.fail(
              fmt::format("found {}, expected more than {}, the lower end", grid.upper[axis], grid.lower[axis]));
  const Vec2 cells = whole_cells(grid);
  if (!(cells.prod() <= most))
    node["cell_size"].place.fail(
        fmt::format("found {}, which makes {:.3g} x {:.3g} = {:.3g} cells, expected at most "
                    "{:g}; enlarge cell_size or shrink the grid",
                    node["cell_size"].value.dump(), cells.x(), cells.y(), cells.prod(), most));
  return grid;
}

std::vector<Case::ListedPoint> read_listed_points(const Node& node) {
  if (node["points"].size() != node["volumes"].size())
    node["volumes"].place.fail(fmt::format("found {} volumes, expected one for each of {} points",
                                           node["volumes"].size(), node["points"].size()));
  std::vector<Case::ListedPoint> points;
  for (std::size_t i = 0; i < node["points"].size(); ++i)
    points.push_back({node["points"].entry(i).vector(), node["volumes"].entry(i).as<double>()});
  return points;
}

VolumeRule read_volumes(const Node& node) {
  if (node.is("lattice")) return VolumeRule::lattice;
  return node.is("equal") ? VolumeRule::equal : VolumeRule::clipped;
}

/// Refuses a lattice of more points than a machine holds.
/// @param cells  that it may fill
void check_count(const Node& node, const std::array<int, 2>& count, double cells) {
  constexpr double most = 1e9;
  const double points = cells * count[0] * count[1];
  if (points > most)
    node.place.fail(fmt::format("found {}, up to {:.3g} points, expected at most {:g}; take fewer, or larger cells",
                                node.value.dump(), points, most));
}

Case::MaterialPoints read_material_points(const Node& node, const Case::Grid& grid) {
  if (node.has("points")) return read_listed_points(node);
  const VolumeRule volumes = read_volumes(node["volumes"]);
  if (node.has("per_cell")) {
    const auto per_cell = pair_of<int>(node["per_cell"]);
    check_count(node["per_cell"], per_cell, whole_cells(grid).prod());
    if (node["fill"].is("vertex")) return VertexFill{per_cell, false, volumes};
    return LatticeFill{per_cell, volumes};
  }
  const auto across = pair_of<int>(node["across"]);
  check_count(node["across"], across, 1.0);
  if (node["fill"].is("vertex")) return VertexFill{across, true, volumes};
  return PolarFill{node["centre"].vector(), across, volumes};
}

Case::Exact read_exact(const Node& node, const Constants& constants) {
  if (node["type"].is("plate_with_hole"))
    return PlateWithHole{node["radius"].as<double>(), node["far_field_stress"].as<double>()};
  if (node["type"].is("thick_cylinder")) {
    const auto inner = node["inner_radius"].as<double>();
    const auto outer = node["outer_radius"].as<double>();
    if (outer <= inner)
      node["outer_radius"].place.fail(fmt::format("found {}, expected more than {}, the inner radius", outer, inner));
    return ThickCylinder{inner, outer, node["pressure"].as<double>()};
  }
  const auto read = [&](const char* key, std::size_t i) { return read_expression(node[key].entry(i), constants); };
  return Case::ExactExpressions{{read("displacement", 0), read("displacement", 1)},
                                {read("stress", 0), read("stress", 1), read("stress", 2)}};
}

/// γ that the bilinear basis needs where Nitsche's method is used, so that the system stays positive definite.
double ghost_by_default(const std::vector<Case::Boundary>& boundaries) {
  const auto uses_nitsche =
      Overloaded{[](const Essential& held) { return held.method == EssentialMethod::nitsche; },
                 [](const Case::Displacement& held) { return held.support.method == EssentialMethod::nitsche; },
                 [](const auto&) { return false; }};
  for (const Case::Boundary& boundary : boundaries)
    if (std::visit(uses_nitsche, boundary.condition)) return 1e-3;
  return 0.0;
}

std::vector<Case::Probe> read_probes(const Node& node) {
  std::vector<Case::Probe> probes;
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const Node entry = node.entry(i);
    probes.push_back({entry["name"].as<std::string>(), entry["position"].vector()});
    const auto [before, is_new] = seen.emplace(probes.back().name, i);
    if (!is_new)
      entry["name"].place.fail(
          fmt::format("found \"{}\", the name of probe {} too, expected another", probes.back().name, before->second));
  }
  return probes;
}

/// A formula of t alone.
Expression read_load(const Node& node, const Constants& constants) {
  Expression load = read_expression(node, constants);
  if (load.uses_place())
    node.place.fail(fmt::format("found {}, which depends on place, expected a formula of t", described(node.value)));
  return load;
}

void read_loads(const Node& root, const Constants& constants, Case& problem) {
  if (root.has("body_force")) problem.body_force = read_pair(root["body_force"], constants);
  if (root.has("gravity")) {
    problem.gravity = root["gravity"].vector();
    if (!problem.material.density)
      root["gravity"].place.fail("found gravity, expected \"density\" in /material beside it");
  }
  if (root["analysis"].has("load")) problem.load = read_load(root["analysis"]["load"], constants);
  if (root.has("exact")) problem.exact = read_exact(root["exact"], constants);
}

void read_settings(const Node& root, Case& problem) {
  const Node analysis = root["analysis"];
  problem.plane = analysis["plane"].is("strain") ? Plane::strain : Plane::stress;
  problem.loading = analysis["loading"].is("residual") ? Loading::residual : Loading::incremental;
  problem.load_steps = analysis["load_steps"].as<int>();
  problem.threads = root["solver"]["threads"].as<int>();
  problem.condition_estimate = root["diagnostics"]["condition_estimate"].as<bool>();
  problem.output = {root["output"]["every"].as<int>(), root["output"]["pictures"].as<bool>()};
}

Case case_of(const Node& root, const std::filesystem::path& file) {
  Case problem;
  problem.file = file;
  problem.title = root.has("title") ? root["title"].as<std::string>() : file.stem().string();
  read_settings(root, problem);
  const Constants constants = read_constants(root["constants"]);
  problem.material = read_material(root["material"]);
  problem.grid = read_grid(root["grid"]);
  problem.boundaries = read_boundaries(root["boundaries"], constants, root.has("exact"));
  problem.material_points = read_material_points(root["material_points"], problem.grid);
  problem.ghost = root.has("ghost") ? root["ghost"].as<double>() : ghost_by_default(problem.boundaries);
  read_loads(root, constants, problem);
  if (root.has("probes")) problem.probes = read_probes(root["probes"]);
  if (root["tracking"].has("respace")) problem.respacing = root["tracking"]["respace"].as<double>();
  return problem;
}

}  // namespace

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return parse_case(text_of(file), file, overrides);
}

Case parse_case(const std::string& text, const std::filesystem::path& name, const std::vector<std::string>& overrides) {
  const Place whole{name.string(), {}};
  Json json = parse_json(text, whole);
  for (const std::string& assignment : overrides) override_value(json, assignment);
  keys::check(keys::case_keys(), json, name.string());
  return case_of({json, whole}, name);
}

std::string case_schema() { return keys::json_schema(keys::case_keys(), "Shoreline case").dump(2) + "\n"; }

}  // namespace shoreline
