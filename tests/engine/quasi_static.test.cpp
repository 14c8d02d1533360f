#include "shoreline/engine/quasi_static.hpp"

#include <omp.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "../../engine/src/threads.hpp"
#include "../random.hpp"
#include "../scenes.hpp"
#include "shoreline/engine/linear_solver.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

RunRecord run(Scene& scene) {
  RunRecord record;
  run_load_steps(scene, {}, record);
  return record;
}

RunRecord run(const test::CompressionSquare& square) {
  Scene scene = test::compression_square(square);
  return run(scene);
}

const std::vector<test::CompressionSquare> methods = {
    {.angle = 0.5, .shift = Vec2(0.003, 0.001), .method = EssentialMethod::implicit_boundary},
    {.angle = 1.1, .shift = Vec2(-0.002, 0.004), .method = EssentialMethod::implicit_boundary, .ghost = 1e-3},
    {.angle = 0.5, .shift = Vec2(0.003, 0.001), .band = 0.01, .method = EssentialMethod::nitsche, .ghost = 1e-3},
    {.per_cell = 2, .method = EssentialMethod::grid}};

}  // namespace

TEST_CASE("the square's exact solution is met, in one step and in many", "[engine][quasi_static]") {
  for (const int steps : {1, 3})
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      test::CompressionSquare square{
          .angle = 0.4, .shift = Vec2(0.002, 0.003), .band = 0.01, .method = EssentialMethod::nitsche, .ghost = 1e-3};
      square.steps = steps;
      square.plane = plane;
      square.load = 1e-3;  // a strain of 1e-9: the geometry stays
      Scene scene = test::compression_square(square);
      run(scene);
      const ErrorNorms norms = error_norms(scene.points, *scene.exact, 1.0);
      CHECK(norms.displacement_l2_relative.value() < 1e-8);
      CHECK(norms.stress_l2_relative.value() < 1e-8);
      const Mat3 tangent = scene.material->tangent(Stress::Zero());
      CHECK((tangent * scene.points.strain - scene.points.stress.topRows<3>()).norm() <=
            1e-12 * scene.points.stress.norm());
    }
}

TEST_CASE("residual loading: a load that is held does not move the body again", "[engine][quasi_static]") {
  for (test::CompressionSquare square : methods) {
    square.load = 1e-12;  // a strain of 1e-18 leaves every position as it is
    square.held_load = true;
    square.steps = 10;
    Scene scene = test::compression_square(square);
    RunRecord record;
    std::vector<double> increment;
    const auto note = [&](int) { increment.push_back(record.largest_increment); };
    run_load_steps(scene, {.condition_estimate = true, .after_step = note}, record);
    REQUIRE(increment.size() == 10);
    CHECK(increment[0] > 0.0);
    // what rounding left of the first solution is found in the second step
    const double rounding = std::numeric_limits<double>::epsilon() * record.condition_estimate.value();
    CHECK(increment[1] <= std::max(1e-12, rounding) * increment[0]);
    for (std::size_t k = 2; k < 10; ++k) CHECK(increment[k] <= 1e-12 * increment[0]);
  }
}

TEST_CASE("reactions balance loads, forces and moment", "[engine][quasi_static]") {
  for (test::CompressionSquare square : methods)
    for (const double band : {1e-3, 1e-6}) {
      square.band = band;
      square.steps = band < 1e-4 ? 1 : 3;
      const RunRecord record = run(square);
      const Vec3 sum = test::imbalance(record.resultants);
      const double force = square.load * square.side;
      const double tolerance = band < 1e-4 ? 1e-9 : 1e-11;
      CHECK(sum.head<2>().norm() <= tolerance * force);
      CHECK(std::abs(sum[2]) <= tolerance * force * square.side);
      CHECK_THAT(record.resultants.loads.at("top").head<2>().norm(), WithinAbs(force, 1e-5 * force));
      CHECK_THAT(record.resultants.reactions.at("bottom").head<2>().norm(), WithinAbs(force, 0.01 * force));
    }
}

