#include "shoreline/engine/case_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boundary_reader.hpp"
#include "dynamics_reader.hpp"
#include "grid_reader.hpp"
#include "keys.hpp"
#include "overrides.hpp"
#include "point_reader.hpp"
#include "shoreline/engine/defaults.hpp"
#include "text_file.hpp"

namespace shoreline {
namespace {

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
  Case::Material material{.law = Case::Law::linear_elastic,
                          .youngs_modulus = node["youngs_modulus"].as<double>(),
                          .poissons_ratio = node["poissons_ratio"].as<double>(),
                          .density = std::nullopt,
                          .projected_dilatation = node["dilatation"].is("projected")};
  if (node.has("density")) material.density = node["density"].as<double>();
  return material;
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

/// How a piece is held; none that is not.
std::optional<EssentialMethod> method_of(const Case::Boundary& boundary) {
  using Method = std::optional<EssentialMethod>;
  return std::visit(Overloaded{[](const Essential& held) { return Method(held.method); },
                               [](const Case::Displacement& held) { return Method(held.support.method); },
                               [](const auto&) { return Method(); }},
                    boundary.condition);
}

/// γ of the basis where the system needs it to stay positive definite: for Nitsche's method, and for smooth bases,
/// whose functions reach so far over the edge of the body that some are all but unsupported, unless the body is held
/// on grid lines all around.
double ghost_by_default(const std::vector<Case::Boundary>& boundaries, const Case::Grid& grid) {
  const bool smooth =
      grid.basis == Case::BasisType::powell_sabin || (grid.basis == Case::BasisType::bspline && grid.degree > 1);
  const bool needed = std::ranges::any_of(boundaries, [&](const Case::Boundary& boundary) {
    const auto method = method_of(boundary);
    return smooth ? method != EssentialMethod::grid : method == EssentialMethod::nitsche;
  });
  return needed ? ghost_for_nitsche(grid.basis, grid.degree) : 0.0;
}

/// A formula of t alone.
Expression read_load(const Node& node, const Constants& constants) {
  Expression load = read_expression(node, constants);
  if (load.uses_place())
    node.place.fail(fmt::format("found {}, which depends on place, expected a formula of t", described(node.value)));
  return load;
}

QuasiStatic read_quasi_static(const Node& node, const Constants& constants) {
  QuasiStatic analysis{
      .loading = node["loading"].is("residual") ? Loading::residual : Loading::incremental,
      .load_steps = node["load_steps"].as<int>(),
      .geometry = node["geometry"].is("updated") ? Geometry::updated : Geometry::initial,
  };
  if (node.has("load")) analysis.load = read_load(node["load"], constants);
  return analysis;
}

/// Refuses what a projection cannot use of what stands beside it.
void check_projection(const Node& root) {
  const Node analysis = root["analysis"];
  const bool fill = root.has("material_points") && !root["material_points"].has("points");
  if (fill && !root.has("boundaries"))
    root["material_points"].place.fail("found a fill, expected the key \"boundaries\" beside it, the outline to fill");
  if (!fill && root.has("boundaries"))
    root["boundaries"].place.fail("found boundaries, expected none without a fill of \"material_points\"");
  if (root.has("boundaries"))
    for (std::size_t i = 0; i < root["boundaries"].size(); ++i)
      if (const Node piece = root["boundaries"].entry(i); piece.has("condition"))
        piece["condition"].place.fail("found a condition, expected none: a projection knows the outline alone");
  if (!analysis.has("data")) return;
  if (analysis.has("gradient"))
    analysis["gradient"].place.fail("found a gradient, expected none beside \"data\"; it goes with \"value\"");
  const std::size_t points = fill || !root.has("material_points") ? 0 : root["material_points"]["points"].size();
  if (analysis["data"].size() != points)
    analysis["data"].place.fail(
        fmt::format("found {} numbers, expected one for each of {} listed points of "
                    "\"material_points\"",
                    analysis["data"].size(), points));
}

Projection read_projection(const Node& root, const Constants& constants) {
  check_projection(root);
  const Node analysis = root["analysis"];
  const auto read = [&](const Node& node) {
    Expression expression = read_expression(node, constants);
    if (expression.uses_time())
      node.place.fail(
          fmt::format("found {}, which depends on t, expected a formula of x and y", described(node.value)));
    return expression;
  };
  Projection projection{.value = std::vector<double>{},
                        .mass = analysis["mass"].is("lumped") ? Mass::lumped : Mass::consistent,
                        .at_points = root.has("material_points")};
  if (analysis.has("data"))
    projection.value = analysis["data"].as<std::vector<double>>();
  else
    projection.value = read(analysis["value"]);
  if (analysis.has("gradient")) {
    const Node gradient = analysis["gradient"];
    projection.gradient = {read(gradient.entry(0)), read(gradient.entry(1))};
  }
  return projection;
}

void read_loads(const Node& root, const Constants& constants, Case& problem) {
  if (root.has("body_force")) problem.body_force = read_pair(root["body_force"], constants);
  if (root.has("gravity")) {
    problem.gravity = root["gravity"].vector();
    if (!problem.material.density)
      root["gravity"].place.fail("found gravity, expected \"density\" in /material beside it");
  }
  if (root.has("exact")) problem.exact = read_exact(root["exact"], constants);
  if (root.has("samples")) {
    if (!problem.exact)
      root["samples"].place.fail(
          "found sample points, expected the key \"exact\" beside it, whose errors they measure");
    problem.samples = root["samples"].as<int>();
  }
}

/// Multigrid has no pivots for those who ask.
SolverType read_solver(const Node& root) {
  SolverType solver = SolverType::automatic;
  for (const SolverType type : {SolverType::band, SolverType::cholmod, SolverType::multigrid})
    if (root["solver"]["type"].is(name_of(type).c_str())) solver = type;
  if (solver != SolverType::multigrid) return solver;
  for (const char* diagnostic : {"condition_estimate", "cut_fractions"})
    if (const Node asked = root["diagnostics"][diagnostic]; asked.as<bool>())
      asked.place.fail(
          "found true, expected false with \"multigrid\" in /solver/type: it needs the factors of another method");
  return solver;
}

/// What load steps need beside grid, outline and points.
void read_load_steps(const Node& root, const Constants& constants, Case& problem) {
  problem.plane = root["analysis"]["plane"].is("strain") ? Plane::strain : Plane::stress;
  problem.analysis = read_quasi_static(root["analysis"], constants);
  problem.material = read_material(root["material"]);
  if (problem.material.projected_dilatation && problem.plane == Plane::stress)
    root["material"]["dilatation"].place.fail(
        "found \"projected\", expected \"plain\" in plane stress, where the thickness gives way and no volume is kept");
  problem.ghost = root.has("ghost") ? root["ghost"].as<double>() : ghost_by_default(problem.boundaries, problem.grid);
  read_loads(root, constants, problem);
  if (root.has("probes")) problem.probes = read_probes(root["probes"]);
  if (root["tracking"].has("respace")) {
    if (root["analysis"]["geometry"].is("initial"))
      root["tracking"]["respace"].place.fail(
          "found a ratio, expected none with analysis.geometry \"initial\": no step computes with the moved curve");
    problem.respacing = root["tracking"]["respace"].as<double>();
  }
  problem.condition_estimate = root["diagnostics"]["condition_estimate"].as<bool>();
  problem.cut_fractions = root["diagnostics"]["cut_fractions"].as<bool>();
  problem.strain_energy = root["diagnostics"]["strain_energy"].as<bool>();
  problem.error_estimate = root["diagnostics"]["error_estimate"].as<bool>();
  problem.output.every = root["output"]["every"].as<int>();
  problem.solver = read_solver(root);
}

Case case_of(const Node& root, const std::filesystem::path& file) {
  Case problem;
  problem.file = file;
  problem.title = root.has("title") ? root["title"].as<std::string>() : file.stem().string();
  problem.threads = root["solver"]["threads"].as<int>();
  problem.output.pictures = root["output"]["pictures"].as<bool>();
  if (root["output"].has("fields")) problem.output.strain = root["output"]["fields"].size() > 0;
  const Constants constants = read_constants(root["constants"]);
  problem.grid = read_grid(root["grid"], file.parent_path());
  if (root.has("boundaries"))
    problem.boundaries =
        read_boundaries(root["boundaries"], {constants, root.has("exact"), nitsche_band(problem.grid.basis)});
  if (root.has("material_points")) {
    problem.material_points = read_material_points(root["material_points"], problem.grid);
    problem.fitted = root["material_points"]["volumes"].is("fitted");
  }
  if (root["analysis"]["type"].is("projection")) {
    if (problem.fitted)
      root["material_points"]["volumes"].place.fail(
          "found \"fitted\", expected another rule: a projection takes the points with their own volumes");
    problem.analysis = read_projection(root, constants);
  } else if (root["analysis"]["type"].is("explicit_dynamics"))
    read_dynamics(root, constants, problem);
  else
    read_load_steps(root, constants, problem);
  return problem;
}

}  // namespace

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return parse_case(text_of(file, "a case file"), file, overrides);
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
