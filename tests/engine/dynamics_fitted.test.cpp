// Explicit dynamics with weights that are fitted to the outline at every step.

#include <catch2/catch.hpp>

#include "../moving_bodies.hpp"

using namespace shoreline;

namespace {

constexpr double pull = 0.01;  // gravity [m/s²], of a body with E = 1 Pa and ρ = 1 kg/m³

/// A block between smooth walls on a fixed base, with its points off the lattice.
DynamicScene block(const Case::Grid& grid, double height, bool fitted) {
  Case problem =
      test::standing_block(grid, {.lower = Vec2::Zero(), .upper = Vec2(4.0, height), .sides = test::grid_roller});
  problem.material.poissons_ratio = 0.0;
  problem.material_points = AcrossFill{.across = {40, 40}};
  problem.gravity = Vec2(0.0, -pull);
  problem.fitted = fitted;
  ExplicitDynamics& settings = test::settings_of(problem);
  settings.mass = MassForm::partly_lumped;
  settings.time_step = 1e-2;
  settings.end_time = 0.1;
  DynamicScene scene = build_dynamic_scene(problem);
  test::Random random(9);
  for (Index p = 0; p < scene.body.points.size(); ++p) scene.body.points.position.col(p) += 0.02 * random.vector();
  return scene;
}

/// Root of the mean square of the points' acceleration under the linear stress that carries their weight, in parts of
/// gravity.
double acceleration(const Case::Grid& grid, bool fitted) {
  constexpr double height = 4.0;  // every element is full
  DynamicScene scene = block(grid, height, fitted);
  scene.settings.time_step = scene.settings.end_time = 1e-6;
  MaterialPoints& points = scene.body.points;
  points.stress.row(1) = -pull * (height - points.position.row(1).array());
  DynamicRecord record;
  run_time_steps(scene, {}, record);
  return scene.motion.velocity.norm() / std::sqrt(static_cast<double>(points.size())) / 1e-6 / pull;
}

}  // namespace

TEST_CASE("with fitted weights a linear stress that carries the points' weight leaves them at rest, on every basis",
          "[engine][dynamics][fitted]") {
  for (const auto& [name, grid] : test::every_grid(Vec2::Zero(), 4.0, 4)) {
    const double plain = acceleration(grid, false);
    const double fitted = acceleration(grid, true);
    CAPTURE(name, plain, fitted);
    CHECK(fitted < 0.02);
    CHECK(fitted < 0.2 * plain);
  }
}

TEST_CASE("fitted weights keep the balance of momentum, on every basis", "[engine][dynamics][fitted]") {
  for (const auto& [name, grid] : test::every_grid(Vec2::Zero(), 4.0, 4)) {
    CAPTURE(name);
    DynamicScene scene = block(grid, 3.3, true);
    CHECK(test::worst_imbalance(scene) < 1e-12);
  }
}

TEST_CASE("the fits of a run are recorded, and cost a phase of their own", "[engine][dynamics][fitted]") {
  DynamicScene scene = block(test::unit_cells(4.0), 3.3, true);
  DynamicRecord record;
  run_time_steps(scene, {}, record);
  REQUIRE(record.weights);
  CHECK(record.weights->changed > 0.0);
  CHECK(record.weights->iterations >= 10);
  CHECK(record.weights->factorisations >= 1);
  const auto calls = [&](const std::string& name) {
    for (const Clock::Entry& entry : record.phases.entries())
      if (entry.name == name) return entry.calls;
    return decltype(Clock::Entry::calls)(0);
  };
  CHECK(calls("weights") == 10);
}
