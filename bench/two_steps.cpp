#include "two_steps.hpp"

#include <omp.h>

#include "shoreline/engine/linear_solver.hpp"
#include "shoreline/engine/quasi_static.hpp"

namespace shoreline::bench {
namespace {

Case case_of(const Rectangle& body) {
  const double h = 1.0 / body.cells;
  const double low = 0.3 * h;
  const double right = body.slender - 0.4 * h;
  const double top = 1.0 - 0.4 * h;
  const auto side = [](std::string name, Vec2 from, Vec2 to, Case::Condition condition) {
    return Case::Boundary{{.name = std::move(name), .points = {from, to}, .corners = {}}, std::move(condition)};
  };
  const Essential roller{.normal_only = true, .method = EssentialMethod::implicit_boundary, .band = 1e-3};
  Case problem;
  problem.material = {.youngs_modulus = 1e6, .poissons_ratio = 0.25, .density = {}};
  problem.grid = {.lower = Vec2::Zero(), .upper = Vec2(body.slender, 1.0), .cell_size = Vec2::Constant(h)};
  if (body.degree > 1) {
    problem.grid.basis = Case::BasisType::bspline;
    problem.grid.degree = body.degree;
    problem.ghost = 5e-4;
  }
  problem.boundaries = {
      side("bottom", {low, low}, {right, low}, roller), side("right", {right, low}, {right, top}, roller),
      side("top", {right, top}, {low, top}, Case::Traction{std::array{Quantity(0.0), Quantity(-1.0)}}),
      side("left", {low, top}, {low, low}, roller)};
  problem.material_points = LatticeFill{{body.per_cell, body.per_cell}, VolumeRule::clipped};
  std::get<QuasiStatic>(problem.analysis).load_steps = 2;
  return problem;
}

}  // namespace

TwoSteps run_two_steps(const Rectangle& body, SolverType solver, int threads) {
  omp_set_num_threads(threads);
  set_blas_threads(threads);
  TwoSteps result;
  Clock setup;
  Scene scene = build_scene(case_of(body), setup);
  result.setup = setup.entries().front().seconds;
  RunRecord record;
  const auto after_step = [&](int step) {
    for (const Clock::Entry& e : record.phases.entries())
      result.step[static_cast<std::size_t>(step - 1)][e.name] = e.seconds - (step > 1 ? result.step[0][e.name] : 0.0);
  };
  run_load_steps(scene, {.solver = solver, .after_step = after_step}, record);
  result.points = scene.points.size();
  result.unknowns = record.degrees_of_freedom;
  result.solver = *record.solver;
  return result;
}

}  // namespace shoreline::bench
