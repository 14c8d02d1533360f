// The pass that moves the points.

#include <cmath>
#include <limits>

#include "point_chunks.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// What law and grid need of the points of a chunk.
struct Moved {
  static constexpr std::size_t most = Chunk<1>::most_groups;

  std::array<LaneTensor, most> stress;
  std::array<LaneTensor, most> increment;
  std::array<LaneTensor, most> deformation;
  std::array<LanePoint, most> position;
};

/// How four points go and deform in a step.
struct Step {
  Lanes x, y;              ///< displacement [m]
  LaneTensor increment;    ///< Δt ∇v
  LaneTensor deformation;  ///< D at the end
  Lanes j;                 ///< det D
};

/// @param d  deformation gradient at the start, as PointMotion has it
SHORELINE_INLINE Step step_of(const FieldLanes& field, const LaneTensor& d, double dt) {
  Step s;
  s.x = dt * field.x;
  s.y = dt * field.y;
  const auto& [xx, yx, xy, yy] = s.increment = {dt * field.xx, dt * field.yx, dt * field.xy, dt * field.yy};
  s.deformation = {d[0] + (xx * d[0] + xy * d[1]), d[1] + (yx * d[0] + yy * d[1]), d[2] + (xx * d[2] + xy * d[3]),
                   d[3] + (yx * d[2] + yy * d[3])};
  s.j = s.deformation[0] * s.deformation[3] - s.deformation[2] * s.deformation[1];
  return s;
}

/// Whether nothing holds any of the points.
/// @param farthest  that one may go in one step [m]
SHORELINE_INLINE bool all_go(const Step& s, double farthest) {
  return all_of((s.j > 0.0) & (s.j <= std::numeric_limits<double>::max()) &
                (s.x * s.x + s.y * s.y <= farthest * farthest));
}

/// What holds a point, if anything.
Fault fault_of(double j, double way, double farthest) {
  if (j > 0.0 && j <= std::numeric_limits<double>::max() && way <= farthest * farthest) return Fault::none;
  if (!std::isfinite(j + way)) return Fault::not_finite;
  return j <= 0.0 ? Fault::inverted : Fault::too_fast;
}

void note(Fault fault, std::size_t point, MotionReport& report) {
  const auto p = static_cast<Index>(point);
#pragma omp critical
  if (report.point < 0 || p < report.point) {
    report.point = p;
    report.fault = fault;
  }
}

/// Notes the points that cannot go on.
/// @return the field, but one in which they stay
FieldLanes held_back(const std::array<std::size_t, lanes>& point, Step step, double farthest, FieldLanes field,
                     MotionReport& report) {
  for (std::size_t l = 0; l < lanes; ++l) {
    const Fault fault = fault_of(step.j[l], step.x[l] * step.x[l] + step.y[l] * step.y[l], farthest);
    if (fault == Fault::none) continue;
    note(fault, point[l], report);
    for (Lanes* const part : {&field.x, &field.y, &field.xx, &field.xy, &field.yx, &field.yy}) (*part)[l] = 0.0;
  }
  return field;
}

/// Moves four points.
template <int N>
SHORELINE_INLINE void move_group(const Chunk<N>& chunk, std::size_t q, const MovingPoints& points,
                                 const FieldLanes& field, const Step& step, double pic, Moved& moved) {
  LanePoint displacement = chunk.load_two(q, points.state.displacement.data());
  moved.position[q] = {chunk.x[q][0] + step.x, chunk.x[q][1] + step.y};
  displacement[0] += step.x;
  displacement[1] += step.y;
  LanePoint velocity = chunk.load_two(q, points.motion.velocity.data());
  velocity[0] += pic * (field.x - velocity[0]);
  velocity[1] += pic * (field.y - velocity[1]);
  const Lanes volume = step.j * chunk.load(q, points.motion.volume.data());
  moved.stress[q] = chunk.load_four(q, points.state.stress.data());
  moved.increment[q] = step.increment;
  moved.deformation[q] = step.deformation;
  chunk.store_two(q, moved.position[q], points.state.position.data());
  chunk.store_two(q, displacement, points.state.displacement.data());
  chunk.store_two(q, velocity, points.motion.velocity.data());
  chunk.store(q, volume, points.state.volume.data());
  chunk.store_four(q, step.deformation, points.motion.deformation.data());
}

