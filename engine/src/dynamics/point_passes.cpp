#include "point_passes.hpp"

#include "point_chunks.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Mass and force of one chunk.
template <int N>
SHORELINE_INLINE void add_mass_and_force(const Chunk<N>& chunk, const MovingPoints& points, double* to) {
  std::array<Lanes, 3 * N> sum{};
  for (std::size_t q = 0; q < chunk.groups; ++q) {
    const Lanes mass = chunk.load_once(q, points.motion.mass.data());
    const Lanes volume = -chunk.load_once(q, points.weight.data());
    const LaneTensor stress = chunk.load_four(q, points.state.stress.data());
    for (std::size_t a = 0; a < N; ++a) sum[3 * a] += mass * chunk.value[q * N + a];
    add_divergence<N>(chunk, q, volume * stress[0], volume * stress[1], volume * stress[2], 3, &sum[1]);
  }
  put_sums(sum, !chunk.is_first, to);
}

/// Σ φ_i f_p of one chunk.
template <int N>
SHORELINE_INLINE void add_load(const Chunk<N>& chunk, const Eigen::Matrix2Xd& load, double* sum) {
  for (std::size_t k = 0; k < chunk.count; ++k) {
    const double* const force = load.data() + 2 * chunk.point[k / lanes][k % lanes];
    for (std::size_t a = 0; a < N; ++a) {
      const double value = chunk.value[k / lanes * N + a][k % lanes];
      sum[3 * a + 1] += force[0] * value;
      sum[3 * a + 2] += force[1] * value;
    }
  }
}

/// Element mass of one chunk, in the order of the element's functions.
template <int N>
SHORELINE_INLINE void add_mass_block(const Chunk<N>& chunk, const PointMotion& motion, const std::uint8_t* place,
                                     double* block) {
  std::array<Lanes, Chunk<N>::most_groups> mass, part;
  for (std::size_t q = 0; q < chunk.groups; ++q) mass[q] = chunk.load_once(q, motion.mass.data());
  for (std::size_t a = 0; a < N; ++a) {
    for (std::size_t q = 0; q < chunk.groups; ++q) part[q] = mass[q] * chunk.value[q * N + a];
    for (std::size_t b = 0; b <= a; ++b) {
      Lanes sum{};
      for (std::size_t q = 0; q < chunk.groups; ++q) sum += part[q] * chunk.value[q * N + b];
      const double entry = sum_of(sum);
      block[place[a] * N + place[b]] += entry;
      if (b < a) block[place[b] * N + place[a]] += entry;
    }
  }
}

/// Accelerates the points of one chunk and adds their momentum.
template <int N>
SHORELINE_INLINE void add_momentum(const Chunk<N>& chunk, PointMotion& motion, const std::array<double, 2 * N>& field,
                                   double dt, double* to) {
  std::array<Lanes, 2 * N> sum{};
  for (std::size_t q = 0; q < chunk.groups; ++q) {
    const Lanes* const value = &chunk.value[q * N];
    Lanes ax{}, ay{};
    for (std::size_t a = 0; a < N; ++a) {
      ax += value[a] * field[2 * a];
      ay += value[a] * field[2 * a + 1];
    }
    LanePoint v = chunk.load_two(q, motion.velocity.data());
    v[0] += dt * ax;
    v[1] += dt * ay;
    chunk.store_two(q, v, motion.velocity.data());
    const Lanes mass = chunk.load_once(q, motion.mass.data());
    const Lanes px = mass * v[0];
    const Lanes py = mass * v[1];
    for (std::size_t a = 0; a < N; ++a) {
      sum[2 * a] += value[a] * px;
      sum[2 * a + 1] += value[a] * py;
    }
  }
  put_sums(sum, !chunk.is_first, to);
}

/// What a pass reads beside the points.
struct Ground {
  const Basis& basis;
  const ElementTable& table;
  const PointCells& cells;
};

/// Mass and force of some elements.
SHORELINE_CLONES void mass_and_force_of(Index begin, Index end, const Ground& on, const MovingPoints& points,
                                        const Eigen::Matrix2Xd& load, std::vector<double>& blocks,
                                        std::vector<double>& mass_block) {
  const PointSupports& supports = on.cells.supports;
  with_functions(on.table.n, [&]<int N>(std::integral_constant<int, N>) SHORELINE_INLINED {
    for_elements<N, 3>(on.table, on.cells, begin, end, blocks, [&](Index e, Index c, double* sum) SHORELINE_INLINED {
      for_chunks<N, Needs::gradients>(
          on.basis, points.state, supports, c, [&](const Chunk<N>& chunk) SHORELINE_INLINED {
            add_mass_and_force<N>(chunk, points, sum);
            if (load.cols() > 0) add_load<N>(chunk, load, sum);
            if (!mass_block.empty())
              add_mass_block<N>(chunk, points.motion, on.table.place_of(supports.cell[at(c)]),
                                &mass_block[at(e) * N * N]);
          });
    });
  });
}

/// Accelerates the points of some elements and sums their momentum.
SHORELINE_CLONES void accelerate_on(Index begin, Index end, const Ground& on, const MovingPoints& points,
                                    const Eigen::Matrix2Xd& acceleration, double dt, std::vector<double>& blocks) {
  const PointSupports& supports = on.cells.supports;
  with_functions(on.table.n, [&]<int N>(std::integral_constant<int, N>) SHORELINE_INLINED {
    for_elements<N, 2>(on.table, on.cells, begin, end, blocks, [&](Index, Index c, double* sum) SHORELINE_INLINED {
      const auto field = coefficients<N>(on.table, supports.cell[at(c)], acceleration);
      for_chunks<N, Needs::values>(on.basis, points.state, supports, c, [&](const Chunk<N>& chunk) SHORELINE_INLINED {
        add_momentum<N>(chunk, points.motion, field, dt, sum);
      });
    });
  });
}

}  // namespace

void PointPasses::mass_and_force(const MovingPoints& points, const PointCells& cells, const Eigen::Matrix2Xd& load,
                                 bool with_blocks, GridSums& sums) {
  const auto elements = cells.occupied.element.size();
  const auto n = at(table_.n);
  sums.mass.resize(table_.functions());
  sums.force.resize(2, table_.functions());
  blocks_.resize(elements * n * 3);
  sums.block.assign(with_blocks ? elements * n * n : 0, 0.0);
#pragma omp parallel if (worth_threads(cells.supports.point.size()))
  {
    for_ranges(static_cast<Index>(elements), [&](Index begin, Index end) {
      mass_and_force_of(begin, end, {basis_, table_, cells}, points, load, blocks_, sums.block);
    });
    gather<3>(cells.occupied, blocks_, [&](Index f, const double* sum) {
      sums.mass[f] = sum[0];
      sums.force.col(f) << sum[1], sum[2];
    });
  }
}

void PointPasses::accelerate(const MovingPoints& points, const PointCells& cells, const Eigen::Matrix2Xd& acceleration,
                             double dt, Eigen::Matrix2Xd& momentum) {
  const auto elements = cells.occupied.element.size();
  momentum.resize(2, table_.functions());
  blocks_.resize(elements * at(table_.n) * 2);
#pragma omp parallel if (worth_threads(cells.supports.point.size()))
  {
    for_ranges(static_cast<Index>(elements), [&](Index begin, Index end) {
      accelerate_on(begin, end, {basis_, table_, cells}, points, acceleration, dt, blocks_);
    });
    gather<2>(cells.occupied, blocks_, [&](Index f, const double* sum) { momentum.col(f) << sum[0], sum[1]; });
  }
}

}  // namespace shoreline
