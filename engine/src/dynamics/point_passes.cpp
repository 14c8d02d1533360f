#include "point_passes.hpp"

#include "point_chunks.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Mass and force of one chunk.
template <int N>
void add_mass_and_force(const Chunk<N>& chunk, const MovingPoints& points, double* sum) {
  std::array<Lanes, Chunk<N>::most_pairs> mass, xx, yy, xy;
  const double* const stress = points.state.stress.data();
  for (std::size_t q = 0; q < chunk.pairs; ++q) {
    mass[q] = chunk.load_once(q, points.motion.mass);
    const Lanes volume = chunk.load_once(q, points.weight);
    const auto [normal_x, normal_y] = chunk.load_two(q, stress, 4, 0);
    xx[q] = volume * normal_x;
    yy[q] = volume * normal_y;
    xy[q] = volume * chunk.load(q, stress, 4, 2);
  }
  for (std::size_t a = 0; a < N; ++a) {
    Lanes m = Lanes::Zero();
    Lanes fx = Lanes::Zero();
    Lanes fy = Lanes::Zero();
    for (std::size_t q = 0; q < chunk.pairs; ++q) {
      const Lanes& gx = chunk.gradient[q * 2 * N + 2 * a];
      const Lanes& gy = chunk.gradient[q * 2 * N + 2 * a + 1];
      m += mass[q] * chunk.value[q * N + a];
      fx += xx[q] * gx + xy[q] * gy;
      fy += xy[q] * gx + yy[q] * gy;
    }
    put_or_add(chunk.is_first, m.sum(), sum[3 * a]);
    put_or_add(chunk.is_first, -fx.sum(), sum[3 * a + 1]);
    put_or_add(chunk.is_first, -fy.sum(), sum[3 * a + 2]);
  }
}

/// Σ φ_i f_p of one chunk.
template <int N>
void add_load(const Chunk<N>& chunk, const Eigen::Matrix2Xd& load, double* sum) {
  for (Index k = 0; k < chunk.count; ++k) {
    const Vec2 force = load.col(chunk.point[k]);
    for (std::size_t a = 0; a < N; ++a) {
      const double value = chunk.value[at(k / 2) * N + a][k % 2];
      sum[3 * a + 1] += force.x() * value;
      sum[3 * a + 2] += force.y() * value;
    }
  }
}

/// Element mass of one chunk, in the order of the element's functions.
template <int N>
void add_mass_block(const Chunk<N>& chunk, const PointMotion& motion, const std::uint8_t* place, double* block) {
  std::array<Lanes, Chunk<N>::most_pairs> mass, part;
  for (std::size_t q = 0; q < chunk.pairs; ++q) mass[q] = chunk.load_once(q, motion.mass);
  for (std::size_t a = 0; a < N; ++a) {
    for (std::size_t q = 0; q < chunk.pairs; ++q) part[q] = mass[q] * chunk.value[q * N + a];
    for (std::size_t b = 0; b <= a; ++b) {
      Lanes sum = Lanes::Zero();
      for (std::size_t q = 0; q < chunk.pairs; ++q) sum += part[q] * chunk.value[q * N + b];
      block[place[a] * N + place[b]] += sum.sum();
      if (b < a) block[place[b] * N + place[a]] += sum.sum();
    }
  }
}

/// Accelerates the points of one chunk and adds their momentum.
template <int N>
void add_momentum(const Chunk<N>& chunk, PointMotion& motion, const std::array<double, 2 * N>& field, double dt,
                  double* sum) {
  std::array<Lanes, Chunk<N>::most_pairs> px, py;
  double* const velocity = motion.velocity.data();
  for (std::size_t q = 0; q < chunk.pairs; ++q) {
    const Lanes* const value = &chunk.value[q * N];
    Lanes ax = value[0] * field[0];
    Lanes ay = value[0] * field[1];
    for (std::size_t a = 1; a < N; ++a) {
      ax += value[a] * field[2 * a];
      ay += value[a] * field[2 * a + 1];
    }
    const auto [before_x, before_y] = chunk.load_two(q, velocity, 2, 0);
    const Lanes vx = before_x + dt * ax;
    const Lanes vy = before_y + dt * ay;
    const auto [first, second] = transposed(vx, vy);
    motion.velocity.col(chunk.first(q)) = first;
    if (chunk.is_whole(q)) motion.velocity.col(chunk.second(q)) = second;
    const Lanes mass = chunk.load_once(q, motion.mass);
    px[q] = mass * vx;
    py[q] = mass * vy;
  }
  for (std::size_t a = 0; a < N; ++a) {
    Lanes x = Lanes::Zero();
    Lanes y = Lanes::Zero();
    for (std::size_t q = 0; q < chunk.pairs; ++q) {
      x += chunk.value[q * N + a] * px[q];
      y += chunk.value[q * N + a] * py[q];
    }
    put_or_add(chunk.is_first, x.sum(), sum[2 * a]);
    put_or_add(chunk.is_first, y.sum(), sum[2 * a + 1]);
  }
}

}  // namespace

void PointPasses::mass_and_force(const MovingPoints& points, const PointCells& cells, const Eigen::Matrix2Xd& load,
                                 bool with_blocks, GridSums& sums) {
  const auto elements = cells.occupied.element.size();
  sums.mass.resize(table_.functions());
  sums.force.resize(2, table_.functions());
  with_functions(table_.n, [&]<int N>(std::integral_constant<int, N>) {
    blocks_.resize(elements * N * 3);
    if (with_blocks) sums.block.assign(elements * N * N, 0.0);
#pragma omp parallel if (worth_threads(cells.supports.point.size()))
    {
      for_elements<N, 3>(table_, cells, blocks_, [&](Index e, Index c, double* sum) {
        const Index cell = cells.supports.cell[at(c)];
        for_chunks<N, Needs::gradients>(basis_, points.state, cells.supports, c, [&](const Chunk<N>& chunk) {
          add_mass_and_force<N>(chunk, points, sum);
          if (load.cols() > 0) add_load<N>(chunk, load, sum);
          if (with_blocks) add_mass_block<N>(chunk, points.motion, table_.place_of(cell), &sums.block[at(e) * N * N]);
        });
      });
      gather<3>(cells.occupied, blocks_, [&](Index f, const double* sum) {
        sums.mass[f] = sum[0];
        sums.force.col(f) << sum[1], sum[2];
      });
    }
  });
}

void PointPasses::accelerate(const MovingPoints& points, const PointCells& cells, const Eigen::Matrix2Xd& acceleration,
                             double dt, Eigen::Matrix2Xd& momentum) {
  momentum.resize(2, table_.functions());
  with_functions(table_.n, [&]<int N>(std::integral_constant<int, N>) {
    blocks_.resize(cells.occupied.element.size() * N * 2);
#pragma omp parallel if (worth_threads(cells.supports.point.size()))
    {
      for_elements<N, 2>(table_, cells, blocks_, [&](Index, Index c, double* sum) {
        const Index cell = cells.supports.cell[at(c)];
        const auto field = coefficients<N>(table_, cell, acceleration);
        for_chunks<N, Needs::values>(basis_, points.state, cells.supports, c, [&](const Chunk<N>& chunk) {
          add_momentum<N>(chunk, points.motion, field, dt, sum);
        });
      });
      gather<2>(cells.occupied, blocks_, [&](Index f, const double* sum) { momentum.col(f) << sum[0], sum[1]; });
    }
  });
}

}  // namespace shoreline
