#include "../self_weight_column.hpp"
#include "sweeps.hpp"

namespace shoreline::test {
namespace {

constexpr int rows_of_places = 8;

/// The critical step of the column [s] when its top lies by @p drop of a block below the grid line at 1 m: points and
/// outline of the full column shrink to that height, with the mass that belongs to their volume.
double critical_step(double drop, const std::vector<std::string>& overrides) {
  DynamicScene scene = build_dynamic_scene(column_case(rows_of_places, overrides));
  const double share = 1.0 - drop / rows_of_places;
  scene.body.points.position.row(1) *= share;
  scene.body.points.volume *= share;
  scene.motion = motion_at_rest(scene.body.points, 1000.0);
  for (BoundaryPiece& b : scene.body.boundary)
    for (Vec2& x : b.piece.points) x.y() *= share;
  scene.settings.time_step.reset();
  return first_step(scene).critical;
}

}  // namespace

SurfaceRow surface_sweep(const std::vector<std::string>& mass, const std::string& volumes, int places) {
  std::vector<std::string> overrides = mass;
  overrides.push_back("material_points.volumes=" + volumes);
  SurfaceRow row{.mass = mass, .volumes = volumes, .full = critical_step(0.0, overrides)};
  row.least = row.most = row.full;
  for (int k = 1; k < places; ++k) {
    const double here = critical_step(static_cast<double>(k) / places, overrides);
    row.least = std::min(row.least, here);
    row.most = std::max(row.most, here);
  }
  return row;
}

double spurious_acceleration(int rows, const std::string& volumes) {
  const Case problem = column_case(rows, {"analysis.time_step=1e-7", "analysis.end_time=1e-7", "analysis.transfer=flip",
                                          "material_points.volumes=" + volumes});
  Motion motion(build_dynamic_scene(problem));
  squeeze(motion.scene);
  motion.compute();
  const auto points = static_cast<double>(motion.scene.body.points.size());
  return motion.scene.motion.velocity.norm() / std::sqrt(points) / 1e-7 / 9.81;
}

ColumnErrors column_errors(int rows, const std::string& volumes) {
  const Motion motion =
      Motion(build_dynamic_scene(column_case(rows, {"material_points.volumes=" + volumes}))).compute();
  const double start = motion.record.history.front().total();
  double change = 0.0, swing = 0.0;
  for (const HistoryState& state : motion.record.history) {
    change = std::max(change, std::abs(state.total() - start));
    swing = std::max(swing, state.strain);
  }
  constexpr double speed = 10.0;  // c = √(E/ρ) [m/s]
  return {motion.over_time("displacement").mean_rms / column_kappa,
          motion.over_time("velocity").mean_rms / (2.0 * column_kappa * speed),
          motion.over_time("stress").mean_rms / column_weight, change / swing};
}

}  // namespace shoreline::test
