// What one time step of explicit dynamics costs, by basis, mass and threads, beside what the machine could do at most.
// A square on rollers, moving in a smooth mode by a hundredth of a cell a step, so that points cross into other cells
// as they do in a run; without search of the critical step and without output.

#include <fmt/format.h>
#include <omp.h>

#include <cmath>
#include <map>

#include "benchmarks.hpp"
#include "bounds.hpp"
#include "shoreline/engine/dynamics.hpp"
#include "shoreline/engine/linear_solver.hpp"

namespace shoreline::bench {
namespace {

constexpr double points = 80'000.0;
constexpr int warm_up = 30;  ///< steps, within which the first points cross
constexpr int steps = 40;    ///< that are measured
constexpr double bytes_per_point = 264.0;

struct Kind {
  const char* name;
  Case::BasisType basis;
  int degree;
  int functions;  ///< that see a point
  int per_cell;   ///< points along a cell
  double points_per_rectangle;
};

/// Operations of one point in one step with n functions: 30 n for sums over functions, 8 n and the rest to evaluate
/// the basis and to move the point.
double operations(const Kind& kind) { return 75.0 + 38.3 * kind.functions; }

Case square(const Kind& kind, MassForm mass) {
  const int cells = static_cast<int>(std::lround(std::sqrt(points / kind.points_per_rectangle)));
  const auto side = [](std::string name, Vec2 from, Vec2 to) {
    return Case::Boundary{{.name = std::move(name), .points = {from, to}, .corners = {}},
                          Essential{.normal_only = true, .method = EssentialMethod::grid}};
  };
  Case problem;
  problem.material = {Case::Law::linear_large, 1.0, 0.0, 1.0};  // waves of speed 1 m/s
  problem.grid = {.lower = Vec2::Zero(),
                  .upper = Vec2::Ones(),
                  .cell_size = Vec2::Constant(1.0 / cells),
                  .basis = kind.basis,
                  .degree = kind.degree};
  problem.boundaries = {side("bottom", {0, 0}, {1, 0}), side("right", {1, 0}, {1, 1}), side("top", {1, 1}, {0, 1}),
                        side("left", {0, 1}, {0, 0})};
  problem.material_points = LatticeFill{{kind.per_cell, kind.per_cell}, VolumeRule::clipped};
  const double dt = 0.1 / cells;
  problem.analysis = ExplicitDynamics{.time_step = dt, .end_time = dt * (warm_up + steps), .mass = mass};
  problem.initial_velocity = {Expression("0.1*sin(pi*X)*cos(pi*Y)"), Expression("-0.1*cos(pi*X)*sin(pi*Y)")};
  problem.history = warm_up + steps;
  return problem;
}

/// Runs it. The time that counts is that of the median step.
double run(const Kind& kind, MassForm mass, int threads, benchmark::UserCounters& counters) {
  omp_set_num_threads(threads);
  set_blas_threads(1);
  DynamicScene scene = build_dynamic_scene(square(kind, mass));
  DynamicRecord record;
  std::vector<double> taken;
  std::map<std::string, double> before;
  double last = 0.0;
  long iterations = 0;
  const auto after_step = [&](int step, double) {
    if (step > warm_up) taken.push_back(omp_get_wtime() - last);
    if (step == warm_up) {
      iterations = record.mass_iterations;
      for (const Clock::Entry& e : record.phases.entries()) before[e.name] = e.seconds;
    }
    last = omp_get_wtime();
  };
  run_time_steps(scene, {.after_step = after_step}, record);
  const double rate = scene.body.points.size() / median(taken);
  for (const Clock::Entry& e : record.phases.entries())
    if (const double seconds = e.seconds - before[e.name]; seconds > 0.0) counters["phase_" + e.name] = seconds / steps;
  counters["points"] = scene.body.points.size();
  counters["best"] = *std::ranges::min_element(taken);
  counters["cg"] = static_cast<double>(record.mass_iterations - iterations) / steps;
  const Bounds most = bounds(threads);
  counters["/scalar"] = rate * operations(kind) / most.operations;
  counters["/triad"] = rate * bytes_per_point / most.bytes;
  return median(taken);
}

}  // namespace

void register_explicit_steps() {
  const std::vector<Kind> kinds{{"bilinear", Case::BasisType::bilinear, 1, 4, 2, 4.0},
                                {"linear", Case::BasisType::linear, 1, 3, 2, 8.0},
                                {"bspline2", Case::BasisType::bspline, 2, 9, 2, 4.0},
                                {"bspline3", Case::BasisType::bspline, 3, 16, 2, 4.0},
                                {"powell_sabin", Case::BasisType::powell_sabin, 2, 9, 4, 48.0}};
  for (const Kind& kind : kinds)
    for (const MassForm mass : {MassForm::lumped, MassForm::partly_lumped, MassForm::consistent})
      for (const int threads : thread_counts())
        add(fmt::format("explicit_step/{}/{}/threads:{}", kind.name, name_of(mass), threads),
            [=](benchmark::UserCounters& counters) { return run(kind, mass, threads, counters); });
}

}  // namespace shoreline::bench
