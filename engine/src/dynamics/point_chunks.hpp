#pragma once
// Material points of one cell, four side by side, with the basis there; what the passes over the points are made of.

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <type_traits>

#include "../threads.hpp"
#include "point_passes.hpp"

namespace shoreline {

/// Up to 16 points of one cell in fours. Where one lacks points, the last stands in for them: what is worked out for it
/// is worked out alike, and may be stored again.
template <int N>
struct Chunk {
  static constexpr std::size_t most = 16;
  static constexpr std::size_t most_groups = most / lanes;
  using Points = std::array<std::size_t, lanes>;

  bool is_first;  ///< of its cell
  std::size_t count;
  std::size_t groups;
  std::array<Points, most_groups> point;
  std::array<LanePoint, most_groups> x;
  std::array<Lanes, most_groups * N> value;         ///< value[q·N + a] of group q
  std::array<Lanes, most_groups * 2 * N> gradient;  ///< gradient[q·2N + 2a + d] [1/m]

  SHORELINE_INLINE void take(const Index* from, std::size_t number) {
    count = number;
    groups = (count + lanes - 1) / lanes;
    for (std::size_t q = 0; q < groups; ++q)
      for (std::size_t l = 0; l < lanes; ++l)
        point[q][l] = static_cast<std::size_t>(from[std::min(q * lanes + l, count - 1)]);
  }
  /// Whether a lane is of a point, and of none that stands in.
  [[nodiscard]] SHORELINE_INLINE bool is_point(std::size_t q, std::size_t lane) const {
    return q * lanes + lane < count;
  }

  /// A number of each of four points.
  [[nodiscard]] SHORELINE_INLINE Lanes load(std::size_t q, const double* field) const {
    const Points& p = point[q];
    return Lanes{field[p[0]], field[p[1]], field[p[2]], field[p[3]]};
  }
  /// The same of what is summed over points: zero where a point stands in.
  [[nodiscard]] SHORELINE_INLINE Lanes load_once(std::size_t q, const double* field) const {
    const Points& p = point[q];
    if ((q + 1) * lanes <= count) return load(q, field);
    const auto once = [&](std::size_t l) { return is_point(q, l) ? field[p[l]] : 0.0; };
    return Lanes{once(0), once(1), once(2), 0.0};
  }
  SHORELINE_INLINE void store(std::size_t q, const Lanes& number, double* field) const {
    for (std::size_t l = 0; l < lanes; ++l) field[point[q][l]] = number[l];
  }

  /// A vector of each of four points.
  [[nodiscard]] SHORELINE_INLINE LanePoint load_two(std::size_t q, const double* field) const {
    const auto of = [&](std::size_t l) SHORELINE_INLINED { return *two_at(field + 2 * point[q][l]); };
    const auto even = __builtin_shufflevector(of(0), of(2), 0, 1, 2, 3);
    const auto odd = __builtin_shufflevector(of(1), of(3), 0, 1, 2, 3);
    return {__builtin_shufflevector(even, odd, 0, 4, 2, 6), __builtin_shufflevector(even, odd, 1, 5, 3, 7)};
  }
  SHORELINE_INLINE void store_two(std::size_t q, const LanePoint& vector, double* field) const {
    const auto even = __builtin_shufflevector(vector[0].v, vector[1].v, 0, 4, 2, 6);
    const auto odd = __builtin_shufflevector(vector[0].v, vector[1].v, 1, 5, 3, 7);
    *two_at(field + 2 * point[q][0]) = __builtin_shufflevector(even, even, 0, 1);
    *two_at(field + 2 * point[q][1]) = __builtin_shufflevector(odd, odd, 0, 1);
    *two_at(field + 2 * point[q][2]) = __builtin_shufflevector(even, even, 2, 3);
    *two_at(field + 2 * point[q][3]) = __builtin_shufflevector(odd, odd, 2, 3);
  }

  /// Four numbers of each of four points.
  [[nodiscard]] SHORELINE_INLINE LaneTensor load_four(std::size_t q, const double* field) const {
    const auto of = [&](std::size_t l) SHORELINE_INLINED { return Lanes(*lanes_at(field + 4 * point[q][l])); };
    return transposed({of(0), of(1), of(2), of(3)});
  }
  SHORELINE_INLINE void store_four(std::size_t q, const LaneTensor& tensor, double* field) const {
    const LaneTensor of = transposed(tensor);
    *lanes_at(field + 4 * point[q][0]) = of[0].v;
    *lanes_at(field + 4 * point[q][1]) = of[1].v;
    *lanes_at(field + 4 * point[q][2]) = of[2].v;
    *lanes_at(field + 4 * point[q][3]) = of[3].v;
  }

