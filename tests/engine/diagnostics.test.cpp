// What a run tells of weak places of its system.
#include "shoreline/engine/diagnostics.hpp"

#include <catch2/catch.hpp>

#include "../scenes.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

RunRecord run(Scene scene, const QuasiStaticOptions& options) {
  RunRecord record;
  run_load_steps(scene, options, record);
  return record;
}

/// A square of 4 × 4 cells on grid lines, with four points in every cell but those of the last column.
Case nearly_empty_column(const std::vector<Vec2>& in_last_column) {
  Case problem = test::compression_case({.side = 4.0, .cells = 4});
  problem.boundaries[1].condition = Case::Free{};
  std::vector<Case::ListedPoint> points;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 8; ++j) points.push_back({Vec2(-1.75 + 0.5 * i, -1.75 + 0.5 * j), 0.25});
  for (const Vec2& x : in_last_column) points.push_back({x, 0.25});
  problem.material_points = points;
  return problem;
}

/// Whether a scene without ghost penalty has no unique solution.
bool singular(const Case& problem) {
  try {
    const RunRecord record = run(build_scene(problem), {});
    return !record.warnings.empty() && record.warnings[0].find("singular") != std::string::npos;
  } catch (const ComputationError& error) {
    return std::string(error.what()).find("singular") != std::string::npos;
  }
}

}  // namespace

TEST_CASE("the smallest cut and its cell are told where a case asks for them", "[engine][diagnostics]") {
  const double fraction = GENERATE(1e-3, 1e-9);
  const double h = 0.01;
  const Vec2 shift(4.0 * fraction * h, 0.25 * h);
  const RunRecord record =
      run(test::compression_square({.shift = shift, .per_cell = 2, .ghost = 1e-3}), {.cut_fractions = true});
  const Diagnostics& found = record.diagnostics.value();
  CHECK_THAT(found.smallest_cut.value().fraction, WithinRel(fraction, 1e-6));
  CHECK((found.smallest_cut->centre - Vec2(0.055, 0.055)).norm() <= 1e-12);
  CHECK(found.fewest_points == 1);  // the corner's quarter height lies in one row of sub-cells, its width in one column
  CHECK(found.smallest_pivot.value().value > 0.0);
  CHECK(found.smallest_pivot->value <= 1.0);
}

TEST_CASE("where nobody asks, no weak spot is looked for", "[engine][diagnostics]") {
  const RunRecord record = run(test::compression_square({}), {});
  CHECK_FALSE(record.diagnostics);
  CHECK(std::ranges::none_of(record.phases.entries(), [](const auto& phase) { return phase.name == "diagnostics"; }));
}

TEST_CASE("a point that two functions see alone is a stray point, and the system singular", "[engine][diagnostics]") {
  const Vec2 alone(1.5, -0.4);
  Case problem = nearly_empty_column({alone});
  CHECK(singular(problem));
  problem.ghost = 1e-3;
  const Diagnostics found = *run(build_scene(problem), {.cut_fractions = true}).diagnostics;
  CHECK(found.stray_points == 1);
  CHECK(found.first_stray.value() == alone);
  CHECK(found.fewest_points == 1);
}

TEST_CASE("two points hold the functions that they alone see, and are no stray points", "[engine][diagnostics]") {
  const Case problem = nearly_empty_column({{1.3, -0.4}, {1.6, -0.7}});
  CHECK_FALSE(singular(problem));
  const Diagnostics found = *run(build_scene(problem), {.cut_fractions = true}).diagnostics;
  CHECK(found.stray_points == 0);
  CHECK_FALSE(found.first_stray);
  CHECK(found.fewest_points == 2);
}

TEST_CASE("a point that alone sees one function is no stray point", "[engine][diagnostics]") {
  Case problem = nearly_empty_column({{1.5, -0.4}, {1.5, -1.4}});  // they share a node of the border
  problem.ghost = 1e-3;
  const Diagnostics found = *run(build_scene(problem), {.cut_fractions = true}).diagnostics;
  CHECK(found.stray_points == 0);
  CHECK(found.fewest_points == 1);
}

TEST_CASE("a failure names the cell, its share in the body and the remedy", "[engine][diagnostics]") {
  Case problem = nearly_empty_column({{1.5, -0.4}});
  problem.body_force = {Quantity(0.0), Quantity(-10.0)};  // a load that the stray point cannot carry
  Scene scene = build_scene(problem);
  RunRecord record;
  std::string message;
  try {
    run_load_steps(scene, {}, record);
  } catch (const ComputationError& error) {
    message = error.what();
  }
  CHECK_THAT(message, Contains("its emptiest cell is around (1.5, -0.5), 1 of which the body covers, with 1 material "
                               "point") &&
                          Contains("add a ghost penalty"));
}

TEST_CASE("a condition estimate above 1e14 is a warning with the weakest function", "[engine][diagnostics]") {
  const auto warnings = [](double band) {
    return run(test::compression_square({.angle = 0.5, .per_cell = 4, .band = band, .ghost = 1e-3}),
               {.condition_estimate = true})
        .warnings;
  };
  CHECK(warnings(1e-3).empty());
  const std::vector<std::string> said = warnings(1e-15);
  REQUIRE(said.size() == 1);
  CHECK_THAT(said[0], Contains("load step 1: the condition estimate is") && Contains("Weakest is") &&
                          Contains("add a ghost penalty"));
}
