// Re-spacing of tracking points between load steps.
#include <algorithm>
#include <catch2/catch.hpp>
#include <ranges>

#include "../scenes.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;

namespace {

/// Turned off the grid, pulled down by its weight, with graded tracking points on every side.
Case graded_square(double weight, int steps, double respacing, int cells = 10, int chords = 6) {
  Case problem = test::compression_case({.angle = 0.5,
                                         .shift = Vec2(0.003, 0.001),
                                         .cells = cells,
                                         .per_cell = 2,
                                         .band = 0.01,
                                         .load = 0.0,
                                         .steps = steps});
  for (Case::Boundary& b : problem.boundaries) {
    const Vec2 from = b.piece.points.front();
    const Vec2 to = b.piece.points.back();
    b.piece.points = {from};
    for (int k = 1; k < chords; ++k)
      b.piece.points.emplace_back(from + static_cast<double>(k * k) / (chords * chords) * (to - from));
    b.piece.points.push_back(to);
  }
  const auto held = [&](double part) { return Quantity(Expression("f", {{"f", part * weight}})); };
  problem.body_force = {held(0.3), held(-1.0)};
  problem.respacing = respacing;
  problem.ghost = 1e-3;
  return problem;
}

/// A disc in a fixed rim with graded tracking points, pulled down by its weight, which is held.
Case graded_disc(int points, double respacing) {
  Case problem = test::disc_case(1.0, 0.23, Essential{.band = 0.01});
  problem.boundaries[0].piece.points.clear();
  for (int k = 0; k < points; ++k) {
    const double s = static_cast<double>(k) / points;
    const double angle = 2.0 * std::numbers::pi * s - 0.6 * std::sin(2.0 * std::numbers::pi * s);
    problem.boundaries[0].piece.points.emplace_back(std::cos(angle), std::sin(angle));
  }
  problem.body_force = {Quantity(Expression("f", {{"f", 3e-8}})), Quantity(Expression("f", {{"f", -1e-7}}))};
  std::get<QuasiStatic>(problem.analysis).load_steps = 4;
  problem.ghost = 1e-3;
  problem.respacing = respacing;
  return problem;
}

/// Runs a scene; the largest displacement of a material point in each step, over that in the first.
std::vector<double> drift(Scene& scene, RunRecord& record) {
  std::vector<double> moved;
  Eigen::Matrix2Xd before = scene.points.displacement;
  const auto note = [&](int) {
    moved.push_back((scene.points.displacement - before).cwiseAbs().maxCoeff());
    before = scene.points.displacement;
  };
  run_load_steps(scene, {.after_step = note}, record);
  for (double& each : moved | std::views::drop(1)) each /= moved.front();
  return moved;
}

double chord_ratio(const Piece& piece) {
  std::vector<double> chords;
  for (std::size_t k = 1; k < piece.points.size(); ++k)
    chords.push_back((piece.points[k] - piece.points[k - 1]).norm());
  return std::ranges::max(chords) / std::ranges::min(chords);
}

}  // namespace

TEST_CASE("re-spacing is off unless asked for, where it happens it is said once, with the number of steps",
          "[engine][respacing]") {
  for (const double limit : {0.0, 50.0, 2.0}) {
    Scene scene = build_scene(graded_square(1e4, 3, limit));
    RunRecord record;
    run_load_steps(scene, {}, record);
    const bool respaced = limit == 2.0;
    for (const BoundaryPiece& b : scene.boundary) CHECK((chord_ratio(b.piece) < 1.3) == respaced);
    REQUIRE(record.warnings.size() == (respaced ? 4 : 0));
    if (respaced) CHECK_THAT(record.warnings.front(), Contains("load step 1") && Contains("piece 'bottom'"));
    if (respaced) CHECK_THAT(record.warnings.front(), !Contains("later load step"));  // even chords stay so
  }
  Case crowded = graded_square(1e4, 3, 1.0 + 1e-12);  // beyond which rounding alone is in every step
  Scene scene = build_scene(crowded);
  RunRecord record;
  run_load_steps(scene, {}, record);
  CHECK_THAT(record.warnings.front(), Contains("(and in 2 later load steps)"));
}

TEST_CASE("a held load stays held through a re-spacing", "[engine][respacing]") {
  // Strains of 1e-16 leave every position as it is. The reactions are integrated over other segments after the
  // re-spacing, once; nothing else is lost.
  std::vector<double> once;
  for (const int cells : {10, 20, 40}) {
    Scene scene = build_scene(graded_square(1e-8, 4, 2.0, cells));
    RunRecord record;
    const std::vector<double> moved = drift(scene, record);
    CHECK(chord_ratio(scene.boundary[0].piece) < 1.0 + 1e-9);
    once.push_back(moved[1]);
    CHECK(std::max(moved[2], moved[3]) < 1e-14);
  }
  CAPTURE(once);
  CHECK(once[0] < 5e-4);
  CHECK(once[2] < once[0] / 6.0);  // order two in h is 16
}

TEST_CASE("a load that is held by a curved edge drifts by the change of its curve", "[engine][respacing]") {
  std::vector<double> once;
  for (const int points : {48, 96}) {
    Scene scene = build_scene(graded_disc(points, 2.0));
    RunRecord record;
    const std::vector<double> moved = drift(scene, record);
    CHECK_THAT(record.warnings.front(), Contains("piece 'rim'"));
    once.push_back(moved[1]);
    CHECK(std::max(moved[2], moved[3]) < 1e-14);
  }
  CAPTURE(once);
  CHECK(once[0] < 2e-3);
  CHECK(once[1] < once[0] / 5.0);  // the curve changes with order three
}

TEST_CASE("conditions find the original position of the material on re-spaced pieces", "[engine][respacing]") {
  const Expression traction("size * (X + 0.1) * (Y + 0.07) / 0.01", {{"size", 5e4}});  // strains of a tenth
  for (const int chords : {6, 24}) {
    std::vector<Vec3> load;
    for (const double limit : {0.0, 2.0}) {
      Case problem = graded_square(1e-9, 3, limit, 10, chords);
      problem.boundaries[2].condition = Case::Traction{std::array{Quantity(0.0), Quantity(traction)}};
      Scene scene = build_scene(problem);
      RunRecord record;
      run_load_steps(scene, {}, record);
      load.push_back(record.resultants.loads.at("top"));
    }
    CHECK((load[1] - load[0]).norm() / load[0].norm() < 2e-3);
  }
}
