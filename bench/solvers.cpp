// What the methods of the ladder cost: a line of comma-separated values for each body, size, method and load step.
//
//   shoreline_bench_solvers [most unknowns] [repetitions] [methods, "band,cholmod,multigrid"] [bodies, "q4,slender"]
//
// Squares on bilinear cells (q4) and quadratic B-splines (bspline2), and a bar ten times as long as wide on bilinear
// cells (slender); off the grid lines, rollers by the implicit boundary on three sides, a traction on the fourth. The
// second step has the pattern of the first, so nothing is analysed. Milliseconds are medians over the repetitions; all
// threads work.

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "shoreline/engine/linear_solver.hpp"
#include "shoreline/engine/quasi_static.hpp"

using namespace shoreline;

namespace {

struct Body {
  std::string name;
  int degree;   ///< of the basis: 1 bilinear
  int slender;  ///< length over width
};
const std::vector<Body> bodies{{"q4", 1, 1}, {"bspline2", 2, 1}, {"slender", 1, 10}};
const std::vector<SolverType> methods{SolverType::band, SolverType::cholmod, SolverType::multigrid};

/// @param cells  over the width
Case rectangle(const Body& body, int cells) {
  const double h = 1.0 / cells;
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
  problem.material_points = LatticeFill{{body.degree + 1, body.degree + 1}, VolumeRule::clipped};
  std::get<QuasiStatic>(problem.analysis).load_steps = 2;
  return problem;
}

/// Seconds of analyse, factorise, solve.
using Seconds = std::array<double, 3>;

struct Measured {
  SolverUse use;
  std::array<Seconds, 2> step{};
};

Measured run_once(const Case& problem, SolverType type) {
  Scene scene = build_scene(problem);
  RunRecord record;
  Measured measured;
  Seconds before{};
  const auto after_step = [&](int step) {
    Seconds now{};
    for (const Clock::Entry& e : record.phases.entries())
      for (const auto& [k, name] : {std::pair{0U, "analyse"}, std::pair{1U, "factorise"}, std::pair{2U, "solve"}})
        if (e.name == name) now[k] = e.seconds;
    for (std::size_t k = 0; k < 3; ++k) measured.step[static_cast<std::size_t>(step - 1)][k] = now[k] - before[k];
    before = now;
  };
  run_load_steps(scene, {.solver = type, .after_step = after_step}, record);
  measured.use = *record.solver;
  return measured;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

void print(const Body& body, const std::vector<Measured>& runs) {
  const SolverUse& use = runs.front().use;
  for (std::size_t s = 0; s < 2; ++s) {
    const auto phase = [&](std::size_t k) {
      std::vector<double> values;
      for (const Measured& run : runs) values.push_back(1e3 * run.step[s][k]);
      return median(values);
    };
    fmt::print("{},{},{},{},{:.2f},{:.2f},{:.2f},{:.2f},{:.1f},{}\n", body.name, use.unknowns, name_of(use.type), s + 1,
               phase(0), phase(1), phase(2), phase(0) + phase(1) + phase(2), use.bytes / 1e6,
               use.iterations.value_or(0));
  }
  std::fflush(stdout);
}

bool has(const std::string& list, const std::string& word) {
  return ("," + list + ",").find("," + word + ",") != list.npos;
}

}  // namespace

int main(int argc, char** argv) {
  const double most = argc > 1 ? std::stod(argv[1]) : 1e5;
  const int repetitions = argc > 2 ? std::stoi(argv[2]) : 3;
  const std::string wanted_methods = argc > 3 ? argv[3] : "band,cholmod,multigrid";
  const std::string wanted_bodies = argc > 4 ? argv[4] : "q4,bspline2,slender";
  omp_set_num_threads(omp_get_num_procs());
  set_blas_threads(omp_get_num_procs());
  fmt::print("# {}, {} threads, medians of {}\n", blas_name(), omp_get_num_procs(), repetitions);
  fmt::print("body,unknowns,method,step,analyse_ms,factorise_ms,solve_ms,total_ms,memory_MB,iterations\n");
  for (const Body& body : bodies)
    for (const double unknowns : {2e3, 1e4, 2e4, 3e4, 5e4, 1e5, 2e5, 5e5, 1e6}) {
      if (unknowns > most || !has(wanted_bodies, body.name)) continue;
      const Case problem = rectangle(body, static_cast<int>(std::lround(std::sqrt(unknowns / 2.0 / body.slender))));
      for (const SolverType type : methods) {
        if (!has(wanted_methods, name_of(type)) || (type == SolverType::multigrid && !multigrid_available())) continue;
        std::vector<Measured> runs;
        for (int r = 0; r < repetitions; ++r) runs.push_back(run_once(problem, type));
        print(body, runs);
      }
    }
}
