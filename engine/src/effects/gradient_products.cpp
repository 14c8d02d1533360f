#include "gradient_products.hpp"

#include "shoreline/bases/lanes.hpp"

namespace shoreline {
namespace {

/// Four numbers that are worked on at once, and such numbers anywhere in memory.
using Four = double __attribute__((vector_size(32)));
using FourInMemory = double __attribute__((vector_size(32), aligned(8), may_alias));

/// Adds to groups × 4 rows and 4 columns, whose sums stay in registers.
template <int n, int groups>
SHORELINE_INLINE void add_tile(std::span<const double> volume, const double* g, int row, int column, double* moments) {
  constexpr int size = padded(n);
  Four sum[groups][4];
  for (int r = 0; r < groups; ++r)
    for (int c = 0; c < 4; ++c)
      sum[r][c] = *reinterpret_cast<const FourInMemory*>(moments + (column + c) * size + row + 4 * r);
  for (const double v : volume) {
    Four weighted[groups];
    for (int r = 0; r < groups; ++r) weighted[r] = v * *reinterpret_cast<const FourInMemory*>(g + row + 4 * r);
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < groups; ++r) sum[r][c] += g[column + c] * weighted[r];
    g += 2 * n;
  }
  for (int r = 0; r < groups; ++r)
    for (int c = 0; c < 4; ++c)
      *reinterpret_cast<FourInMemory*>(moments + (column + c) * size + row + 4 * r) = sum[r][c];
}

/// What lies beyond 2n rows and columns sums numbers of the next point, and is not used.
template <int n>
SHORELINE_INLINE void add_lower_half(std::span<const double> volume, const double* g, double* moments) {
  for (int column = 0; column < padded(n); column += 4) {
    int row = column;
    for (; row + 8 <= padded(n); row += 8) add_tile<n, 2>(volume, g, row, column, moments);
    if (row < padded(n)) add_tile<n, 1>(volume, g, row, column, moments);
  }
}

template <int n>
SHORELINE_INLINE void add_rows(std::span<const double> factor, const double* g, double* sums) {
  constexpr int groups = padded(n) / 4;
  for (int group = 0; group < groups; ++group) {
    Four sum[4];
    for (int k = 0; k < 4; ++k) sum[k] = *reinterpret_cast<const FourInMemory*>(sums + k * padded(n) + 4 * group);
    const double* of_point = g + 4 * group;
    for (std::size_t p = 0; p < factor.size(); p += 4, of_point += 2 * n)
      for (std::size_t k = 0; k < 4; ++k) sum[k] += factor[p + k] * *reinterpret_cast<const FourInMemory*>(of_point);
    for (int k = 0; k < 4; ++k) *reinterpret_cast<FourInMemory*>(sums + k * padded(n) + 4 * group) = sum[k];
  }
}

}  // namespace

SHORELINE_CLONES void add_sums(int n, std::span<const double> factor, const double* gradient, double* sums) {
  switch (n) {
    case 3:
      return add_rows<3>(factor, gradient, sums);
    case 4:
      return add_rows<4>(factor, gradient, sums);
    case 9:
      return add_rows<9>(factor, gradient, sums);
    default:
      return add_rows<16>(factor, gradient, sums);
  }
}

SHORELINE_CLONES void add_products(int n, std::span<const double> volume, const double* gradient, double* moments) {
  switch (n) {
    case 3:
      return add_lower_half<3>(volume, gradient, moments);
    case 4:
      return add_lower_half<4>(volume, gradient, moments);
    case 9:
      return add_lower_half<9>(volume, gradient, moments);
    default:
      return add_lower_half<16>(volume, gradient, moments);
  }
}

}  // namespace shoreline
