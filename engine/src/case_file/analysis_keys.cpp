#include "key_rows.hpp"
#include "shoreline/engine/case.hpp"

namespace shoreline::keys {
namespace {

Object explicit_dynamics() {
  const ExplicitDynamics defaults;
  return {
      {key("plane", {Choice{{"strain"}}}, otherwise("strain"), "", "plane strain; laws at large strain know no other"),
       key("time_step", {Either{{positive_number(), {Choice{{"auto"}}}}}}, otherwise("auto"), "s",
           "at most the critical step, made smaller so that whole steps reach `end_time`; `auto`: `safety` times the "
           "critical step, which is found anew as it changes"),
       key("safety", {Number{{0.0, 1.0, true}}}, optional, "", "share of the critical step with `auto`; default 0.7"),
       key("end_time", positive_number(), required, "s", "the run starts at t = 0"),
       key("mass", {Choice{{"consistent", "lumped", "partly_lumped"}}}, otherwise("lumped"), "",
           "`lumped`: the row sums of the mass matrix; `partly_lumped`: that where a function sees an empty element, "
           "else consistent"),
       key("transfer", {Either{{{Number{{0.0, 1.0}}}, {Choice{{"flip", "pic"}}}}}}, otherwise("flip"), "",
           "how velocities come back to the points: `flip` adds the acceleration, `pic` takes the projected velocity; "
           "a "
           "number: share of `pic`"),
       key("damping", {Number{{0.0, 1.0, false, true}}}, otherwise(defaults.damping), "",
           "α of local damping, a force α|F| against the velocity of each function"),
       key("leaving", {Choice{{"stop", "drop"}}}, otherwise("stop"), "",
           "what happens when a material point leaves the grid: the run ends, or goes on without the point")},
      {}};
}

std::vector<Key> elastic(const Presence& density, std::string meaning) {
  return {key("youngs_modulus", positive_number(), required, "Pa", "E"),
          key("poissons_ratio", {Number{{-1.0, 0.5, true, true}}}, required, "", "ν"),
          key("density", positive_number(), density, "kg/m³", std::move(meaning))};
}

}  // namespace

Schema analysis() {
  const Object quasi_static{
      {key("plane", {Choice{{"strain", "stress"}}}, required, "", "plane strain or plane stress"),
       key("load_steps", {Integer{1, 1000000}}, otherwise(QuasiStatic{}.load_steps), "",
           "equal steps N; t = k/N at the end of step k"),
       key("load", {Formula{}}, optional, "",
           "load factor, an expression of t by which plain numbers ramp; default t itself"),
       key("loading", {Choice{{"residual", "incremental"}}}, otherwise("residual"), "",
           "what a step balances: the whole load less what is carried already, or the increment of load alone"),
       key("geometry", {Choice{{"updated", "initial"}}}, otherwise("updated"), "",
           "where the body is when a step evaluates functions, loads and edges: where the step before has moved it, or "
           "where it was at the start. With `initial` all steps share one stiffness and one factorisation")},
      {}};
  const Object projection{
      {key("value", {Formula{}}, optional, "", "what is projected, an expression of x and y"),
       key("data", list(any_number(), 1, many), optional, "",
           "what is projected, one number for each of the listed `material_points.points`"),
       key("gradient", several(2, {Formula{}}), optional, "1/m",
           "∂/∂x and ∂/∂y of `value`, for the errors of the projection's derivatives"),
       key("mass", {Choice{{"consistent", "lumped"}}}, otherwise("consistent"), "",
           "`consistent`: the best approximation; `lumped`: means of the values, which stay within their extremes")},
      {"value", "data"}};
  return {
      Tagged{{{"quasi_static", quasi_static}, {"explicit_dynamics", explicit_dynamics()}, {"projection", projection}}}};
}

Schema small_strain_material() {
  Object law{elastic(optional, "ρ; needed by `gravity`"), {}};
  law.keys.push_back(key("dilatation", {Choice{{"plain", "projected"}}}, otherwise("plain"), "",
                         "`projected`: the change of volume is projected onto few polynomials on groups of cells, "
                         "without which nearly incompressible bodies (ν near ½) are too stiff; plane strain"));
  return {Tagged{{{"linear_elastic", law}}}};
}

Schema large_strain_material() {
  const Object law{elastic(required, "ρ at the start"), {}};
  return {Tagged{{{"linear_large", law}, {"neo_hookean", law}, {"hypoelastic", law}}}};
}

}  // namespace shoreline::keys
