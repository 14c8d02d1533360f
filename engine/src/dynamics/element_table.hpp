#pragma once
// Which functions the elements of a grid see, and which elements see a function: what point passes scatter along.

#include <cstdint>
#include <vector>

#include "shoreline/bases/basis.hpp"

namespace shoreline {

/// Fixed for a basis. The parts of an element see the same functions, each in an order of its own.
struct ElementTable {
  explicit ElementTable(const Basis& basis);

  [[nodiscard]] Index elements() const { return static_cast<Index>(function.size()) / n; }
  [[nodiscard]] Index functions() const { return static_cast<Index>(first.size()) - 1; }
  /// Places of a cell's functions among those of its element, (n).
  [[nodiscard]] const std::uint8_t* place_of(Index cell) const {
    return &place[static_cast<std::size_t>(cell) * static_cast<std::size_t>(n)];
  }

  int parts;                        ///< cells of an element
  int n;                            ///< functions of an element
  std::vector<Index> function;      ///< (elements · n)
  std::vector<std::uint8_t> place;  ///< (cells · n)
  std::vector<Index> first;         ///< (functions + 1) range of each function in slot
  std::vector<Index> slot;          ///< element · n + place, ascending for each function
};

/// The elements that hold material points at one step.
struct OccupiedElements {
  std::vector<Index> element;     ///< (m) ascending
  std::vector<Index> first_cell;  ///< (m + 1) range of each in the list of occupied cells
  std::vector<Index> number;      ///< (elements) place in @ref element, or −1
  std::vector<Index> first;       ///< (functions + 1) range of each function in slot
  std::vector<Index> slot;        ///< place in element · n + place in it, ascending for each function

  /// @param cell  occupied cells, ascending
  /// @return whether they are others than before
  bool find(const ElementTable& table, const std::vector<Index>& cell);

 private:
  void find_slots(const ElementTable& table);
  std::vector<Index> before_;  ///< the elements for which the slots hold
};

/// Sums blocks of K numbers for each function of each occupied element, and calls put(f, sums) with the K
/// sums of every function. Elements come in ascending order: the sums do not depend on the number of threads. To be
/// called by all threads of a parallel region.
template <int K, class Put>
void gather(const OccupiedElements& occupied, const std::vector<double>& blocks, Put&& put) {
  const auto functions = static_cast<Index>(occupied.first.size()) - 1;
#pragma omp for schedule(guided, 64)
  for (Index f = 0; f < functions; ++f) {
    double sum[K] = {};
    for (Index s = occupied.first[static_cast<std::size_t>(f)]; s < occupied.first[static_cast<std::size_t>(f) + 1];
         ++s) {
      const double* const from = &blocks[static_cast<std::size_t>(occupied.slot[static_cast<std::size_t>(s)]) * K];
      for (int k = 0; k < K; ++k) sum[k] += from[k];
    }
    put(f, sum);
  }
}

}  // namespace shoreline
