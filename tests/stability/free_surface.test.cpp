// The critical time step while the top of a column passes through a cell.

#include <catch2/catch.hpp>

#include "../self_weight_column.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;

namespace {

constexpr int rows = 8;
constexpr int places = 24;

/// The critical step of the column [s] when its top lies by @p drop of a block below the grid line at 1 m: points and
/// outline of the full column shrink to that height, with the mass that belongs to their volume.
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

/// Least and largest critical step over all places of the top [s].
std::array<double, 2> sweep(const std::vector<std::string>& overrides) {
  std::array<double, 2> range{1.0, 0.0};
  for (int k = 0; k < places; ++k) {
    const double here = critical(static_cast<double>(k) / places, overrides);
    range = {std::min(range[0], here), std::max(range[1], here)};
  }
  return range;
}

}  // namespace

TEST_CASE(
    "partly lumped or with a ghost mass the critical step stays within 30 % of that of full cells wherever the "
    "surface is",
    "[stability][dynamics]") {
  for (const std::string volumes : {"clipped", "fitted"})
    for (const std::vector<std::string>& mass : std::vector<std::vector<std::string>>{
             {"analysis.mass=partly_lumped"}, {"analysis.mass=consistent", "ghost=0.01"}}) {
      std::vector<std::string> overrides = mass;
      overrides.push_back("material_points.volumes=" + volumes);
      const double full = critical(0.0, overrides);
      const auto [least, most] = sweep(overrides);
      CAPTURE(volumes, mass, full, least, most);
      CHECK(least >= 0.7 * full);
      CHECK(most <= 1.3 * full);
    }
}

TEST_CASE("lumped it falls further, but stays above that of full cells under the partly lumped mass",
          "[stability][dynamics]") {
  for (const std::string volumes : {"material_points.volumes=clipped", "material_points.volumes=fitted"}) {
    CAPTURE(volumes);
    CHECK(sweep({"analysis.mass=lumped", volumes})[0] >= critical(0.0, {"analysis.mass=partly_lumped", volumes}));
  }
}

TEST_CASE("with the consistent mass alone it collapses as the surface leaves a cell, until the mass is singular",
          "[stability][dynamics]") {
  const std::vector<std::string> consistent{"analysis.mass=consistent"};
  CHECK(critical(0.75, consistent) < 0.5 * critical(0.0, consistent));
  CHECK_THROWS_AS(sweep(consistent), ComputationError);
}
