#include "bounds.hpp"

#include <omp.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>

#include "benchmarks.hpp"
#include "multiply_adds.hpp"

namespace shoreline::bench {
namespace {

/// The least of the seconds that some work takes in nine times, after one that is not counted.
template <class Work>
double seconds(Work&& work) {
  work();
  double least = std::numeric_limits<double>::infinity();
  for (int r = 0; r < 9; ++r) {
    const double start = omp_get_wtime();
    work();
    least = std::min(least, omp_get_wtime() - start);
  }
  return least;
}

double scalar_operations(int threads) {
  constexpr long count = 4'000'000;
  double sum = 0.0;
  const double taken = seconds([&] {
#pragma omp parallel num_threads(threads) reduction(+ : sum)
    sum += multiply_adds(count, 0.999, 1e-3);
  });
  return sum > 0.0 ? 2.0 * chains * static_cast<double>(count) * threads / taken : 0.0;
}

double triad_bandwidth(int threads) {
  constexpr long entries = 24'000'000;
  const auto a = std::make_unique_for_overwrite<double[]>(entries);
  const auto b = std::make_unique_for_overwrite<double[]>(entries);
  const auto c = std::make_unique_for_overwrite<double[]>(entries);
#pragma omp parallel for num_threads(threads) schedule(static)
  for (long i = 0; i < entries; ++i) b[i] = c[i] = 1.0;  // each thread touches first what it works on
  const double taken = seconds([&] {
#pragma omp parallel for num_threads(threads) schedule(static)
    for (long i = 0; i < entries; ++i) a[i] = b[i] + 3.0 * c[i];
  });
  return 32.0 * static_cast<double>(entries) / taken;
}

}  // namespace

Bounds bounds(int threads) {
  static std::map<int, Bounds> fastest;
  Bounds& best = fastest[threads];
  best.operations = std::max(best.operations, scalar_operations(threads));
  best.bytes = std::max(best.bytes, triad_bandwidth(threads));
  return best;
}

void register_bounds() {
  for (const int threads : thread_counts())
    add("bounds/threads:" + std::to_string(threads), [threads](benchmark::UserCounters& counters) {
      const Bounds most = bounds(threads);
      counters["operations"] = most.operations;
      counters["bytes"] = most.bytes;
      return 1.0 / most.bytes;
    });
}

}  // namespace shoreline::bench
