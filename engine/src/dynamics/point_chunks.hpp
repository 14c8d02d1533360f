#pragma once
// Material points of one cell, two side by side, with the basis there; what the passes over the points are made of.

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>

#include "../threads.hpp"
#include "point_passes.hpp"

namespace shoreline {

/// Two numbers of each of two points: from the points' order to that of lanes, or back.
inline LanePoint transposed(const Lanes& a, const Lanes& b) {
  Eigen::Array22d both;
  both << a, b;
  both.transposeInPlace();
  return {both.col(0), both.col(1)};
}

/// Up to 16 points of one cell in pairs. Where their number is odd, the last one makes a pair with itself.
template <int N>
struct Chunk {
  static constexpr Index most = 16;
  static constexpr std::size_t most_pairs = most / 2;

  bool is_first;  ///< of its cell
  Index count;
  std::size_t pairs;
  const Index* point;
  std::array<LanePoint, most_pairs> x;
  std::array<Lanes, most_pairs * N> value;         ///< value[q·N + a] of pair q
  std::array<Lanes, most_pairs * 2 * N> gradient;  ///< gradient[q·2N + 2a + d] [1/m]

  [[nodiscard]] Index first(std::size_t q) const { return point[2 * q]; }
  [[nodiscard]] Index second(std::size_t q) const { return point[2 * q + (is_whole(q) ? 1 : 0)]; }
  /// Whether a pair is of two points.
  [[nodiscard]] bool is_whole(std::size_t q) const { return static_cast<Index>(2 * q + 1) < count; }

  /// A number of each of two points: entry @p k of a field with @p rows numbers a point.
  [[nodiscard]] Lanes load(std::size_t q, const double* field, std::ptrdiff_t rows, std::ptrdiff_t k) const {
    return {field[rows * first(q) + k], field[rows * second(q) + k]};
  }
  /// The same for entries k and k + 1.
  [[nodiscard]] LanePoint load_two(std::size_t q, const double* field, std::ptrdiff_t rows, std::ptrdiff_t k) const {
    return transposed(Eigen::Map<const Lanes>(field + rows * first(q) + k),
                      Eigen::Map<const Lanes>(field + rows * second(q) + k));
  }
  /// The same of what is summed over points: zero where a point stands in.
  [[nodiscard]] Lanes load_once(std::size_t q, const Eigen::VectorXd& field) const {
    return {field[first(q)], is_whole(q) ? field[point[2 * q + 1]] : 0.0};
  }
};

/// What a pass needs of the basis.
enum class Needs { values, gradients };

/// Calls use(chunk) for all points of an occupied cell.
template <int N, Needs needs, class Use>
void for_chunks(const Basis& basis, const MaterialPoints& points, const PointSupports& cells, Index c, Use&& use) {
  Chunk<N> chunk;
  const double* const position = points.position.data();
  const auto at = static_cast<std::size_t>(c);
  for (Index begin = cells.first[at]; begin < cells.first[at + 1]; begin += Chunk<N>::most) {
    chunk.is_first = begin == cells.first[at];
    chunk.count = std::min(Chunk<N>::most, cells.first[at + 1] - begin);
    chunk.pairs = static_cast<std::size_t>(chunk.count + 1) / 2;
    chunk.point = &cells.point[static_cast<std::size_t>(begin)];
    for (std::size_t q = 0; q < chunk.pairs; ++q) chunk.x[q] = chunk.load_two(q, position, 2, 0);
    basis.evaluate(cells.cell[at], std::span<const LanePoint>(chunk.x.data(), chunk.pairs), chunk.value.data(),
                   needs == Needs::gradients ? chunk.gradient.data() : nullptr);
    use(chunk);
  }
}

/// Coefficients of the functions of a cell, in its order.
template <int N>
std::array<double, 2 * N> coefficients(const ElementTable& table, Index cell, const Eigen::Matrix2Xd& field) {
  std::array<double, 2 * N> local;
  const Index* const function = &table.function[static_cast<std::size_t>(cell / table.parts) * N];
  const auto copy = [&](std::size_t a, Index f) {
    const double* const from = field.data() + 2 * static_cast<std::ptrdiff_t>(f);
    local[2 * a] = from[0];
    local[2 * a + 1] = from[1];
  };
  if (table.parts == 1) {
    for (std::size_t a = 0; a < N; ++a) copy(a, function[a]);
    return local;
  }
  const std::uint8_t* const place = table.place_of(cell);
  for (std::size_t a = 0; a < N; ++a) copy(a, function[place[a]]);
  return local;
}

/// (∇v)_ij = Σ v_i ∂_j φ and v of a pair of points.
struct FieldLanes {
  Lanes x, y;
  Lanes xx, xy, yx, yy;
};

template <int N>
FieldLanes field_at(const Lanes* value, const Lanes* gradient, const std::array<double, 2 * N>& field) {
  const Lanes zero = Lanes::Zero();
  FieldLanes sum{zero, zero, zero, zero, zero, zero};
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

/// Calls use<N> with the number of functions of an element.
template <class Use>
void with_functions(int n, Use&& use) {
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

/// For every occupied element: calls use(e, c, sum) for its cells, which gives K numbers for each function of the cell,
/// and adds them up in the element's block. To be called by all threads of a parallel region.
template <int N, int K, class Use>
void for_elements(const ElementTable& table, const PointCells& cells, std::vector<double>& blocks, Use&& use) {
  const auto& occupied = cells.occupied;
#pragma omp for schedule(guided, 64)
  for (Index e = 0; e < static_cast<Index>(occupied.element.size()); ++e) {
    double* const block = &blocks[static_cast<std::size_t>(e) * N * K];
    const Index begin = occupied.first_cell[static_cast<std::size_t>(e)];
    const Index end = occupied.first_cell[static_cast<std::size_t>(e) + 1];
    if (table.parts == 1) {  // the one cell has its functions in the order of the element
      use(e, begin, block);
      continue;
    }
    std::fill(block, block + N * K, 0.0);
    for (Index c = begin; c < end; ++c) {
      std::array<double, N * K> sum;
      use(e, c, sum.data());
      const std::uint8_t* const place = table.place_of(cells.supports.cell[static_cast<std::size_t>(c)]);
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t k = 0; k < K; ++k) block[place[a] * K + k] += sum[a * K + k];
    }
  }
}

/// Sets a sum, or adds to it where there is one already.
inline void put_or_add(bool put, double number, double& sum) { sum = put ? number : sum + number; }

}  // namespace shoreline
