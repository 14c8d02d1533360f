// What one load step costs, by phase, beside CHOLMOD's own share of it.
//
//   shoreline_bench_load_step [points per cell and direction] [repetitions]
//
// A square that lies off the grid lines, rollers by the implicit boundary on three sides, a traction on the fourth; two
// load steps, so that the second shows what is reused. Prints medians over the repetitions for one and for all threads,
// the speed-up of the phases that are Shoreline's own, and the exponent of cost in points.

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "shoreline/engine/linear_solver.hpp"
#include "shoreline/engine/quasi_static.hpp"

using namespace shoreline;

namespace {

const std::vector<std::string> ours{"support", "boundary", "assembly", "pattern", "update"};
const std::vector<std::string> cholmod{"analyse", "factorise", "solve"};

using Seconds = std::map<std::string, double>;

Case square(int cells, int per_cell) {
  const double h = 1.0 / cells;
  const double low = 0.3 * h;
  const double high = 1.0 - 0.4 * h;
  const auto side = [](std::string name, Vec2 from, Vec2 to, Case::Condition condition) {
    return Case::Boundary{{.name = std::move(name), .points = {from, to}, .corners = {}}, std::move(condition)};
  };
  const Essential roller{.normal_only = true, .method = EssentialMethod::implicit_boundary, .band = 1e-3};
  Case problem;
  problem.material = {.youngs_modulus = 1e6, .poissons_ratio = 0.25, .density = {}};
  problem.grid = {.lower = Vec2::Zero(), .upper = Vec2::Ones(), .cell_size = Vec2::Constant(h)};
  problem.boundaries = {
      side("bottom", {low, low}, {high, low}, roller), side("right", {high, low}, {high, high}, roller),
      side("top", {high, high}, {low, high}, Case::Traction{std::array{Quantity(0.0), Quantity(-1.0)}}),
      side("left", {low, high}, {low, low}, roller)};
  problem.material_points = LatticeFill{{per_cell, per_cell}, VolumeRule::clipped};
  std::get<QuasiStatic>(problem.analysis).load_steps = 2;
  return problem;
}

struct Measured {
  Index points = 0;
  Index unknowns = 0;
  double setup = 0.0;
  std::array<Seconds, 2> step;
};

Measured run_once(const Case& problem) {
  Measured measured;
  Clock setup;
  Scene scene = setup.time("setup", [&] { return build_scene(problem); });
  measured.setup = setup.entries().front().seconds;
  RunRecord record;
  Seconds before;
  run_load_steps(scene,
                 {.condition_estimate = false,
                  .after_step =
                      [&](int step) {
                        for (const Clock::Entry& e : record.phases.entries()) {
                          measured.step[static_cast<std::size_t>(step - 1)][e.name] = e.seconds - before[e.name];
                          before[e.name] = e.seconds;
                        }
                      }},
                 record);
  measured.points = scene.points.size();
  measured.unknowns = record.degrees_of_freedom;
  return measured;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

Measured median_run(const Case& problem, int threads, int repetitions) {
  omp_set_num_threads(threads);
  set_blas_threads(threads);
  std::vector<Measured> runs;
  for (int r = 0; r < repetitions; ++r) runs.push_back(run_once(problem));
  Measured result = runs.front();
  const auto over_runs = [&](auto&& value) {
    std::vector<double> values;
    for (Measured& run : runs) values.push_back(value(run));
    return median(values);
  };
  result.setup = over_runs([](Measured& m) { return m.setup; });
  for (std::size_t s = 0; s < 2; ++s)
    for (auto& [phase, seconds] : result.step[s]) seconds = over_runs([&](Measured& m) { return m.step[s][phase]; });
  return result;
}

double sum(const Seconds& seconds, const std::vector<std::string>& phases) {
  double total = 0.0;
  for (const std::string& phase : phases)
    if (const auto found = seconds.find(phase); found != seconds.end()) total += found->second;
  return total;
}

void print(const Measured& m, int threads) {
  for (std::size_t s = 0; s < 2; ++s) {
    fmt::print("{:>9} {:>9} {:>7} {:>4}", m.points, m.unknowns, threads, s + 1);
    for (const auto& group : {ours, cholmod})
      for (const std::string& phase : group) fmt::print(" {:>9.2f}", 1e3 * sum(m.step[s], {phase}));
    const double factorise = sum(m.step[s], {"factorise"});
    fmt::print(" {:>9.2f}\n", (sum(m.step[s], ours) + sum(m.step[s], cholmod) - factorise) / factorise);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int per_cell = argc > 1 ? std::stoi(argv[1]) : 4;
  const int repetitions = argc > 2 ? std::stoi(argv[2]) : 5;
  const int threads = omp_get_num_procs();
  fmt::print("{} | milliseconds, medians of {} runs\n", blas_name(), repetitions);
  fmt::print("{:>9} {:>9} {:>7} {:>4}", "points", "unknowns", "threads", "step");
  for (const auto& group : {ours, cholmod})
    for (const std::string& phase : group) fmt::print(" {:>9}", phase);
  fmt::print(" {:>9}\n", "rest/fact");

  std::vector<std::pair<double, double>> cost;
  for (const double points : {1e4, 1e5, 1e6}) {
    const Case problem = square(static_cast<int>(std::lround(std::sqrt(points) / per_cell)), per_cell);
    const Measured one = median_run(problem, 1, repetitions);
    const Measured all = median_run(problem, threads, repetitions);
    print(one, 1);
    print(all, threads);
    fmt::print("  ours, {} threads against one: {:.2f} (step 1), {:.2f} (step 2); setup {:.1f} ms\n", threads,
               sum(one.step[0], ours) / sum(all.step[0], ours), sum(one.step[1], ours) / sum(all.step[1], ours),
               1e3 * all.setup);
    cost.emplace_back(one.points, sum(one.step[1], ours));
  }
  for (std::size_t k = 1; k < cost.size(); ++k)
    fmt::print("exponent of our phases from {} to {} points: {:.2f}\n", cost[k - 1].first, cost[k].first,
               std::log(cost[k].second / cost[k - 1].second) / std::log(cost[k].first / cost[k - 1].first));
}
