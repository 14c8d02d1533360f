#pragma once
// How often the program allocates memory.

namespace shoreline {

/// From now on, runs count their allocations; on systems without glibc, and under the address sanitizer, they do not.
void count_heap();

}  // namespace shoreline
