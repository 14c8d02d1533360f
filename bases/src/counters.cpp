#include "shoreline/bases/counters.hpp"

#include <atomic>
#include <deque>
#include <mutex>

namespace shoreline {
namespace {

constexpr auto kinds = static_cast<std::size_t>(Work::count);

/// Only its own thread writes to it, so a count is a load and a store.
using Tally = std::array<std::atomic<long>, kinds>;

struct Tallies {
  std::mutex mutex;
  std::deque<Tally> of_thread;  // outlive their threads
};

Tallies& tallies() {
  static Tallies all;
  return all;
}

long (*allocations_of_program)() = nullptr;

Tally& new_tally() {
  Tallies& all = tallies();
  const std::lock_guard lock(all.mutex);
  return all.of_thread.emplace_back();
}

}  // namespace

std::string_view name_of(Work work) {
  constexpr std::array<std::string_view, kinds> names{
      "evaluations", "normal_derivatives", "splines",      "traces",         "displacement_fits", "moments",
      "weight_fits", "mass_matrices",      "exact_values", "factorisations", "analyses",          "solves",
      "allocations"};
  return names[static_cast<std::size_t>(work)];
}

void count(Work work, long times) {
  thread_local Tally& own = new_tally();
  std::atomic<long>& number = own[static_cast<std::size_t>(work)];
  number.store(number.load(std::memory_order_relaxed) + times, std::memory_order_relaxed);
}

void count_allocations_by(long (*allocations)()) { allocations_of_program = allocations; }

long heap_allocations() { return allocations_of_program == nullptr ? 0 : allocations_of_program(); }

Counts counted() {
  Tallies& all = tallies();
  const std::lock_guard lock(all.mutex);
  Counts sum{};
  for (const Tally& tally : all.of_thread)
    for (std::size_t k = 0; k < kinds; ++k) sum[k] += tally[k].load(std::memory_order_relaxed);
  return sum;
}

}  // namespace shoreline
