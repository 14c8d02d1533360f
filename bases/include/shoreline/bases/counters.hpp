#pragma once
// How often the costly things were done: always counted, since that costs next to nothing.

#include <array>
#include <string_view>

namespace shoreline {

/// What is counted.
enum class Work {
  evaluations,         ///< places at which a basis was evaluated
  normal_derivatives,  ///< places on faces at which derivatives of order p were evaluated, for a ghost term
  splines,             ///< boundary pieces through which a spline was laid
  traces,              ///< splines that were cut by the lines of a grid
  displacement_fits,   ///< systems for coefficients of a prescribed displacement
  moments,             ///< cells and parts of cells whose moments were taken from the outline
  weight_fits,         ///< cells whose points' weights were fitted to moments
  mass_matrices,       ///< mass matrices, lumped or not
  exact_values,        ///< places at which an exact solution was compared
  factorisations,      ///< of matrices of any system; of multigrid, new hierarchies
  analyses,            ///< orderings of the unknowns of a sparse matrix to limit its fill
  solves,              ///< pairs of triangular solutions, or runs of conjugate gradients
  allocations,         ///< on the heap while points are located, summed and moved, if the program counts them
  count                ///< how many there are
};

using Counts = std::array<long, static_cast<std::size_t>(Work::count)>;

[[nodiscard]] std::string_view name_of(Work work);

/// Adds to the count of this thread.
void count(Work work, long times = 1);

/// Names the function that tells how often the program has allocated memory so far. Without one, nothing is counted: a
/// library cannot stand in for its program's heap.
void count_allocations_by(long (*allocations)());

/// So many there were; 0 where nothing counts them.
[[nodiscard]] long heap_allocations();

/// Counts the allocations while it lives.
class CountedAllocations {
 public:
  CountedAllocations() : before_(heap_allocations()) {}
  ~CountedAllocations() { count(Work::allocations, heap_allocations() - before_); }
  CountedAllocations(const CountedAllocations&) = delete;
  CountedAllocations& operator=(const CountedAllocations&) = delete;

 private:
  long before_;
};

/// Sums over all threads since the program began. Work of other threads that still run may be missing.
[[nodiscard]] Counts counted();

}  // namespace shoreline