/// Points that left their cell or the grid.
struct Passage {
  Index crossed = 0;
  Index outside = 0;
};

/// Finds the cells of the points of a chunk anew.
template <int N>
void locate(const Chunk<N>& chunk, const Moved& moved, const Grid& grid, Index here, std::vector<Index>& cell,
            Passage& passage) {
  for (std::size_t k = 0; k < chunk.count; ++k) {
    const LanePoint& x = moved.position[k / lanes];
    const Index there = grid.locate(Vec2(x[0][k % lanes], x[1][k % lanes]), here).value_or(-1);
    cell[chunk.point[k / lanes][k % lanes]] = there;
    passage.outside += there < 0 ? 1 : 0;
    passage.crossed += there != here ? 1 : 0;
  }
}

/// What a motion works with beside the points.
struct Ground {
  const Basis& basis;
  const ElementTable& table;
  const PointCells& cells;
  const LargeStrainMaterial& law;
};

/// Moves the points of some occupied cells; those that cannot go on stay.
/// @param cell  of every point, to be kept up
SHORELINE_CLONES void move_in(Index begin, Index end, const Ground& on, const MovingPoints& points,
                              const StepMotion& motion, std::vector<Index>& cell, Passage& passage,
                              MotionReport& report) {
  constexpr double farthest = 0.5;  // of a cell
  const Grid& grid = on.basis.grid();
  const PointSupports& supports = on.cells.supports;
  with_functions(on.table.n, [&]<int N>(std::integral_constant<int, N>) SHORELINE_INLINED {
    Moved moved;
    for (Index c = begin; c < end; ++c) {
      const Index here = supports.cell[at(c)];
      const double reach = farthest * grid.size(here);
      const auto velocity = coefficients<N>(on.table, here, motion.velocity);
      for_chunks<N, Needs::gradients>(
          on.basis, points.state, supports, c, [&](const Chunk<N>& chunk) SHORELINE_INLINED {
            for (std::size_t q = 0; q < chunk.groups; ++q) {
              FieldLanes field = field_at<N>(chunk, q, velocity);
              const LaneTensor d = chunk.load_four(q, points.motion.deformation.data());
              Step step = step_of(field, d, motion.dt);
              if (!all_go(step, reach)) {
                field = held_back(chunk.point[q], step, reach, field, report);
                step = step_of(field, d, motion.dt);
              }
              move_group(chunk, q, points, field, step, motion.pic, moved);
            }
            on.law.update({moved.stress.data(), chunk.groups}, {moved.increment.data(), chunk.groups},
                          {moved.deformation.data(), chunk.groups});
            for (std::size_t q = 0; q < chunk.groups; ++q)
              chunk.store_four(q, moved.stress[q], points.state.stress.data());
            if (!grid.holds_all(here, {moved.position.data(), chunk.groups}))
              locate(chunk, moved, grid, here, cell, passage);
          });
    }
  });
}

}  // namespace

MotionReport PointPasses::move(const MovingPoints& points, const PointCells& cells, const LargeStrainMaterial& law,
                               const StepMotion& motion, std::vector<Index>& cell) {
  MotionReport report;
  Index crossed = 0, outside = 0;
#pragma omp parallel reduction(+ : crossed, outside) if (worth_threads(cells.supports.point.size()))
  {
    Passage passage;
    for_ranges(cells.supports.cells(), [&](Index begin, Index end) {
      move_in(begin, end, {basis_, table_, cells, law}, points, motion, cell, passage, report);
    });
    crossed += passage.crossed;
    outside += passage.outside;
  }
  report.crossed = crossed > 0;
  report.outside = outside;
  return report;
}

}  // namespace shoreline
