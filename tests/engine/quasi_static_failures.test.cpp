// What load steps cannot be taken, and what is said then.
#include <catch2/catch.hpp>

#include "../../engine/src/motion_check.hpp"
#include "../bodies_on_lines.hpp"
#include "../scenes.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

/// The square with other conditions at its sides.
template <class Change>
Case changed(const test::CompressionSquare& square, Change&& change) {
  Case problem = test::compression_case(square);
  for (Case::Boundary& b : problem.boundaries) change(b);
  return problem;
}

std::string failure(Scene& scene) {
  try {
    RunRecord record;
    run_load_steps(scene, {}, record);
    return "no failure";
  } catch (const ComputationError& error) {
    return error.what();
  }
}

std::string failure(const Case& problem) {
  Scene scene = build_scene(problem);
  return failure(scene);
}

}  // namespace

TEST_CASE("a body that nothing holds is refused with the motion that is free", "[engine][quasi_static]") {
  const test::CompressionSquare square{.cells = 4, .per_cell = 2};
  const auto free = changed(square, [](Case::Boundary& b) {
    if (std::holds_alternative<Essential>(b.condition)) b.condition = Case::Free{};
  });
  CHECK_THAT(failure(free), Contains("load step 1") && Contains("the body with 64 material points in 16 cells") &&
                                Contains("freely") && Contains("add a boundary condition"));

  for (const EssentialMethod method : {EssentialMethod::implicit_boundary, EssentialMethod::grid}) {
    const auto sliding = changed(square, [&](Case::Boundary& b) {
      if (b.piece.name == "bottom") b.condition = Case::Free{};
      if (auto* held = std::get_if<Essential>(&b.condition)) held->method = method;
    });
    CHECK_THAT(failure(sliding), Contains("slide along (0, 1)") || Contains("slide along (0, -1)"));
  }

  const auto turning = changed(square, [](Case::Boundary& b) {
    if (b.piece.name == "right") b.condition = Case::Free{};
    if (b.piece.name == "left") b.condition = Case::Free{};
  });
  CHECK_THAT(failure(turning), Contains("slide along (1, 0)") || Contains("slide along (-1, 0)"));
}

TEST_CASE("between rollers on inclined lines of the grid a body slides along them", "[engine][quasi_static]") {
  test::Random random(1);
  for (const test::Setting& setting : test::settings(random)) {
    if (setting.angle == 0.0) continue;
    CAPTURE(setting.name);
    Case problem = test::body_on_lines(setting);
    for (const std::size_t k : {0u, 2u})
      problem.boundaries[k].condition = Essential{.normal_only = true, .method = EssentialMethod::grid};
    CHECK_THAT(failure(problem), Contains("slide along (0.92, 0.39)") || Contains("slide along (-0.92, -0.39)"));
  }
}

TEST_CASE("a part that nothing holds is found beside one that is held", "[engine][quasi_static]") {
  Scene scene = test::compression_square({.cells = 4});
  const auto n = static_cast<Eigen::Index>(scene.points.size());
  Eigen::Matrix2Xd position(2, n + 1);
  position << scene.points.position, Vec2(-0.10625, 0.10625);  // far off in the corner of the grid
  scene.points = points_at(position, Eigen::VectorXd::Constant(n + 1, 6.25e-4));
  CHECK_THAT(failure(scene),
             Contains("a separate part of the body with 1 material point in 1 cell around (-0.10625, 0.10625)"));
}

