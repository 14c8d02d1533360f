// What one load step costs, by phase: with the size of the problem, and with points alone.

#include <fmt/format.h>

#include <cmath>

#include "benchmarks.hpp"
#include "bounds.hpp"
#include "two_steps.hpp"

namespace shoreline::bench {
namespace {

double run(const Rectangle& body, int threads, benchmark::UserCounters& counters) {
  const TwoSteps steps = run_two_steps(body, SolverType::cholmod, threads);
  counters["points"] = steps.points;
  counters["unknowns"] = steps.unknowns;
  counters["cells"] = static_cast<double>(body.cells) * body.cells;
  counters["factor_bytes"] = steps.solver.bytes;
  counters["setup"] = steps.setup;
  counters["triad"] = bounds(1).bytes;
  for (std::size_t s = 0; s < 2; ++s)
    for (const auto& [phase, seconds] : steps.step[s]) counters[fmt::format("step{}_{}", s + 1, phase)] = seconds;
  double total = 0.0;
  for (const auto& [phase, seconds] : steps.step[1]) total += seconds;
  return total;
}

void add_sizes(const std::string& name, const Rectangle& body) {
  for (const int threads : thread_counts())
    add(fmt::format("load_step/{}/{}/threads:{}", body.degree == 1 ? "bilinear" : "bspline2", name, threads),
        [body, threads](benchmark::UserCounters& counters) { return run(body, threads, counters); });
}

}  // namespace

void register_load_steps() {
  for (const int degree : {1, 2})
    for (const int points : {10'000, 100'000, 1'000'000, 10'000'000})
      if (degree == 1 || points <= 1'000'000)
        add_sizes(fmt::format("points:{}", points),
                  {.degree = degree, .cells = static_cast<int>(std::lround(std::sqrt(points) / 4.0))});
  for (const int unknowns : {100'000, 500'000})
    add_sizes(fmt::format("unknowns:{}", unknowns),
              {.cells = static_cast<int>(std::lround(std::sqrt(unknowns / 2.0)))});
  for (const int per_cell : {4, 13, 40})
    add_sizes(fmt::format("fixed_unknowns/per_cell:{}", per_cell), {.cells = 79, .per_cell = per_cell});
}

}  // namespace shoreline::bench
