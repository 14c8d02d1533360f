#include "shoreline/engine/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "body.hpp"
#include "body_boundary.hpp"
#include "conditions_on_piece.hpp"
#include "sample_points.hpp"
#include "scene_of_body.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/engine/effects.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/fill.hpp"
#include "shoreline/engine/linear_elastic.hpp"

namespace shoreline {
namespace {

void add_boundary_effects(Scene& scene, const std::shared_ptr<const Material>& law, double gamma) {
  for (std::size_t k = 0; k < scene.boundary.size(); ++k) {
    const auto piece = static_cast<int>(k);
    const std::string& name = scene.boundary[k].piece.name;
    auto& effects = scene.contributions;
    std::visit(
        Overloaded{[](const Free&) {}, [&](const Traction& c) { effects.push_back(traction_on(piece, name, c)); },
                   [&](const Pressure& c) { effects.push_back(pressure_on(piece, name, c)); },
                   [&](const Essential& c) {
                     if (c.method != EssentialMethod::grid) effects.push_back(essential_on(piece, name, c, law, gamma));
                     if (scene.exact)
                       effects.push_back(boundary_error(piece, name, c.normal_only,
                                                        exact_displacement(scene.boundary[k].original, *scene.exact)));
                   }},
        scene.boundary[k].condition);
  }
}

/// Body force and weight of a case [N/m³]; plain numbers, and so gravity, ramp with the load factor.
std::function<Vec2(const PlaceTime&)> force_per_volume(const Case& problem, LoadFactor factor) {
  const Vec2 weight = problem.gravity.value_or(Vec2::Zero()) * problem.material.density.value_or(0.0);
  return [value = problem.body_force, weight, ramp = std::move(factor)](PlaceTime at) -> Vec2 {
    at.factor = ramp(at.t);
    const Vec2 force = weight * at.factor;
    return value ? Vec2(force + Vec2((*value)[0](at), (*value)[1](at))) : force;
  };
}

/// The law that contributions see: without λ, where that part is projected; E/(1 + ν) and 0 have the same μ.
std::shared_ptr<const Material> law_of_contributions(const Case& problem, Scene& scene) {
  if (!problem.material.projected_dilatation) return scene.material;
  scene.projected = {macro_elements(*scene.basis), scene.material->tangent(Stress::Zero())(0, 1)};
  const double twice_mu = problem.material.youngs_modulus / (1.0 + problem.material.poissons_ratio);
  return std::make_shared<LinearElastic>(twice_mu, 0.0, problem.plane);
}

LoadFactor load_factor(const QuasiStatic& analysis) {
  if (!analysis.load) return [](double t) { return t; };
  return [load = *analysis.load](double t) { return load({.t = t}); };
}

/// Refuses pieces with method grid that do not lie on grid lines, before anything is computed.
void check_grid_pieces(const Case& problem, const Scene& scene, const Basis& basis) {
  const QuadratureRule rule = gauss(2);
  std::vector<Edge> edges;
  for (const BoundaryPiece& b : scene.boundary) {
    Edge edge{.curve = fit_spline(b.piece), .points_per_segment = static_cast<int>(rule.point.size())};
    edge.segments = trace(edge.curve, basis.grid(), b.piece.name);
    edge.points = boundary_points(edge.curve, edge.segments, rule);
    edges.push_back(std::move(edge));
  }
  try {
    static_cast<void>(grid_constraints(basis, scene.boundary, edges, Eigen::Matrix2Xd(2, 0)));
  } catch (const InvalidArgument& error) {
    throw CaseError(problem.file.string(), "/boundaries", error.what());
  }
}

ExactSolution by_expressions(const Case::ExactExpressions& exact) {
  return {.displacement = [u = exact.displacement](const Vec2& origin, double t) -> Vec2 {
            const PlaceTime at{.x = origin, .origin = origin, .t = t};
            return {u[0](at), u[1](at)};
          },
          .stress = [s = exact.stress](const Vec2& origin, double t) -> Vec3 {
            const PlaceTime at{.x = origin, .origin = origin, .t = t};
            return {s[0](at), s[1](at), s[2](at)};
          }};
}

ExactSolution to_solution(const Case& problem, const LoadFactor& factor) {
  const ElasticConstants material{problem.material.youngs_modulus, problem.material.poissons_ratio, problem.plane};
  return std::visit(Overloaded{[](const Case::ExactExpressions& exact) { return by_expressions(exact); },
                               [&](const SelfWeightColumn& column) { return exact_solution(column, material); },
                               [&](const auto& closed_form) { return exact_solution(closed_form, material, factor); }},
                    *problem.exact);
}

/// What load steps need, but for samples and probes.
Scene scene_of_load_steps(const Case& problem) {
  const auto& analysis = std::get<QuasiStatic>(problem.analysis);
  const LoadFactor factor = load_factor(analysis);
  Scene scene = scene_of_body(problem, factor);
  scene.material =
      std::make_shared<LinearElastic>(problem.material.youngs_modulus, problem.material.poissons_ratio, problem.plane);
  scene.loading = analysis.loading;
  scene.load_steps = analysis.load_steps;
  scene.geometry = analysis.geometry;
  if (problem.output.strain || problem.strain_energy)
    scene.points.strain = Eigen::Matrix3Xd::Zero(3, scene.points.size());
  scene.respacing = problem.respacing;

  const std::shared_ptr<const Material> law = law_of_contributions(problem, scene);
  scene.contributions.push_back(stiffness_of(law));
  if (scene.projected) scene.contributions.push_back(projected_dilatation());
  if (problem.body_force || problem.gravity)
    scene.contributions.push_back(body_force(force_per_volume(problem, factor)));
  add_boundary_effects(scene, law, problem.ghost);
  if (problem.ghost > 0.0) scene.contributions.push_back(ghost_penalty(problem.ghost, scene.material));
  return scene;
}

}  // namespace

Scene scene_of_body(const Case& problem, const LoadFactor& factor) {
  Scene scene;
  Body body = build_body(problem);
  scene.basis = std::move(body.basis);
  scene.loops = std::move(body.loops);
  scene.points = std::move(body.points);
  scene.fitted = problem.fitted;
  if (problem.exact) scene.exact = to_solution(problem, factor);
  for (std::size_t k = 0; k < body.curves.size(); ++k) {
    const auto original = std::make_shared<SplineCurve>(body.curves[k]);
    const auto& [piece, condition] = problem.boundaries[k];
    scene.boundary.push_back({piece, to_condition(condition, {original, factor, scene.exact}), original});
  }
  check_grid_pieces(problem, scene, *scene.basis);
  return scene;
}

Scene build_scene(const Case& problem) {
  Clock phases;
  return build_scene(problem, phases);
}

Scene build_scene(const Case& problem, Clock& phases) {
  Scene scene = phases.time("setup", [&] { return scene_of_load_steps(problem); });
  if (problem.samples)
    scene.samples =
        phases.time("errors", [&] { return place_samples(curves_at_start(scene.boundary), *problem.samples); });
  if (!problem.probes.empty())
    phases.time("probes", [&] {
      scene.places = places_of_probes(problem, scene);
      scene.probes = place_probes(problem, scene);
    });
  return scene;
}

}  // namespace shoreline