TEST_CASE("a motion without strain at the points is refused where a load moves it, with its place and the remedy",
          "[engine][quasi_static]") {
  // one point in one cell and two rollers: four unknowns, three strains; a pull along the top moves the fourth
  Case loose = changed({.cells = 1, .method = EssentialMethod::grid}, [](Case::Boundary& b) {
    if (b.piece.name == "right") b.condition = Case::Free{};
  });
  Scene scene = build_scene(loose);
  RunRecord record;
  run_load_steps(scene, {}, record);
  CHECK_THAT(scene.points.stress(1, 0), WithinAbs(-8e3, 1e-6 * 8e3));
  REQUIRE(record.warnings.size() == 1);
  CHECK_THAT(record.warnings.front(), Contains("load step 1: the stiffness is singular") &&
                                          Contains("1 material point of") && Contains("No load moves it"));

  loose.boundaries[2].condition = Case::Traction{std::array{Quantity(1.0), Quantity(-8e3)}};
  CHECK_THAT(failure(loose), Contains("load step 1: the stiffness is singular") && Contains("1 material point of") &&
                                 Contains("ghost"));
}

namespace {

/// The square, free on its left, where stray points lie in a cell of their own beside it.
Scene with_strays(const std::vector<Vec2>& strays, double weight, int steps = 1) {
  Case problem = test::compression_case({.cells = 4, .per_cell = 2, .load = 1.0, .steps = steps});
  problem.boundaries[3].condition = Case::Free{};
  problem.body_force = {Quantity(0.0), Quantity(-weight)};
  Scene scene = build_scene(problem);
  const Eigen::Index n = scene.points.volume.size();
  const auto more = static_cast<Eigen::Index>(strays.size());
  Eigen::Matrix2Xd position(2, n + more);
  Eigen::VectorXd volume = Eigen::VectorXd::Constant(n + more, 1.5625e-4);
  position.leftCols(n) = scene.points.position;
  for (Eigen::Index k = 0; k < more; ++k) position.col(n + k) = strays[static_cast<std::size_t>(k)];
  scene.points = points_at(position, volume);
  return scene;
}

}  // namespace

TEST_CASE("a stray point that hangs on by two nodes is named with its cell where a load moves it",
          "[engine][quasi_static]") {
  const Vec2 stray(-0.059, -0.015);  // the cell from (-0.075, -0.025) to (-0.05, 0); its right nodes are the body's
  Scene loaded = with_strays({stray}, 1e3);  // along the body's side, which is how the two free nodes can move it
  CHECK_THAT(failure(loaded), Contains("load step 1") && Contains("1 material point of") &&
                                  Contains("cell is around (-0.0625, -0.0125) with 1 material point") &&
                                  Contains("add a ghost penalty (\"ghost\": 0.001)"));
}

TEST_CASE("a stray point that no load moves changes nothing, and is warned of once", "[engine][quasi_static]") {
  Scene scene = with_strays({Vec2(-0.059, -0.015)}, 0.0, 3);
  Scene alone = with_strays({}, 0.0, 3);
  const Eigen::Index n = alone.points.volume.size();
  RunRecord record;
  run_load_steps(scene, {}, record);
  RunRecord record_alone;
  run_load_steps(alone, {}, record_alone);
  CHECK(record_alone.warnings.empty());
  const double largest = alone.points.displacement.cwiseAbs().maxCoeff();
  CHECK((scene.points.displacement.leftCols(n) - alone.points.displacement).cwiseAbs().maxCoeff() < 1e-4 * largest);
  CHECK(scene.points.displacement.col(n).norm() < 3.0 * largest);
  CAPTURE(record.warnings);
  REQUIRE(record.warnings.size() == 1);
  CHECK_THAT(record.warnings.front(),
             Contains("load step 1") && Contains("1 material point") && Contains("(and in 2 later load steps)"));
}

TEST_CASE("points that a nearly singular stiffness throws away are named with their cell", "[engine][quasi_static]") {
  // two points almost in one place: the motion of their cell's free nodes has a stiffness of 1e-12 of what it should
  Scene scene = with_strays({Vec2(-0.059, -0.015), Vec2(-0.059 + 1e-8, -0.015 + 2e-8)}, 1e3);
  CHECK_THAT(failure(scene), Contains("load step 1: the material point at (-0.059, -0.015) would move by") &&
                                 Contains("the size of the body") &&
                                 Contains("cell around (-0.0625, -0.0125) with 2 material points") &&
                                 Contains("ghost"));
}

