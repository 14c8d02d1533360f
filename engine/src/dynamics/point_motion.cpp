// The pass that moves the points.

#include <cmath>
#include <limits>

#include "point_chunks.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Points of a chunk that can go on, side by side for law and grid.
template <int N>
struct Moving {
  static constexpr std::size_t most = Chunk<N>::most;

  std::size_t count = 0;
  std::array<Index, most> point;
  std::array<Mat2, most> increment;
  std::array<Mat2, most> deformation;
  std::array<Stress, most> stress;
  std::array<Vec2, most> position;
  std::array<Index, most> cell;
};

/// How a pair of points goes and deforms in a step.
struct Step {
  Lanes x, y;                    ///< displacement [m]
  Lanes xx, yx, xy, yy;          ///< Δt ∇v
  Lanes d_xx, d_yx, d_xy, d_yy;  ///< D at the end
  Lanes j;                       ///< det D
};

/// What holds a point of a pair, if anything.
/// @param farthest  that it may go in one step [m]
inline Fault fault_of(const Step& step, int lane, double farthest) {
  const double j = step.j[lane];
  const double way = step.x[lane] * step.x[lane] + step.y[lane] * step.y[lane];
  if (j > 0.0 && j <= std::numeric_limits<double>::max() && way <= farthest * farthest) return Fault::none;
  if (!std::isfinite(j + way)) return Fault::not_finite;
  return j <= 0.0 ? Fault::inverted : Fault::too_fast;
}

/// @param d  deformation gradient at the start, as PointMotion has it
inline Step step_of(const FieldLanes& field, const LanePoint& d_x, const LanePoint& d_y, double dt) {
  Step s;
  s.x = dt * field.x;
  s.y = dt * field.y;
  s.xx = dt * field.xx;
  s.yx = dt * field.yx;
  s.xy = dt * field.xy;
  s.yy = dt * field.yy;
  s.d_xx = d_x[0] + (s.xx * d_x[0] + s.xy * d_x[1]);
  s.d_yx = d_x[1] + (s.yx * d_x[0] + s.yy * d_x[1]);
  s.d_xy = d_y[0] + (s.xx * d_y[0] + s.xy * d_y[1]);
  s.d_yy = d_y[1] + (s.yx * d_y[0] + s.yy * d_y[1]);
  s.j = s.d_xx * s.d_yy - s.d_xy * s.d_yx;
  return s;
}

/// Moves a pair of points, of which the second may stand in; those that cannot go on stay.
template <int N>
void move_pair(const Chunk<N>& chunk, std::size_t q, const MovingPoints& points, const FieldLanes& field,
               const Step& step, double pic, const std::array<bool, 2>& goes, Moving<N>& moving) {
  const LanePoint by = transposed(step.x, step.y);
  const LanePoint v = transposed(field.x, field.y);
  const LanePoint increment_x = transposed(step.xx, step.yx);
  const LanePoint increment_y = transposed(step.xy, step.yy);
  const LanePoint d_x = transposed(step.d_xx, step.d_yx);
  const LanePoint d_y = transposed(step.d_xy, step.d_yy);
  for (std::size_t lane = 0; lane < 2; ++lane) {
    if (!goes[lane]) continue;
    const Index p = lane == 0 ? chunk.first(q) : chunk.second(q);
    auto position = points.state.position.col(p).array();
    position += by[lane];
    points.state.displacement.col(p).array() += by[lane];
    auto velocity = points.motion.velocity.col(p).array();
    if (pic > 0.0) velocity += pic * (v[lane] - velocity);
    points.state.volume[p] = step.j[static_cast<Eigen::Index>(lane)] * points.motion.volume[p];
    const std::size_t k = moving.count++;
    moving.point[k] = p;
    moving.position[k] = position;
    moving.stress[k] = points.state.stress.col(p);
    moving.increment[k].col(0) = increment_x[lane];
    moving.increment[k].col(1) = increment_y[lane];
    moving.deformation[k].col(0) = d_x[lane];
    moving.deformation[k].col(1) = d_y[lane];
    points.motion.deformation.col(p).head<2>() = d_x[lane];
    points.motion.deformation.col(p).tail<2>() = d_y[lane];
  }
}

void note(Fault fault, Index point, MotionReport& report) {
#pragma omp critical
  if (report.point < 0 || point < report.point) {
    report.point = point;
    report.fault = fault;
  }
}

/// Moves the points of one chunk; those that cannot go on stay.
/// @param cell  of every point, to be kept up
template <int N>
void move_chunk(const Chunk<N>& chunk, const MovingPoints& points, const std::array<double, 2 * N>& field,
                const StepMotion& motion, double farthest, Moving<N>& moving, MotionReport& report) {
  moving.count = 0;
  const double* const d = points.motion.deformation.data();
  for (std::size_t q = 0; q < chunk.pairs; ++q) {
    const FieldLanes v = field_at<N>(&chunk.value[q * N], &chunk.gradient[q * 2 * N], field);
    const Step step = step_of(v, chunk.load_two(q, d, 4, 0), chunk.load_two(q, d, 4, 2), motion.dt);
    std::array<bool, 2> goes{true, chunk.is_whole(q)};
    for (int lane = 0; lane < 2; ++lane)
      if (const Fault fault = fault_of(step, lane, farthest); fault != Fault::none) {
        goes[static_cast<std::size_t>(lane)] = false;
        note(fault, lane == 0 ? chunk.first(q) : chunk.second(q), report);
      }
    move_pair(chunk, q, points, v, step, motion.pic, goes, moving);
  }
}

}  // namespace

MotionReport PointPasses::move(const MovingPoints& points, const PointCells& cells, const LargeStrainMaterial& law,
                               const StepMotion& motion, std::vector<Index>& cell) {
  constexpr double farthest = 0.5;  // of a cell
  MotionReport report;
  Index crossed = 0, outside = 0;
  const Grid& grid = basis_.grid();
  with_functions(table_.n, [&]<int N>(std::integral_constant<int, N>) {
#pragma omp parallel for schedule(static) reduction(+ : crossed, outside) \
    if (worth_threads(cells.supports.point.size()))
    for (Index c = 0; c < cells.supports.cells(); ++c) {
      Moving<N> moving;
      const Index here = cells.supports.cell[at(c)];
      const double reach = farthest * grid.size(here);
      const auto field = coefficients<N>(table_, here, motion.velocity);
      for_chunks<N, Needs::gradients>(basis_, points.state, cells.supports, c, [&](const Chunk<N>& chunk) {
        move_chunk<N>(chunk, points, field, motion, reach, moving, report);
        law.update({moving.stress.data(), moving.count}, {moving.increment.data(), moving.count},
                   {moving.deformation.data(), moving.count});
        grid.locate_all({moving.position.data(), moving.count}, here, moving.cell.data());
        for (std::size_t k = 0; k < moving.count; ++k) {
          points.state.stress.col(moving.point[k]) = moving.stress[k];
          cell[at(moving.point[k])] = moving.cell[k];
          outside += moving.cell[k] < 0 ? 1 : 0;
          crossed += moving.cell[k] != here ? 1 : 0;
        }
      });
    }
  });
  report.crossed = crossed > 0;
  report.outside = outside;
  return report;
}

}  // namespace shoreline
