#include <fmt/format.h>

#include <cmath>

#include "dynamics/dynamic_run.hpp"
#include "effect_list.hpp"
#include "make_basis.hpp"
#include "predicted_system.hpp"
#include "projection_run.hpp"
#include "shoreline/engine/run.hpp"
#include "shoreline/engine/scene.hpp"

namespace shoreline {
namespace {

/// Bytes of a cell, whether it holds material or not: its mark; vertices, neighbours, lines and bins of triangles; the
/// ordinates of a part of a Powell-Sabin triangle.
double bytes_of_cell(Case::BasisType basis) {
  switch (basis) {
    case Case::BasisType::linear:
      return 5.0 + 100.0;
    case Case::BasisType::powell_sabin:
      return 5.0 + 100.0 + 240.0;
    case Case::BasisType::bilinear:
    case Case::BasisType::bspline:
      break;
  }
  return 5.0;
}

/// What a run keeps of each material point [bytes].
double bytes_of_point(const Scene& scene) {
  const double numbers = 2.0 + 2.0 + 1.0 + 4.0 + (scene.points.strain.cols() > 0 ? 3.0 : 0.0);
  return 8.0 * numbers + 4.0 + 16.0;  // state; order and place in the cells
}

/// Bytes of a run, from its sizes. The factor of an AMD-ordered plane grid has about 8 n log₂ n entries; where
/// functions reach over p cells, the separators are p of them wide, and entries (1 + p²)/2 times as many.
double predicted_bytes(const Scene& scene, const PointSupports& supports, const SystemSize& size, SolverType solver,
                       const Case& problem) {
  const double unknowns = size.unknowns;
  const double n = scene.basis->functions_per_cell();
  const double points = scene.points.size();
  const double samples = scene.samples ? scene.samples->size() : 0;
  const double cells = supports.cells();
  const double block_entries = n * (2.0 * n + 1.0);
  constexpr double written = 3.0 * 8.0;                  // positions in space, as they are saved
  const double block = 12.0 * block_entries + 60.0 * n;  // matrix and place, functions and pattern
  const double matrix = 5.0 * n * 2.0 * 12.0;            // an unknown's column, twice
  const double reach = problem.grid.basis == Case::BasisType::bspline ? problem.grid.degree : 1.0;
  const double factor = 4.0 * (1.0 + reach * reach) * 8.0 * std::log2(std::max(unknowns, 2.0));
  const double kept = solver == SolverType::band        ? band_bytes(size)
                      : solver == SolverType::multigrid ? unknowns * 2.5 * matrix
                                                        : unknowns * factor;
  // the estimate has one component, so a quarter of the matrix, of its factor and (as triplets) of its blocks
  const double estimate = cells * 8.0 * n * (n + 1.0) + 0.25 * unknowns * (matrix + factor);
  constexpr double program = 2.2e7;
  return (problem.error_estimate ? estimate : 0.0) + program + (points + samples) * bytes_of_point(scene) +
         points * written + cells * block + unknowns * matrix + kept +
         bytes_of_cell(problem.grid.basis) * scene.basis->grid().cells();
}

EffectList effects_of(const Case& problem, const Scene& scene) {
  EffectList list;
  add_common_effects(problem, scene, list);
  list.add(scene.samples.has_value(), "samples", "places of their own, carried along", "no key samples");
  list.add(problem.condition_estimate, "condition_estimate", "some solutions with the factors",
           "diagnostics.condition_estimate is false");
  list.add(problem.cut_fractions, "cut_fractions", "the outline in cut cells; the factor's pivots",
           "diagnostics.cut_fractions is false");
  list.add(problem.strain_energy, "strain_energy", "strain and stress of the material points",
           "diagnostics.strain_energy is false");
  const auto never = [&](bool named, const char* name, const char* why) {
    if (!named) list.left_out.push_back({name, why});
  };
  never(problem.body_force || problem.gravity, "body_force", "no key body_force or gravity");
  never(problem.material.projected_dilatation, "projected_dilatation", "material.dilatation is \"plain\"");
  never(problem.ghost > 0.0, "ghost_penalty", "ghost is 0");
  return list;
}

}  // namespace

std::string plan(const Case& problem) {
  if (std::holds_alternative<Projection>(problem.analysis)) return plan_projection(problem);
  if (std::holds_alternative<ExplicitDynamics>(problem.analysis)) return plan_dynamics(problem);
  require_solver(problem);
  const Scene scene = build_scene(problem);
  const Grid& grid = scene.basis->grid();
  const PointSupports supports = locate_points(*scene.basis, scene.points);
  const SystemSize size = predicted_size(scene, supports, problem.ghost > 0.0);
  const SolverRequest request{problem.solver, problem.condition_estimate || problem.cut_fractions};
  const SolverChoice solver = choose_solver(request, size);
  return fmt::format(
      "{}\n\n{}\nsizes\n"
      "  load steps          {}\n  basis               {}\n  grid                {} elements of {} {}, {} cells with "
      "material\n  material points     {} of {:.0f} bytes\n"
      "  unknowns            at most {}\n  solver              {}: {}\n  predicted memory    {:.0f} MB\n",
      problem.title, text_of(effects_of(problem, scene)), scene.load_steps, name_of(problem.grid.basis),
      grid.cells() / grid.parts(), grid.parts(), grid.parts() == 1 ? "cell" : "cells", supports.cells(),
      scene.points.size(), bytes_of_point(scene), size.unknowns, name_of(solver.type), solver.reason,
      predicted_bytes(scene, supports, size, solver.type, problem) / 1e6);
}

}  // namespace shoreline
