// What the methods of the ladder cost on squares of bilinear cells (q4) and quadratic B-splines (bspline2), and on a
// bar ten times as long as wide (slender). The second step has the pattern of the first, so nothing is analysed.

#include <fmt/format.h>

#include <cmath>

#include "benchmarks.hpp"
#include "two_steps.hpp"

namespace shoreline::bench {
namespace {

double run(const Rectangle& body, SolverType type, benchmark::UserCounters& counters) {
  const TwoSteps steps = run_two_steps(body, type, thread_counts().back());
  counters["unknowns"] = steps.unknowns;
  counters["factor_bytes"] = steps.solver.bytes;
  counters["cg"] = static_cast<double>(steps.solver.iterations.value_or(0));
  double second = 0.0;
  for (std::size_t s = 0; s < 2; ++s)
    for (const std::string phase : {"analyse", "factorise", "solve"}) {
      const auto found = steps.step[s].find(phase);
      const double seconds = found == steps.step[s].end() ? 0.0 : found->second;
      counters[fmt::format("step{}_{}", s + 1, phase)] = seconds;
      if (s == 1) second += seconds;
    }
  return second;
}

/// A band beyond 50,000 unknowns takes minutes and gigabytes.
bool takes(SolverType type, double unknowns) {
  return type == SolverType::cholmod || (type == SolverType::band ? unknowns <= 5e4 : multigrid_available());
}

}  // namespace

void register_solvers() {
  for (const auto& [name, degree, slender] : {std::tuple{"q4", 1, 1}, {"bspline2", 2, 1}, {"slender", 1, 10}})
    for (const double unknowns : {2e3, 1e4, 2e4, 3e4, 5e4, 1e5, 2e5, 5e5, 1e6})
      for (const SolverType type : {SolverType::band, SolverType::cholmod, SolverType::multigrid}) {
        if (!takes(type, unknowns)) continue;
        const int cells = static_cast<int>(std::lround(std::sqrt(unknowns / 2.0 / slender)));
        const Rectangle body{.degree = degree, .slender = slender, .cells = cells, .per_cell = degree + 1};
        add(fmt::format("solvers/{}/unknowns:{:.0f}/{}", name, unknowns, name_of(type)),
            [body, type](benchmark::UserCounters& counters) { return run(body, type, counters); });
      }
}

}  // namespace shoreline::bench
