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

Case::MaterialPoints read_material_points(const Node& node, const Case::Grid& grid) {
  constexpr double most = 1e9;
  if (node.has("points")) return read_listed_points(node);
  const auto per_cell = pair_of<int>(node["per_cell"]);
  const double points = whole_cells(grid).prod() * per_cell[0] * per_cell[1];
  if (points > most)
    node["per_cell"].place.fail(
        fmt::format("found {}, up to {:.3g} points on this grid, expected at most {:g}; take "
                    "fewer a cell or larger cells",
                    node["per_cell"].value.dump(), points, most));
  const bool clipped = node["volumes"].is("clipped");
  if (node["fill"].is("vertex")) return Case::VertexFill{per_cell, clipped};
  return Case::LatticeFill{per_cell, clipped ? VolumeRule::clipped : VolumeRule::lattice};
}

Case::Exact read_exact(const Node& node, const Constants& constants) {
  const auto read = [&](const char* key, std::size_t i) { return read_expression(node[key].entry(i), constants); };
  return {{read("displacement", 0), read("displacement", 1)},
          {read("stress", 0), read("stress", 1), read("stress", 2)}};
}

/// γ that the bilinear basis needs where Nitsche's method is used, so that the system stays positive definite.
double ghost_by_default(const std::vector<Case::Boundary>& boundaries) {
  for (const Case::Boundary& boundary : boundaries) {
    const auto* essential = std::get_if<Essential>(&boundary.condition);
    if (essential != nullptr && essential->method == EssentialMethod::nitsche) return 1e-3;
  }
  return 0.0;
}

void read_loads(const Node& root, const Constants& constants, Case& problem) {
  if (root.has("body_force")) {
    const Node force = root["body_force"];
    problem.body_force.emplace(
        std::array{read_quantity(force.entry(0), constants), read_quantity(force.entry(1), constants)});
  }
  if (root.has("gravity")) {
    problem.gravity = root["gravity"].vector();
    if (!problem.material.density)
      root["gravity"].place.fail("found gravity, expected \"density\" in /material beside it");
  }
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
  problem.boundaries = read_boundaries(root["boundaries"], constants);
  problem.material_points = read_material_points(root["material_points"], problem.grid);
  problem.ghost = root.has("ghost") ? root["ghost"].as<double>() : ghost_by_default(problem.boundaries);
  read_loads(root, constants, problem);
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
