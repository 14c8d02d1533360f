#pragma once
// The benchmarks by what they measure. Names tell the setting, "load_step/bilinear/points:100000/threads:1"; counters
// hold sizes, and seconds by phase.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

namespace shoreline::bench {

void register_bounds();           ///< what the machine gives at most
void register_support();          ///< a basis at a point
void register_finite_elements();  ///< assembly without material points
void register_load_steps();       ///< the phases of quasi-static steps
void register_solvers();          ///< the methods of the ladder
void register_explicit_steps();   ///< the phases of explicit dynamics

/// Registers what runs once a repetition, fills counters and returns the seconds that count.
template <class Work>
void add(const std::string& name, Work work) {
  const auto run = [work](benchmark::State& state) {
    for ([[maybe_unused]] const auto _ : state) state.SetIterationTime(work(state.counters));
  };
  benchmark::RegisterBenchmark(name.c_str(), run)->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
}

inline double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// One thread, and all that the machine has.
[[nodiscard]] std::vector<int> thread_counts();

}  // namespace shoreline::bench
