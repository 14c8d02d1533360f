// What points, phases, solvers and time steps cost: one program on Google Benchmark; table.py prints its results.

#include <omp.h>

#include "benchmarks.hpp"
#include "multiply_adds.hpp"
#include "shoreline/engine/linear_solver.hpp"

namespace shoreline::bench {

std::vector<int> thread_counts() {
  const int all = omp_get_num_procs();
  return all > 1 ? std::vector{1, all} : std::vector{1};
}

}  // namespace shoreline::bench

int main(int argc, char** argv) {
  using namespace shoreline;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("blas", blas_name());
  benchmark::AddCustomContext("fused multiply-adds", bench::has_fma() ? "yes" : "no");
  bench::register_bounds();
  bench::register_support();
  bench::register_finite_elements();
  bench::register_load_steps();
  bench::register_solvers();
  bench::register_explicit_steps();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
