// The pass that finds how the forces change with a small displacement.

#include "point_chunks.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

constexpr double small = 1e-6;  ///< strain by which the law is probed

/// V Δσ of the points of one chunk, by a probe of the law; as (xx, yy, xy, zz).
template <int N>
void stress_change(const Chunk<N>& chunk, const MovingPoints& points, const LargeStrainMaterial& law,
                   const std::array<double, 2 * N>& field, std::array<Stress, Chunk<N>::most>& change) {
  constexpr std::size_t most = Chunk<N>::most;
  const std::size_t count = at(chunk.count);
  std::array<Mat2, most> increment, deformation;
  std::array<double, most> largest;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t q = k / 2;
    const auto lane = static_cast<Eigen::Index>(k % 2);
    const FieldLanes w = field_at<N>(&chunk.value[q * N], &chunk.gradient[q * 2 * N], field);
    increment[k] << w.xx[lane], w.xy[lane], w.yx[lane], w.yy[lane];
    largest[k] = increment[k].cwiseAbs().maxCoeff();
    if (largest[k] > 0.0) increment[k] *= small / largest[k];
    const Eigen::Map<const Mat2> d(points.motion.deformation.data() + 4 * static_cast<std::ptrdiff_t>(chunk.point[k]));
    deformation[k] = d + increment[k] * d;
    change[k] = points.state.stress.col(chunk.point[k]);
  }
  law.update({change.data(), count}, {increment.data(), count}, {deformation.data(), count});
  for (std::size_t k = 0; k < count; ++k) {
    const Index p = chunk.point[k];
    change[k] = points.weight[p] * largest[k] / small * (change[k] - points.state.stress.col(p));
  }
}

}  // namespace

void PointPasses::stiffness_times(const MovingPoints& points, const PointCells& cells, const LargeStrainMaterial& law,
                                  const Eigen::Matrix2Xd& field, Eigen::Matrix2Xd& force) {
  force.resize(2, table_.functions());
  with_functions(table_.n, [&]<int N>(std::integral_constant<int, N>) {
    blocks_.resize(cells.occupied.element.size() * N * 2);
#pragma omp parallel if (worth_threads(cells.supports.point.size()))
    {
      for_elements<N, 2>(table_, cells, blocks_, [&](Index, Index c, double* sum) {
        const Index cell = cells.supports.cell[at(c)];
        const auto local = coefficients<N>(table_, cell, field);
        std::fill(sum, sum + 2 * N, 0.0);
        std::array<Stress, Chunk<N>::most> change;
        for_chunks<N, Needs::gradients>(basis_, points.state, cells.supports, c, [&](const Chunk<N>& chunk) {
          stress_change<N>(chunk, points, law, local, change);
          for (std::size_t a = 0; a < N; ++a)
            for (std::size_t k = 0; k < at(chunk.count); ++k) {
              const double gx = chunk.gradient[k / 2 * 2 * N + 2 * a][static_cast<Eigen::Index>(k % 2)];
              const double gy = chunk.gradient[k / 2 * 2 * N + 2 * a + 1][static_cast<Eigen::Index>(k % 2)];
              sum[2 * a] += change[k][0] * gx + change[k][2] * gy;
              sum[2 * a + 1] += change[k][2] * gx + change[k][1] * gy;
            }
        });
      });
      gather<2>(cells.occupied, blocks_, [&](Index f, const double* s) { force.col(f) << s[0], s[1]; });
    }
  });
}

}  // namespace shoreline