 private:
  using Two = double __attribute__((vector_size(2 * sizeof(double)), aligned(sizeof(double)), may_alias));
  SHORELINE_INLINE static const Two* two_at(const double* from) { return reinterpret_cast<const Two*>(from); }
  SHORELINE_INLINE static Two* two_at(double* to) { return reinterpret_cast<Two*>(to); }
};

/// What a pass needs of the basis.
enum class Needs { values, gradients };

/// Calls use(chunk) for all points of an occupied cell.
template <int N, Needs needs, class Use>
SHORELINE_INLINE void for_chunks(const Basis& basis, const MaterialPoints& points, const PointSupports& cells, Index c,
                                 Use&& use) {
  Chunk<N> chunk;
  const double* const position = points.position.data();
  const auto at = static_cast<std::size_t>(c);
  const auto first = static_cast<std::size_t>(cells.first[at]);
  const auto end = static_cast<std::size_t>(cells.first[at + 1]);
  for (std::size_t begin = first; begin < end; begin += Chunk<N>::most) {
    chunk.is_first = begin == first;
    chunk.take(&cells.point[begin], std::min(Chunk<N>::most, end - begin));
    for (std::size_t q = 0; q < chunk.groups; ++q) chunk.x[q] = chunk.load_two(q, position);
    basis.evaluate(cells.cell[at], std::span<const LanePoint>(chunk.x.data(), chunk.groups), chunk.value.data(),
                   needs == Needs::gradients ? chunk.gradient.data() : nullptr);
    use(chunk);
  }
}

/// Coefficients of the functions of a cell, in its order.
template <int N>
SHORELINE_INLINE std::array<double, 2 * N> coefficients(const ElementTable& table, Index cell,
                                                        const Eigen::Matrix2Xd& field) {
  std::array<double, 2 * N> local;
  const Index* const function = &table.function[static_cast<std::size_t>(cell / table.parts) * N];
  const std::uint8_t* const place = table.place_of(cell);
  for (std::size_t a = 0; a < N; ++a) {
    const Index f = function[table.parts == 1 ? a : place[a]];
    std::memcpy(&local[2 * a], field.data() + 2 * static_cast<std::ptrdiff_t>(f), 2 * sizeof(double));
  }
  return local;
}

/// (∇v)_ij = Σ v_i ∂_j φ and v of four points.
struct FieldLanes {
  Lanes x, y;
  Lanes xx, xy, yx, yy;
};

template <int N>
SHORELINE_INLINE FieldLanes field_at(const Chunk<N>& chunk, std::size_t q, const std::array<double, 2 * N>& field) {
  const Lanes* const value = &chunk.value[q * N];
  const Lanes* const gradient = &chunk.gradient[q * 2 * N];
  FieldLanes sum{};
  for (std::size_t a = 0; a < N; ++a) {
    const double fx = field[2 * a];
    const double fy = field[2 * a + 1];
    sum.x += value[a] * fx;
    sum.y += value[a] * fy;
    sum.xx += gradient[2 * a] * fx;
    sum.xy += gradient[2 * a + 1] * fx;
    sum.yx += gradient[2 * a] * fy;
    sum.yy += gradient[2 * a + 1] * fy;
  }
  return sum;
}

/// Adds up (xx, yy, xy) times the gradients: the two components of each function.
template <int N>
SHORELINE_INLINE void add_divergence(const Chunk<N>& chunk, std::size_t q, const Lanes& xx, const Lanes& yy,
                                     const Lanes& xy, std::size_t stride, Lanes* sum) {
  const Lanes* const gradient = &chunk.gradient[q * 2 * N];
  for (std::size_t a = 0; a < N; ++a) {
    const Lanes& gx = gradient[2 * a];
    const Lanes& gy = gradient[2 * a + 1];
    sum[stride * a] += xx * gx + xy * gy;
    sum[stride * a + 1] += xy * gx + yy * gy;
  }
}

/// Calls use<N> with the number of functions of an element.
template <class Use>
SHORELINE_INLINE void with_functions(int n, Use&& use) {
  switch (n) {
    case 3:
      return use(std::integral_constant<int, 3>());
    case 4:
      return use(std::integral_constant<int, 4>());
    case 9:
      return use(std::integral_constant<int, 9>());
    case 16:
      return use(std::integral_constant<int, 16>());
    default:
      throw InvalidArgument("explicit dynamics: no kernel for " + std::to_string(n) + " functions a cell");
  }
}

/// For occupied elements begin … end − 1: calls use(e, c, sum) for their cells, which gives K numbers for each function
/// of the cell, and adds them up in the element's block.
template <int N, int K, class Use>
SHORELINE_INLINE void for_elements(const ElementTable& table, const PointCells& cells, Index begin, Index end,
                                   std::vector<double>& blocks, Use&& use) {
  const auto& occupied = cells.occupied;
  for (Index e = begin; e < end; ++e) {
    double* const block = &blocks[static_cast<std::size_t>(e) * N * K];
    const Index first = occupied.first_cell[static_cast<std::size_t>(e)];
    if (table.parts == 1) {  // the one cell has its functions in the order of the element
      use(e, first, block);
      continue;
    }
    std::fill(block, block + N * K, 0.0);
    for (Index c = first; c < occupied.first_cell[static_cast<std::size_t>(e) + 1]; ++c) {
      std::array<double, N * K> sum{};
      use(e, c, sum.data());
      const std::uint8_t* const place = table.place_of(cells.supports.cell[static_cast<std::size_t>(c)]);
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t k = 0; k < K; ++k) block[place[a] * K + k] += sum[a * K + k];
    }
  }
}

/// Shares the numbers 0 … count − 1 among threads: calls use(begin, end). To be called by all threads of a parallel
/// region.
template <class Use>
void for_ranges(Index count, Use&& use) {
  constexpr Index most = 64;
#pragma omp for schedule(guided)
  for (Index r = 0; r < (count + most - 1) / most; ++r) use(r * most, std::min((r + 1) * most, count));
}

}  // namespace shoreline
