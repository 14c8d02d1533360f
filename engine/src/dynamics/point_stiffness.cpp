// The pass that finds how the forces change with a small displacement.

#include "point_chunks.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

constexpr double small = 1e-6;  ///< strain by which the law is probed

/// V Δσ of the points of one chunk, by a probe of the law; as (xx, yy, xy, zz).
template <int N>
SHORELINE_INLINE void stress_change(const Chunk<N>& chunk, const MovingPoints& points, const LargeStrainMaterial& law,
                                    const std::array<double, 2 * N>& field,
                                    std::array<LaneTensor, Chunk<N>::most_groups>& change) {
  std::array<LaneTensor, Chunk<N>::most_groups> increment, deformation;
  std::array<Lanes, Chunk<N>::most_groups> largest;
  for (std::size_t q = 0; q < chunk.groups; ++q) {
    const FieldLanes w = field_at<N>(chunk, q, field);
    LaneTensor g{w.xx, w.yx, w.xy, w.yy};
    for (std::size_t l = 0; l < lanes; ++l) {
      largest[q][l] = std::max({std::abs(g[0][l]), std::abs(g[1][l]), std::abs(g[2][l]), std::abs(g[3][l])});
      for (Lanes& entry : g) entry[l] *= largest[q][l] > 0.0 ? small / largest[q][l] : 1.0;
    }
    const LaneTensor d = chunk.load_four(q, points.motion.deformation.data());
    deformation[q] = {d[0] + (g[0] * d[0] + g[2] * d[1]), d[1] + (g[1] * d[0] + g[3] * d[1]),
                      d[2] + (g[0] * d[2] + g[2] * d[3]), d[3] + (g[1] * d[2] + g[3] * d[3])};
    increment[q] = g;
    change[q] = chunk.load_four(q, points.state.stress.data());
  }
  law.update({change.data(), chunk.groups}, {increment.data(), chunk.groups}, {deformation.data(), chunk.groups});
  for (std::size_t q = 0; q < chunk.groups; ++q) {
    const LaneTensor before = chunk.load_four(q, points.state.stress.data());
    const Lanes factor = chunk.load_once(q, points.weight.data()) * largest[q] / small;
    for (std::size_t k = 0; k < 4; ++k) change[q][k] = factor * (change[q][k] - before[k]);
  }
}

/// K w of some elements.
SHORELINE_CLONES void stiffness_times_on(Index begin, Index end, const Basis& basis, const ElementTable& table,
                                         const PointCells& cells, const MovingPoints& points,
                                         const LargeStrainMaterial& law, const Eigen::Matrix2Xd& field,
                                         std::vector<double>& blocks) {
  const PointSupports& supports = cells.supports;
  with_functions(table.n, [&]<int N>(std::integral_constant<int, N>) SHORELINE_INLINED {
    for_elements<N, 2>(table, cells, begin, end, blocks, [&](Index, Index c, double* to) SHORELINE_INLINED {
      const auto local = coefficients<N>(table, supports.cell[at(c)], field);
      std::array<LaneTensor, Chunk<N>::most_groups> change;
      for_chunks<N, Needs::gradients>(basis, points.state, supports, c, [&](const Chunk<N>& chunk) SHORELINE_INLINED {
        stress_change<N>(chunk, points, law, local, change);
        std::array<Lanes, 2 * N> sum{};
        for (std::size_t q = 0; q < chunk.groups; ++q)
          add_divergence<N>(chunk, q, change[q][0], change[q][1], change[q][2], 2, sum.data());
        put_sums(sum, !chunk.is_first, to);
      });
    });
  });
}

}  // namespace

void PointPasses::stiffness_times(const MovingPoints& points, const PointCells& cells, const LargeStrainMaterial& law,
                                  const Eigen::Matrix2Xd& field, Eigen::Matrix2Xd& force) {
  const auto elements = cells.occupied.element.size();
  force.resize(2, table_.functions());
  blocks_.resize(elements * at(table_.n) * 2);
#pragma omp parallel if (worth_threads(cells.supports.point.size()))
  {
    for_ranges(static_cast<Index>(elements), [&](Index begin, Index end) {
      stiffness_times_on(begin, end, basis_, table_, cells, points, law, field, blocks_);
    });
    gather<2>(cells.occupied, blocks_, [&](Index f, const double* s) { force.col(f) << s[0], s[1]; });
  }
}

}  // namespace shoreline
