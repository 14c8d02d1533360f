// The critical time step while the top of a column passes through a cell.

#include <catch2/catch.hpp>

#include "../self_weight_column.hpp"

using namespace shoreline;

namespace {

constexpr int rows = 8;
constexpr int places = 24;

/// The critical step of the column with its top @p drop of a block below the grid line at 1 m: the column is filled to
/// its top and then shifted by shrinking, with the mass that belongs to its volume.
double critical(double drop, const std::vector<std::string>& overrides) {
  DynamicScene scene = build_dynamic_scene(test::column_case(rows, overrides));
  const double share = 1.0 - drop / rows;
  scene.body.points.position.row(1) *= share;
  scene.body.points.volume *= share;
  scene.motion = motion_at_rest(scene.body.points, 1000.0);
  for (BoundaryPiece& b : scene.body.boundary)
    for (Vec2& x : b.piece.points) x.y() *= share;
  scene.settings.time_step.reset();
  return first_step(scene).critical;
}

/// Least and largest critical step over all places of the top, in parts of that with a full cell.
std::array<double, 2> sweep(const std::vector<std::string>& overrides) {
  const double full = critical(0.0, overrides);
  std::array<double, 2> range{1.0, 1.0};
  for (int k = 1; k < places; ++k) {
    const double here = critical(static_cast<double>(k) / places, overrides) / full;
    range = {std::min(range[0], here), std::max(range[1], here)};
  }
  return range;
}

}  // namespace

TEST_CASE(
    "the critical step stays within 30 % of that of full cells wherever the surface is, with every mass but the "
    "consistent one alone",
    "[stability][dynamics]") {
  for (const std::string volumes : {"clipped", "fitted"})
    for (const std::vector<std::string>& mass : std::vector<std::vector<std::string>>{
             {"analysis.mass=lumped"}, {"analysis.mass=partly_lumped"}, {"analysis.mass=consistent", "ghost=0.01"}}) {
      std::vector<std::string> overrides = mass;
      overrides.push_back("material_points.volumes=" + volumes);
      const auto [least, most] = sweep(overrides);
      CAPTURE(volumes, mass, least, most);
      CHECK(least >= 0.7);
      CHECK(most <= 1.3);
    }
}

TEST_CASE("with the consistent mass alone the critical step collapses where the surface leaves a cell",
          "[stability][dynamics]") {
  CHECK(sweep({"analysis.mass=consistent"})[0] < 0.1);
}
