#pragma once
// A symmetric matrix with both its halves.

#include "shoreline/engine/assembler.hpp"

namespace shoreline {

/// Both halves from the lower one; columns with ascending rows, so that it reads by rows as well.
[[nodiscard]] inline SparseMatrix both_halves(const SparseMatrix& lower) {
  SparseMatrix a;
  a.size = lower.size;
  a.column.assign(static_cast<std::size_t>(lower.size) + 1, 0);
  const auto each = [&](auto&& use) {
    for (Index j = 0; j < lower.size; ++j)
      for (Index k = lower.column[static_cast<std::size_t>(j)]; k < lower.column[static_cast<std::size_t>(j) + 1];
           ++k) {
        const Index i = lower.row[static_cast<std::size_t>(k)];
        if (i != j) use(i, j, lower.value[static_cast<std::size_t>(k)]);
        use(j, i, lower.value[static_cast<std::size_t>(k)]);
      }
  };
  each([&](Index column, Index, double) { ++a.column[static_cast<std::size_t>(column) + 1]; });
  for (std::size_t j = 0; j < static_cast<std::size_t>(a.size); ++j) a.column[j + 1] += a.column[j];
  a.row.resize(static_cast<std::size_t>(a.column.back()));
  a.value.resize(a.row.size());
  std::vector<Index> next(a.column.begin(), a.column.end() - 1);
  each([&](Index column, Index row, double v) {
    const auto k = static_cast<std::size_t>(next[static_cast<std::size_t>(column)]++);
    a.row[k] = row;
    a.value[k] = v;
  });
  return a;
}

}  // namespace shoreline