TEST_CASE("a body all of whose functions are held does not move", "[engine][quasi_static]") {
  const auto held = changed({.cells = 1, .method = EssentialMethod::grid},
                            [](Case::Boundary& b) { b.condition = Essential{.method = EssentialMethod::grid}; });
  CHECK(failure(held) == "no failure");
}

TEST_CASE("a body that leaves the grid ends the run with the step that took it there, also the last",
          "[engine][quasi_static]") {
  const auto [load, reason] = GENERATE(std::pair(-3e6, "piece 'right': leaves the grid at"),
                                       std::pair(-9e6, "material points lie outside the grid, the first is point"));
  const int steps = GENERATE(1, 4);
  const double share = steps == 1 ? 0.25 : 1.0;
  Scene scene = test::compression_square({.cells = 6, .load = share * load, .steps = steps});  // strains of order one
  RunRecord record;
  int saved = 0;
  const auto pull = [&] { run_load_steps(scene, {.after_step = [&](int step) { saved = step; }}, record); };
  CHECK_THROWS_WITH(pull(), Contains("load step 1: ") && Contains(reason) && Contains("enlarge the grid"));
  CHECK(saved == 0);
  CHECK(record.steps == 1);  // it has moved: its state is that of the scene
  CHECK(scene.points.displacement.norm() > 0.0);
}

TEST_CASE("a body whose edge comes to cross itself ends the run with step, piece, place and remedy",
          "[engine][quasi_static]") {
  // two arms on a common foot, pressed together until they overlap in the middle
  const std::vector<Vec2> corners = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.4}, {0.7, 1.4},
                                     {0.7, 0.3}, {0.3, 0.3}, {0.3, 1.4}, {0.0, 1.4}};
  const std::vector<const char*> names = {"foot", "right",      "top right", "inner right",
                                          "gap",  "inner left", "top left",  "left"};
  Case problem;
  problem.file = "arms.json";
  problem.material = {.youngs_modulus = 1e6, .poissons_ratio = 0.25, .density = {}};
  problem.grid = {.lower = Vec2(-0.55, -0.25), .upper = Vec2(1.55, 2.0), .cell_size = Vec2(0.1, 0.1)};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    Piece side{.name = names[k], .points = {}};
    for (int i = 0; i <= 4; ++i) side.points.push_back(corners[k] + 0.25 * i * (corners[(k + 1) % 8] - corners[k]));
    problem.boundaries.push_back({side, Case::Free{}});
  }
  problem.boundaries[0].condition = Essential{};
  problem.boundaries[7].condition = Case::Traction{std::array{Quantity(2e4), Quantity(0.0)}};
  problem.material_points = LatticeFill{{2, 2}, VolumeRule::clipped};
  problem.ghost = 1e-3;
  std::get<QuasiStatic>(problem.analysis).load_steps = 8;
  Scene scene = build_scene(problem);
  RunRecord record;
  int saved = 0;
  const auto press = [&] { run_load_steps(scene, {.after_step = [&](int step) { saved = step; }}, record); };
  CHECK_THROWS_WITH(press(), Contains("load step") && Contains("crosses or touches piece 'inner left' at (") &&
                                 Contains("smaller load steps"));
  CHECK(record.steps == saved + 1);
  CHECK(saved >= 1);
}

TEST_CASE("tracking points that have come to coincide are named", "[engine][quasi_static]") {
  Scene scene = test::disc();
  std::vector<Vec2>& points = scene.boundary[0].piece.points;
  check_motion(scene);
  points[4] = points[3];
  CHECK_THROWS_WITH(check_motion(scene),
                    Contains("piece 'rim': points 3 and 4 are the same") && Contains("smaller load steps"));
}

TEST_CASE("a load that is not a number is reported, not computed with", "[engine][quasi_static]") {
  Case problem = test::compression_case({.cells = 4});
  problem.body_force = {Quantity(NAN), Quantity(0.0)};
  CHECK_THAT(failure(problem), Contains("load step 1") && Contains("not finite"));
}