TEST_CASE("residual loading keeps the balance where a roller's piece turns as the body moves",
          "[engine][quasi_static]") {
  for (const bool roller : {true, false})
    for (const EssentialMethod method : {EssentialMethod::implicit_boundary, EssentialMethod::nitsche}) {
      const Essential held{.normal_only = roller, .method = method, .band = 0.01};
      Case problem = test::disc_case(1.0, 0.23, held);
      problem.body_force = {Quantity(4e4), Quantity(-9e4)};
      std::get<QuasiStatic>(problem.analysis).load_steps = 4;
      problem.ghost = 1e-3;
      Scene scene = build_scene(problem);
      const RunRecord record = run(scene);
      CHECK(scene.points.displacement.colwise().norm().maxCoeff() > 1e-2);
      const Vec3 sum = test::imbalance(record.resultants);
      CHECK(sum.norm() <= 1e-9 * record.resultants.loads.at("body_force").norm());
    }
}

TEST_CASE("a run does not depend on the number of threads, to the last digit", "[engine][quasi_static]") {
  const int threads_before = omp_get_max_threads();
  set_blas_threads(1);
  const auto points_with = [](int threads) {
    omp_set_num_threads(threads);
    Scene scene = test::compression_square({.angle = 0.3, .cells = 150, .ghost = 1e-3, .steps = 1});
    REQUIRE(worth_threads(static_cast<std::size_t>(scene.points.size())));
    run(scene);
    return scene.points;
  };
  const MaterialPoints one = points_with(1);
  const MaterialPoints two = points_with(2);
  omp_set_num_threads(threads_before);
  CHECK(one.position == two.position);
  CHECK(one.stress == two.stress);
}

TEST_CASE("incremental and residual loading agree at small strain", "[engine][quasi_static]") {
  for (test::CompressionSquare square : methods) {
    square.load = 1.0;  // a strain of 1e-6
    square.steps = 4;
    Scene residual = test::compression_square(square);
    square.loading = Loading::incremental;
    Scene incremental = test::compression_square(square);
    const RunRecord first = run(residual);
    const RunRecord second = run(incremental);
    const auto difference = (residual.points.displacement - incremental.points.displacement).eval();
    CHECK(difference.norm() <= 1e-4 * residual.points.displacement.norm());
    CHECK(difference.norm() > 0.0);
    for (const auto& [name, load] : first.resultants.loads)
      CHECK((load - second.resultants.loads.at(name)).norm() <= 1e-4 * square.load * square.side);
    for (const auto& [name, reaction] : first.resultants.reactions)
      CHECK((reaction - second.resultants.reactions.at(name)).norm() <= 1e-4 * square.load * square.side);
  }
}

TEST_CASE("tracking points move with the material, and joined pieces stay joined", "[engine][quasi_static]") {
  test::Random random(2);
  for (int draw = 0; draw < 20; ++draw) {
    Case problem =
        test::compression_case({.shift = random.vector(-0.01, 0.01), .cells = 6, .ghost = 1e-3, .load = 1e4});
    const Vec2 spike = random.vector(0.0, 0.03);
    problem.boundaries[1].piece.points.back() += spike;
    problem.boundaries[2].piece.points.front() += spike;
    problem.material_points = LatticeFill{{1, 1}, VolumeRule::lattice};  // leaves cells at the spike empty
    Scene scene = build_scene(problem);
    const Vec2 before = scene.boundary[2].piece.points.front();
    run(scene);
    CHECK((scene.boundary[2].piece.points.front() - before).norm() > 1e-4);
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(scene.boundary[k].piece.points.back() == scene.boundary[(k + 1) % 4].piece.points.front());
  }
}

TEST_CASE("one step takes one analysis and one factorisation, a kept pattern no further analysis",
          "[engine][quasi_static]") {
  for (test::CompressionSquare square : methods) {
    square.load = 1e-3;
    const RunRecord once = run(square);
    CHECK(once.factorisations == 1);
    CHECK(once.analyses == 1);
    square.steps = 3;
    const RunRecord thrice = run(square);
    CHECK(thrice.factorisations == 3);
    CHECK(thrice.analyses == 1);
    CHECK(thrice.steps == 3);
  }
}

