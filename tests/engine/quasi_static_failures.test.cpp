// What load steps cannot be taken, and what is said then.
#include <catch2/catch.hpp>

#include "../scenes.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;

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

TEST_CASE("a part that nothing holds is found beside one that is held", "[engine][quasi_static]") {
  Scene scene = test::compression_square({.cells = 4});
  const auto n = static_cast<Eigen::Index>(scene.points.size());
  Eigen::Matrix2Xd position(2, n + 1);
  position << scene.points.position, Vec2(-0.10625, 0.10625);  // far off in the corner of the grid
  scene.points = points_at(position, Eigen::VectorXd::Constant(n + 1, 6.25e-4));
  CHECK_THAT(failure(scene),
             Contains("a separate part of the body with 1 material point in 1 cell around (-0.10625, 0.10625)"));
}

TEST_CASE("a motion without strain at the points is refused with its place and the remedy", "[engine][quasi_static]") {
  // one point in one cell and two rollers: four unknowns, three strains
  const auto loose = changed({.cells = 1, .method = EssentialMethod::grid}, [](Case::Boundary& b) {
    if (b.piece.name == "right") b.condition = Case::Free{};
  });
  CHECK_THAT(failure(loose), Contains("load step 1: the stiffness is singular") && Contains("1 material point of") &&
                                 Contains("ghost"));
}

TEST_CASE("a body all of whose functions are held does not move", "[engine][quasi_static]") {
  const auto held = changed({.cells = 1, .method = EssentialMethod::grid},
                            [](Case::Boundary& b) { b.condition = Essential{.method = EssentialMethod::grid}; });
  CHECK(failure(held) == "no failure");
}

TEST_CASE("a body that leaves the grid ends the run with the load step; the steps before are kept",
          "[engine][quasi_static]") {
  const auto [load, reason] = GENERATE(std::pair(-3e6, "piece 'right': leaves the grid at"),
                                       std::pair(-9e6, "material points lie outside the grid, the first is point"));
  Scene scene = test::compression_square({.cells = 6, .load = load, .steps = 4});  // pulled to strains of order one
  RunRecord record;
  int saved = 0;
  const auto pull = [&] { run_load_steps(scene, {.after_step = [&](int step) { saved = step; }}, record); };
  CHECK_THROWS_WITH(pull(), Contains("load step 2: ") && Contains(reason));
  CHECK(saved == 1);
  CHECK(record.steps == 1);
}

TEST_CASE("a load that is not a number is reported, not computed with", "[engine][quasi_static]") {
  Case problem = test::compression_case({.cells = 4});
  problem.body_force = {Quantity(NAN), Quantity(0.0)};
  CHECK_THAT(failure(problem), Contains("load step 1") && Contains("not finite"));
}
