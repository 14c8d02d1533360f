#include <fmt/format.h>

#include <cmath>

#include "dynamics/dynamic_run.hpp"
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

/// Bytes of a run, from its sizes. The factor of an AMD-ordered plane grid has about 8 n log₂ n entries; where
/// functions reach over p cells, the separators are p of them wide, and entries (1 + p²)/2 times as many.
double predicted_bytes(const Scene& scene, const PointSupports& supports, const SystemSize& size, SolverType solver,
                       const Case& problem) {
  const double unknowns = size.unknowns;
  const double n = scene.basis->functions_per_cell();
  const double points = scene.points.size() + (scene.samples ? scene.samples->size() : 0);
  const double cells = supports.cells();
  const double block_entries = n * (2.0 * n + 1.0);
  const double state = 12.0 * 8.0;                       // position, displacement, volume, stress, strain
  const double support = 3.0 * n * 8.0 + 4.0;            // value, gradient, order
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
  return (problem.error_estimate ? estimate : 0.0) + program + points * (state * 2.0 + support) + cells * block +
         unknowns * matrix + kept + bytes_of_cell(problem.grid.basis) * scene.basis->grid().cells();
}

std::string built(const Case& problem, const Scene& scene) {
  std::string text;
  for (const auto& effect : scene.contributions) text += "  " + effect->name() + "\n";
  for (const BoundaryPiece& b : scene.boundary)
    if (const auto* c = std::get_if<Essential>(&b.condition); c != nullptr && c->method == EssentialMethod::grid)
      text += "  grid:" + b.piece.name + "\n";
  if (scene.fitted) text += "  fitted weights\n";
  if (scene.samples) text += "  sample points\n";
  for (const Probe& probe : scene.probes) text += "  probe:" + probe.name + "\n";
  return text + (problem.error_estimate ? "  error estimate\n" : "");
}

std::string left_out(const Case& problem) {
  std::string text;
  const auto unless = [&](bool named, const char* effect, const char* why) {
    if (!named) text += fmt::format("  {:<22}{}\n", effect, why);
  };
  unless(problem.body_force || problem.gravity, "body force", "no key body_force or gravity");
  unless(problem.material.projected_dilatation, "projected dilatation", "material.dilatation is plain");
  unless(problem.ghost > 0.0, "ghost penalty", "ghost is 0");
  unless(problem.fitted, "fitted weights", "material_points.volumes is not fitted");
  unless(problem.exact.has_value(), "errors", "no key exact");
  unless(problem.samples.has_value(), "sample points", "no key samples");
  unless(!problem.probes.empty(), "probes", "no key probes");
  unless(problem.condition_estimate, "condition estimate", "diagnostics.condition_estimate is false");
  unless(problem.cut_fractions, "cut fractions", "diagnostics.cut_fractions is false");
  unless(problem.strain_energy, "strain energy", "diagnostics.strain_energy is false");
  unless(problem.error_estimate, "error estimate", "diagnostics.error_estimate is false");
  unless(problem.output.pictures, "pictures", "output.pictures is false");
  return text.empty() ? "  nothing\n" : text;
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
      "{}\n\nwill run\n{}\nwill not run\n{}\nsizes\n"
      "  load steps          {}\n  basis               {}\n  grid                {} elements of {} {}, {} cells with "
      "material\n  material points     {}\n"
      "  unknowns            at most {}\n  solver              {}: {}\n  predicted memory    {:.0f} MB\n",
      problem.title, built(problem, scene), left_out(problem), scene.load_steps, name_of(problem.grid.basis),
      grid.cells() / grid.parts(), grid.parts(), grid.parts() == 1 ? "cell" : "cells", supports.cells(),
      scene.points.size(), size.unknowns, name_of(solver.type), solver.reason,
      predicted_bytes(scene, supports, size, solver.type, problem) / 1e6);
}

}  // namespace shoreline
