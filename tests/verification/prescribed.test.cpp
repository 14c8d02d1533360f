// Displacements prescribed on boundaries that lie anywhere in the grid.
#include <catch2/catch.hpp>

#include "../scenes.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const Mat2 gradient = (Mat2() << 0.01, -0.02, 0.005, -0.015).finished();

/// A turned square all of whose sides move by a linear field of the original position, ramped.
Case stretched(EssentialMethod method, double angle, int steps, Loading loading) {
  Case problem = test::compression_case({.angle = angle,
                                         .shift = angle == 0.0 ? Vec2::Zero() : Vec2(0.003, -0.002),
                                         .cells = 7,
                                         .per_cell = 3,
                                         .ghost = 1e-3,
                                         .steps = steps,
                                         .loading = loading});
  const auto component = [](int row) {
    return Expression("t*(gx*X + gy*Y)", {{"gx", gradient(row, 0)}, {"gy", gradient(row, 1)}});
  };
  for (Case::Boundary& b : problem.boundaries)
    b.condition = Case::Displacement{std::array{Quantity(component(0)), Quantity(component(1))},
                                     {.method = method, .band = method == EssentialMethod::nitsche ? 0.01 : 1e-3}};
  return problem;
}

/// Largest distance of the points' displacement from the linear field, over the field's largest.
double largest_error(const Case& problem) {
  Scene scene = build_scene(problem);
  RunRecord record;
  run_load_steps(scene, {}, record);
  double error = 0.0;
  double size = 0.0;
  for (Index p = 0; p < scene.points.size(); ++p) {
    const Vec2 origin = scene.points.position.col(p) - scene.points.displacement.col(p);
    error = std::max(error, (scene.points.displacement.col(p) - gradient * origin).norm());
    size = std::max(size, (gradient * origin).norm());
  }
  return error / size;
}

}  // namespace

TEST_CASE("a linear field on the whole boundary is the field inside", "[verification][prescribed]") {
  for (const Loading loading : {Loading::residual, Loading::incremental})
    for (const double angle : {0.3, 0.9}) {
      CAPTURE(angle, loading);
      CHECK(largest_error(stretched(EssentialMethod::nitsche, angle, 1, loading)) <= 1e-6);
      CHECK(largest_error(stretched(EssentialMethod::implicit_boundary, angle, 1, loading)) <= 1e-3);
    }
  CHECK(largest_error(stretched(EssentialMethod::grid, 0.0, 1, Loading::residual)) <= 1e-9);
}

TEST_CASE("a boundary arrives in steps where its displacement is prescribed", "[verification][prescribed]") {
  for (const Loading loading : {Loading::residual, Loading::incremental}) {
    const Case problem = stretched(EssentialMethod::implicit_boundary, 0.3, 4, loading);
    Scene scene = build_scene(problem);
    RunRecord record;
    run_load_steps(scene, {}, record);
    for (std::size_t k = 0; k < scene.boundary.size(); ++k) {
      const Vec2& origin = problem.boundaries[k].piece.points[0];
      const Vec2 moved = scene.boundary[k].piece.points[0] - origin;
      CHECK((moved - gradient * origin).norm() <= 3e-3 * (gradient * origin).norm());  // the slip of the band
    }
  }
}

TEST_CASE("a roller that moves into the body compresses it uniformly", "[verification][prescribed]") {
  constexpr double side = 0.1;
  constexpr double press = 1e-4;
  for (const double angle : {0.0, 0.7}) {
    Case problem = test::compression_case({.angle = angle,
                                           .shift = Vec2(0.003, -0.002),
                                           .side = side,
                                           .cells = 7,
                                           .per_cell = 3,
                                           .method = EssentialMethod::nitsche,
                                           .ghost = 1e-3});
    problem.boundaries[2].condition =
        Case::Displacement{Quantity(press), {.normal_only = true, .method = EssentialMethod::nitsche, .band = 0.01}};
    for (Case::Boundary& b : problem.boundaries)
      if (auto* roller = std::get_if<Essential>(&b.condition)) roller->band = 0.01;
    Scene scene = build_scene(problem);
    RunRecord record;
    run_load_steps(scene, {}, record);
    const Mat3 tangent = scene.material->tangent(Stress::Zero());
    const double thrust = tangent(1, 1) * press / side * side;
    const Vec2 down(std::sin(angle), -std::cos(angle));
    CHECK_THAT((record.resultants.reactions.at("top").head<2>() - thrust * down).norm(), WithinAbs(0.0, 1e-6 * thrust));
    CHECK(test::imbalance(record.resultants).norm() <= 1e-9 * thrust);
    CHECK(record.fit_errors.size() == 1);
    CHECK(record.fit_errors.at("top").l2 <= 1e-7 * press);
  }
}

TEST_CASE("without a prescribed displacement nothing is fitted", "[verification][prescribed]") {
  Scene scene = test::turned_square();
  RunRecord record;
  run_load_steps(scene, {}, record);
  CHECK(record.fit_errors.empty());
}
