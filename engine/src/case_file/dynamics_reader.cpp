#include "dynamics_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "json_text.hpp"

namespace shoreline {
namespace {

constexpr double most_steps = 1e9;

MassForm read_mass(const Node& node) {
  if (node.is("consistent")) return MassForm::consistent;
  return node.is("lumped") ? MassForm::lumped : MassForm::partly_lumped;
}

double read_transfer(const Node& node) {
  if (node.value.is_number()) return node.as<double>();
  return node.is("pic") ? 1.0 : 0.0;
}

ExplicitDynamics read_settings(const Node& node) {
  ExplicitDynamics settings;
  settings.end_time = node["end_time"].as<double>();
  settings.mass = read_mass(node["mass"]);
  settings.pic = read_transfer(node["transfer"]);
  settings.damping = node["damping"].as<double>();
  settings.drop_outside = node["leaving"].is("drop");
  if (node["time_step"].value.is_number()) settings.time_step = node["time_step"].as<double>();
  if (node.has("safety")) {
    if (settings.time_step)
      node["safety"].place.fail("found a safety factor beside a time step, expected it with \"time_step\": \"auto\"");
    settings.safety = node["safety"].as<double>();
  }
  if (settings.time_step && settings.end_time / *settings.time_step > most_steps)
    node["time_step"].place.fail(
        fmt::format("found {:g} s, which makes {:.3g} steps to the end time, expected at most "
                    "{:g}",
                    *settings.time_step, settings.end_time / *settings.time_step, most_steps));
  return settings;
}

double read_ghost(const Node& root, MassForm mass) {
  const auto gamma = root["ghost"].as<double>();
  if (gamma > 0.0 && mass != MassForm::consistent)
    root["ghost"].place.fail(fmt::format(
        "found {:g} beside a {} mass, expected 0: the rows of a ghost mass sum to zero, so lumping erases it; take "
        "\"mass\": \"consistent\", or no ghost mass",
        gamma, name_of(mass)));
  return gamma;
}

Case::Law read_law(const Node& node) {
  if (node.is("linear_large")) return Case::Law::linear_large;
  return node.is("neo_hookean") ? Case::Law::neo_hookean : Case::Law::hypoelastic;
}

std::array<Expression, 2> read_field(const Node& node, const Constants& constants) {
  return {read_expression(node.entry(0), constants), read_expression(node.entry(1), constants)};
}

void read_gravity(const Node& node, const Constants& constants, Case& problem) {
  const bool numbers = node.value[0].is_number() && node.value[1].is_number();
  if (numbers)
    problem.gravity = node.vector();
  else
    problem.gravity_field = read_field(node, constants);
}

Case::Exact read_exact(const Node& root, const Constants& constants, const Case& problem) {
  const Node node = root["exact"];
  const auto read = [&](const char* key, std::size_t i) { return read_expression(node[key].entry(i), constants); };
  if (node["type"].is("expressions"))
    return Case::ExactExpressions{{read("displacement", 0), read("displacement", 1)},
                                  {read("stress", 0), read("stress", 1), read("stress", 2)}};
  if (!problem.gravity || problem.gravity->x() != 0.0)
    node["type"].place.fail(
        "found a column under its own weight, expected \"gravity\" beside it: two numbers, the first 0");
  if (problem.material.law != Case::Law::linear_large)
    root["material"]["type"].place.fail(
        fmt::format("found {}, expected \"linear_large\", for which the exact solution "
                    "\"self_weight_column\" holds",
                    described(root["material"]["type"].value)));
  return SelfWeightColumn{node["height"].as<double>(), *problem.material.density, -problem.gravity->y()};
}

}  // namespace

void read_dynamics(const Node& root, const Constants& constants, Case& problem) {
  const Node material = root["material"];
  problem.plane = Plane::strain;
  ExplicitDynamics settings = read_settings(root["analysis"]);
  settings.ghost = read_ghost(root, settings.mass);
  problem.analysis = settings;
  auto* lattice = std::get_if<LatticeFill>(&problem.material_points);
  if (lattice != nullptr && lattice->volumes == VolumeRule::fitted)
    lattice->volumes = VolumeRule::clipped;  // more points in cut cells would have next to no mass
  problem.material = {.law = read_law(material["type"]),
                      .youngs_modulus = material["youngs_modulus"].as<double>(),
                      .poissons_ratio = material["poissons_ratio"].as<double>(),
                      .density = material["density"].as<double>(),
                      .projected_dilatation = false};
  if (root.has("body_force")) problem.body_force = read_pair(root["body_force"], constants);
  if (root.has("gravity")) read_gravity(root["gravity"], constants, problem);
  if (root.has("initial_velocity")) problem.initial_velocity = read_field(root["initial_velocity"], constants);
  if (root.has("exact")) problem.exact = read_exact(root, constants, problem);
  if (root.has("history")) problem.history = root["history"]["every"].as<int>();
  if (root.has("probes")) problem.probes = read_probes(root["probes"]);
  problem.error_estimate = root["diagnostics"]["error_estimate"].as<bool>();
  problem.output.every = root["output"].has("every") ? root["output"]["every"].as<int>() : 0;
}

}  // namespace shoreline
