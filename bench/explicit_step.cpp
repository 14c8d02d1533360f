// What one time step of explicit dynamics costs, by basis and mass, beside what the machine could do at most.
//
//   shoreline_bench_explicit_step [points] [steps] [lumped]
//
// A square on rollers, moving in a smooth mode by a hundredth of a cell a step, so that points cross into other cells
// as they do in a run. Prints million point-steps a second, medians over the steps after a warm-up, without search of
// the critical step and without output; the ratios to two bounds; and the shares of the phases.

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "bounds.hpp"
#include "multiply_adds.hpp"
#include "shoreline/engine/dynamics.hpp"
#include "shoreline/engine/linear_solver.hpp"

using namespace shoreline;

namespace {

constexpr int warm_up = 30;  ///< steps, within which the first points cross
constexpr double bytes_per_point = 264.0;
const std::vector<std::string> phases{"boundary", "forces", "mass", "accelerate", "move", "cells"};

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

Case square(const Kind& kind, MassForm mass, double points, int steps) {
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

struct Measured {
  Index points = 0;
  double rate = 0.0;                    ///< point-steps a second, by the median of the steps
  double best = 0.0;                    ///< by the fastest step
  std::map<std::string, double> share;  ///< of the phases in the time of all steps
  double iterations = 0.0;              ///< of conjugate gradients, a step
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

Measured measure(const Case& problem, int threads, int steps) {
  omp_set_num_threads(threads);
  DynamicScene scene = build_dynamic_scene(problem);
  DynamicRecord record;
  std::vector<double> taken;
  std::map<std::string, double> before;
  double last = 0.0;
  long iterations = 0;
  const auto after_step = [&](int step, double) {
    const double now = omp_get_wtime();
    if (step > warm_up) taken.push_back(now - last);
    if (step == warm_up) {
      iterations = record.mass_iterations;
      for (const Clock::Entry& e : record.phases.entries()) before[e.name] = e.seconds;
    }
    last = omp_get_wtime();
  };
  run_time_steps(scene, {.after_step = after_step}, record);
  Measured result;
  result.points = scene.body.points.size();
  double all = 0.0;
  for (const double t : taken) all += t;
  for (const Clock::Entry& e : record.phases.entries()) result.share[e.name] = (e.seconds - before[e.name]) / all;
  result.rate = result.points / median(taken);
  result.best = result.points / *std::ranges::min_element(taken);
  result.iterations = static_cast<double>(record.mass_iterations - iterations) / steps;
  return result;
}

struct Bounds {
  double operations;  ///< a second
  double bytes;       ///< a second
};

void print(const Kind& kind, MassForm mass, int threads, const Measured& m, const Bounds& bounds, double one) {
  fmt::print("{:<12} {:<13} {:>7} {:>7} {:>7.2f} {:>7.2f} {:>7.2f} {:>7.2f} {:>7.2f} {:>6.1f} ", kind.name,
             name_of(mass), m.points, threads, 1e-6 * m.rate, 1e-6 * m.best, m.rate / one,
             m.rate * operations(kind) / bounds.operations, m.rate * bytes_per_point / bounds.bytes, m.iterations);
  for (const std::string& phase : phases) {
    const auto found = m.share.find(phase);
    fmt::print(" {:>4.0f}%", found == m.share.end() ? 0.0 : 100.0 * found->second);
  }
  fmt::print("\n");
}

void print_head(const std::vector<Bounds>& bounds, int steps) {
  fmt::print("scalar multiply-adds {} fused | medians of {} steps\n", bench::has_fma() ? "are" : "are not", steps);
  for (std::size_t k = 0; k < bounds.size(); ++k)
    fmt::print("{} thread{}: {:.1f}e9 scalar operations a second, {:.1f}e9 bytes a second\n", k + 1, k == 0 ? "" : "s",
               1e-9 * bounds[k].operations, 1e-9 * bounds[k].bytes);
  fmt::print("{:<12} {:<13} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>6} ", "basis", "mass", "points", "threads",
             "M/s", "best", "speedup", "/scalar", "/triad", "cg");
  for (const std::string& phase : phases) fmt::print(" {:>5.5}", phase);
  fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const double points = argc > 1 ? std::stod(argv[1]) : 80000.0;
  const int steps = argc > 2 ? std::stoi(argv[2]) : 40;
  const bool lumped_alone = argc > 3;
  const std::vector<Kind> kinds{{"bilinear", Case::BasisType::bilinear, 1, 4, 2, 4.0},
                                {"linear", Case::BasisType::linear, 1, 3, 2, 8.0},
                                {"bspline 2", Case::BasisType::bspline, 2, 9, 2, 4.0},
                                {"bspline 3", Case::BasisType::bspline, 3, 16, 2, 4.0},
                                {"powell_sabin", Case::BasisType::powell_sabin, 2, 9, 4, 48.0}};
  set_blas_threads(1);
  std::vector<Bounds> bounds;
  for (const int threads : {1, 2})
    bounds.push_back({bench::scalar_operations(threads, 9), bench::triad_bandwidth(threads, 9)});
  print_head(bounds, steps);
  for (const Kind& kind : kinds)
    for (const MassForm mass : {MassForm::lumped, MassForm::partly_lumped, MassForm::consistent}) {
      if (lumped_alone && mass != MassForm::lumped) continue;
      const Case problem = square(kind, mass, points, steps);
      const Measured one = measure(problem, 1, steps);
      print(kind, mass, 1, one, bounds[0], one.rate);
      print(kind, mass, 2, measure(problem, 2, steps), bounds[1], one.rate);
    }
}
