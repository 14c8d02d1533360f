#pragma once
// What the machine gives at most, measured where a benchmark runs.

namespace shoreline::bench {

struct Bounds {
  /// Scalar floating-point operations a second, two to a multiply-add: independent chains a ← a·b + c.
  double operations = 0.0;
  /// Bytes a second of the triad a_i = b_i + s·c_i over arrays far beyond the cache. 32 bytes an entry are counted: two
  /// numbers read, one written, and its cache line, which is read before it is written.
  double bytes = 0.0;
};

/// The fastest of nine repetitions on @p threads at once, and of all calls before: other programs only take from it.
[[nodiscard]] Bounds bounds(int threads);

}  // namespace shoreline::bench
