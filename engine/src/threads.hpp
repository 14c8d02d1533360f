#pragma once
// When threads pay: a parallel region costs some ten microseconds, and milliseconds where other programs want the
// cores.

#include <cstddef>

namespace shoreline {

/// Whether a loop over @p visits (of points in their cells, of entries of a matrix) is long enough for threads.
[[nodiscard]] constexpr bool worth_threads(std::size_t visits) { return visits > 20000; }

}  // namespace shoreline
