#pragma once
// What the machine gives at most, measured where a benchmark runs.

namespace shoreline::bench {

/// Scalar floating-point operations a second, two to a multiply-add, on some threads at once: independent chains
/// a ← a·b + c. The fastest of some repetitions.
[[nodiscard]] double scalar_operations(int threads, int repetitions);

/// Bytes a second of the triad a_i = b_i + s·c_i over arrays far beyond the cache. 32 bytes an entry are counted: two
/// numbers read, one written, and its cache line, which is read before it is written. The fastest of some repetitions.
[[nodiscard]] double triad_bandwidth(int threads, int repetitions);

}  // namespace shoreline::bench