TEST_CASE("runs by every solver agree", "[engine][quasi_static]") {
  for (const test::CompressionSquare& square : methods) {
    const auto moved = [&](SolverType type) {
      Scene scene = test::compression_square(square);
      RunRecord record;
      run_load_steps(scene, {.solver = type}, record);
      CHECK(record.solver->type == type);
      CHECK(record.solver->unknowns == record.degrees_of_freedom);
      CHECK(record.solver->iterations.has_value() == (type == SolverType::multigrid));
      return scene.points.displacement;
    };
    const Eigen::Matrix2Xd direct = moved(SolverType::cholmod);
    CHECK((moved(SolverType::band) - direct).norm() <= 1e-10 * direct.norm());
    if (multigrid_available()) CHECK((moved(SolverType::multigrid) - direct).norm() <= 1e-8 * direct.norm());
  }
}

TEST_CASE("multigrid that does not converge ends the run and says what to try", "[engine][quasi_static]") {
  if (!multigrid_available()) return;
  test::CompressionSquare square{.band = 0.1, .method = EssentialMethod::nitsche};
  Case problem = test::compression_case(square);
  problem.boundaries[0].condition = Essential{.method = EssentialMethod::nitsche, .band = 10.0};
  Scene scene = build_scene(problem);
  RunRecord record;
  CHECK_THROWS_WITH(run_load_steps(scene, {.solver = SolverType::multigrid}, record),
                    Catch::Matchers::Contains("iterations") && Catch::Matchers::Contains("\"cholmod\"") &&
                        Catch::Matchers::Contains("ghost"));
}

TEST_CASE("a stiffness that is not positive definite is solved all the same, and said to be so",
          "[engine][quasi_static]") {
  test::Random random(1);
  int indefinite = 0;
  for (int draw = 0; draw < 10; ++draw) {
    Scene scene = test::compression_square({.angle = random.uniform(0.1, 1.5),
                                            .shift = random.vector(-0.005, 0.005),
                                            .cells = 8,
                                            .per_cell = 2,
                                            .band = 0.1,
                                            .method = EssentialMethod::nitsche});
    const RunRecord record = run(scene);
    const ErrorNorms norms = error_norms(scene.points, *scene.exact, 1.0);
    CHECK(norms.stress_l2_relative.value() < 1e-9);
    if (record.warnings.empty()) continue;
    ++indefinite;
    CHECK_THAT(record.warnings.front(), Contains("load step 1") && Contains("not positive definite"));
  }
  CHECK(indefinite > 0);
}

TEST_CASE("a condition estimate is made where it is asked for", "[engine][quasi_static]") {
  Scene scene = test::compression_square({.cells = 4});
  RunRecord record;
  run_load_steps(scene, {.condition_estimate = true}, record);
  CHECK(record.condition_estimate.value() > 1.0);
  CHECK_FALSE(run({.cells = 4}).condition_estimate);
}

TEST_CASE("too few points for the degree of the functions are reported, with the number that they need",
          "[engine][quasi_static]") {
  const auto warnings = [](Case::BasisType basis, int per_cell) {
    Case problem = test::compression_case({.cells = 4, .per_cell = per_cell, .ghost = 1e-3});
    problem.grid.basis = basis;
    Scene scene = build_scene(problem);
    RunRecord record;
    run_load_steps(scene, {}, record);
    return record.warnings;
  };
  const std::vector<std::string> few = warnings(Case::BasisType::bspline, 2);
  REQUIRE(few.size() == 1);
  CHECK(few[0].find("material_points.per_cell to 3") != std::string::npos);
  CHECK(warnings(Case::BasisType::bspline, 3).empty());
  CHECK(warnings(Case::BasisType::powell_sabin, 1).empty());
  CHECK(warnings(Case::BasisType::bilinear, 2).empty());
}
