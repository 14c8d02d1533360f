#include <fmt/format.h>

#include "../scene_of_body.hpp"
#include "dynamic_probes.hpp"
#include "shoreline/engine/dynamics.hpp"
#include "shoreline/engine/effects.hpp"
#include "shoreline/engine/failures.hpp"

namespace shoreline {
namespace {

std::shared_ptr<const LargeStrainMaterial> law_of(const Case::Material& material) {
  switch (material.law) {
    case Case::Law::linear_large:
      return linear_large(material.youngs_modulus, material.poissons_ratio);
    case Case::Law::neo_hookean:
      return neo_hookean(material.youngs_modulus, material.poissons_ratio);
    case Case::Law::hypoelastic:
      return hypoelastic(material.youngs_modulus, material.poissons_ratio);
    case Case::Law::linear_elastic:
      break;
  }
  throw InvalidArgument("explicit dynamics needs a law at large strain: linear_large, neo_hookean or hypoelastic");
}

void add_boundary_loads(const Case& problem, Scene& body) {
  for (std::size_t k = 0; k < body.boundary.size(); ++k) {
    const auto piece = static_cast<int>(k);
    const std::string& name = body.boundary[k].piece.name;
    std::visit(Overloaded{[](const Free&) {},
                          [&](const Traction& c) { body.contributions.push_back(traction_on(piece, name, c)); },
                          [&](const Pressure& c) { body.contributions.push_back(pressure_on(piece, name, c)); },
                          [&](const Essential& c) {
                            if (c.method != EssentialMethod::grid)
                              throw CaseError(problem.file.string(), fmt::format("/boundaries/{}/condition/method", k),
                                              "explicit dynamics holds displacements with method \"grid\" alone: the "
                                              "stiff bands of the others would rule the time step");
                          }},
               body.boundary[k].condition);
  }
}

FieldOnPoints field_of(const std::array<Expression, 2>& field) {
  return [field](const PlaceTime& at) -> Vec2 { return {field[0](at), field[1](at)}; };
}

void set_initial_velocity(const std::array<Expression, 2>& velocity, DynamicScene& scene) {
  const FieldOnPoints field = field_of(velocity);
  for (Index p = 0; p < scene.body.points.size(); ++p) {
    const Vec2 x = scene.body.points.position.col(p);
    scene.motion.velocity.col(p) = field({.x = x, .origin = x});
  }
}

}  // namespace

DynamicScene build_dynamic_scene(const Case& problem) {
  DynamicScene scene;
  scene.settings = std::get<ExplicitDynamics>(problem.analysis);
  scene.body = scene_of_body(problem, [](double) { return 1.0; });
  scene.law = law_of(problem.material);
  scene.motion = motion_at_rest(scene.body.points, problem.material.density.value());
  add_boundary_loads(problem, scene.body);
  scene.gravity = problem.gravity.value_or(Vec2::Zero());
  if (problem.gravity_field) scene.gravity_field = field_of(*problem.gravity_field);
  if (problem.body_force)
    scene.body_force = [force = *problem.body_force](const PlaceTime& at) -> Vec2 {
      return {force[0](at), force[1](at)};
    };
  if (problem.initial_velocity) set_initial_velocity(*problem.initial_velocity, scene);
  scene.history = problem.history;
  scene.body.probes = place_probes(problem, scene.body);
  for (Probe& probe : scene.body.probes) add_motion(scene, probe, 0.0, 0.0);
  return scene;
}

}  // namespace shoreline
