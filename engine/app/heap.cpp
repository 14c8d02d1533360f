#include "heap.hpp"

#include <atomic>
#include <cstddef>

#include "shoreline/bases/counters.hpp"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)

namespace {
std::atomic<long> allocations = 0;
}

extern "C" void* __libc_malloc(std::size_t size);  // what glibc's malloc is otherwise

/// Stands before glibc's, for the program and all its libraries.
extern "C" void* malloc(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}

void shoreline::count_heap() {
  count_allocations_by([] { return allocations.load(std::memory_order_relaxed); });
}

#else

void shoreline::count_heap() {}

#endif
