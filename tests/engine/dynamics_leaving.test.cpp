// Points that leave the grid in explicit dynamics, and what runs of other analyses do not do.

#include <algorithm>
#include <catch2/catch.hpp>

#include "../moving_bodies.hpp"
#include "output_folder.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/run.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// A block 0.5 m from the right border of its grid, which it will cross at 1 m/s.
Case leaving(bool drop) {
  Case problem = test::free_block(test::unit_cells(6.0), Vec2(3.5, 2.2), Vec2(5.5, 4.2), 10);
  problem.material.youngs_modulus = 1e-6;
  problem.initial_velocity = test::formulas("1", "0");
  problem.analysis = ExplicitDynamics{.time_step = 0.05, .end_time = 1.5, .drop_outside = drop};
  problem.probes = {{"first", Vec2(5.4, 3.1)}, {"last", Vec2(3.6, 3.1)}};
  return problem;
}

}  // namespace

TEST_CASE("a body that leaves the grid ends the run at the step before, with point, place and number",
          "[engine][dynamics]") {
  DynamicScene scene = build_dynamic_scene(leaving(false));
  DynamicRecord record;
  CHECK_THROWS_WITH(run_time_steps(scene, {}, record), Contains("step 13 (t = 0.65 s)") &&
                                                           Contains("10 of 100 material points lie outside the grid") &&
                                                           Contains("the first is point ") && Contains("at (6.05, "));
  CHECK(record.steps == 12);
  CHECK_THAT(record.t, WithinAbs(0.6, 1e-12));
}

TEST_CASE("points that are dropped take their mass with them, and the others go on", "[engine][dynamics]") {
  DynamicScene scene = build_dynamic_scene(leaving(true));
  const std::size_t first = scene.body.probes[0].point, last = scene.body.probes[1].point;
  const Vec2 place_of_last = scene.body.points.position.col(static_cast<Index>(last));
  REQUIRE(first != last);
  const DynamicRecord record = test::run_steps(scene);
  CHECK(record.dropped == 50);  // columns at 5.4, 5.2, ..., 4.6 have crossed 6 after 1.5 s
  CHECK(scene.body.points.size() == 50);
  CHECK(scene.motion.mass.size() == 50);
  CHECK(scene.motion.velocity.cols() == 50);
  CHECK(scene.motion.deformation.cols() == 50);
  CHECK_THAT(scene.motion.mass.sum(), WithinRel(2.0, 1e-12));
  CHECK((scene.motion.velocity.colwise() - Vec2::UnitX()).cwiseAbs().maxCoeff() < 1e-6);
  CHECK(scene.body.points.position.row(0).maxCoeff() < 6.0);
  REQUIRE(record.warnings.size() == 1);
  CHECK_THAT(record.warnings[0], Contains("dropped, the first at (6.05, ") && Contains("t = 0.65 s"));

  const Probe& lost = scene.body.probes[0];
  CHECK(lost.lost);
  REQUIRE(lost.history.size() == 31);
  CHECK_THAT(lost.history[12].position.x(), WithinAbs(6.0, 1e-6));
  for (std::size_t k = 13; k < 31; ++k) {
    CHECK(lost.history[k].position == lost.history[12].position);
    CHECK_THAT(lost.history[k].t, WithinAbs(0.05 * static_cast<double>(k), 1e-12));
    CHECK(lost.history[k].velocity);
  }
  const Probe& kept = scene.body.probes[1];
  CHECK_FALSE(kept.lost);
  CHECK((kept.history.back().position - place_of_last - Vec2(1.5, 0.0)).norm() < 1e-6);
}

TEST_CASE("where every point has left, nothing can go on", "[engine][dynamics]") {
  Case problem = leaving(true);
  test::settings_of(problem).end_time = 5.0;
  DynamicScene scene = build_dynamic_scene(problem);
  DynamicRecord record;
  CHECK_THROWS_WITH(run_time_steps(scene, {}, record), Contains("every material point has left the grid"));
}

TEST_CASE("a run of load steps knows nothing of dynamics", "[engine][dynamics]") {
  const test::OutputFolder folder;
  Case problem = test::compression_case({.cells = 4});
  problem.output.pictures = false;
  problem.threads = 1;
  const Summary summary = run(problem, {.output = folder.path, .quiet = true});
  CHECK_FALSE(summary.dynamics);
  CHECK(summary.history.empty());
  for (const char* phase : {"forces", "mass", "accelerate", "move", "history", "critical_step"})
    CHECK(std::ranges::none_of(summary.timings, [&](const auto& timing) { return timing.first == phase; }));
}

TEST_CASE("a run of time steps leaves its figures in the summary, and only what its case names", "[engine][dynamics]") {
  const test::OutputFolder folder;
  Case problem = leaving(true);
  problem.output.pictures = false;
  problem.threads = 1;
  const Summary summary = run(problem, {.output = folder.path, .quiet = true});
  REQUIRE(summary.dynamics);
  CHECK(summary.dynamics->law == "neo_hookean");
  CHECK(summary.dynamics->mass == "lumped");
  CHECK(summary.dynamics->dropped_points == 50);
  CHECK_THAT(summary.dynamics->largest_step, WithinRel(0.05, 1e-9));
  CHECK_THAT(summary.dynamics->smallest_step, WithinRel(0.05, 1e-9));
  CHECK(summary.steps == 30);
  CHECK(summary.history.empty());
  CHECK(summary.counters.at("mass_iterations") == 0);
  CHECK(summary.counters.at("critical_step_iterations") > 0);
  REQUIRE(summary.effects.size() == 2);
  CHECK(summary.effects[0].name == "neo_hookean");
  CHECK(summary.effects[1].name == "probes");
  CHECK(summary.probes.size() == 2);
}
