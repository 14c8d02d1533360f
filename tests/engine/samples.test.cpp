// Sample points, engine/src/sample_points.hpp: errors of every method measured at the same places.

#include <omp.h>

#include <catch2/catch.hpp>

#include "../../engine/src/move_points.hpp"
#include "../../engine/src/passive_points.hpp"
#include "../../engine/src/sample_points.hpp"
#include "../../engine/src/threads.hpp"
#include "../patch_square.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/linear_solver.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;
using test::run;

namespace {

ErrorNorms at_samples(const Scene& scene) { return error_norms(scene.samples.value(), scene.exact.value(), 1.0); }

/// The patch test with sample points.
Scene patch(const Case::Grid& grid, int steps, Loading loading, bool projected) {
  test::PatchSquare square = test::patch_square(grid, steps, loading, projected);
  square.problem.samples = 13;
  Scene scene = build_scene(square.problem);
  scene.exact = square.exact;
  return scene;
}

std::vector<test::NamedGrid> grids() { return test::every_grid(Vec2(-1.0, -1.0), 2.0, 9); }

struct Measured {
  double displacement;  ///< relative L2
  double stress;        ///< relative L2
};

Measured measured(const ErrorNorms& norms) {
  return {norms.displacement_l2_relative.value(), norms.stress_l2_relative.value()};
}

}  // namespace

TEST_CASE("patch test: a linear field is exact at the samples on every basis, in every loading", "[engine][samples]") {
  for (const auto& [name, grid] : grids())
    for (const int steps : {1, 5})
      for (const Loading loading : {Loading::residual, Loading::incremental})
        for (const bool projected : {false, true}) {
          CAPTURE(name, steps, loading, projected);
          Scene scene = patch(grid, steps, loading, projected);
          run(scene);
          const Measured error = measured(at_samples(scene));
          CHECK(error.displacement <= 1e-11);
          CHECK(error.stress <= 1e-11);
        }
}

TEST_CASE("sub-cells of samples are squares where the sides are in a ratio of whole numbers", "[engine][samples]") {
  const auto samples = [](double width, double height, int across) {
    const Piece rectangle{.name = "rim",
                          .points = {{0, 0}, {width, 0}, {width, height}, {0, height}},
                          .corners = {0, 1, 2, 3},
                          .closed = true};
    return place_samples(std::vector{fit_spline(rectangle)}, across);
  };
  for (const auto& [width, height] : {std::pair(0.3, 0.1), std::pair(0.1, 0.3)}) {
    const MaterialPoints points = samples(width, height, 30);
    CHECK(points.size() == 300);
    for (const Eigen::Index axis : {0, 1})  // half a sub-cell from the edge
      CHECK_THAT(points.position.row(axis).minCoeff(), WithinRel(0.005, 1e-9));
  }
  CHECK(samples(0.7, 0.7, 7).size() == 49);
  CHECK(samples(1.0, 0.31, 10).size() == 40);  // rounded up
  CHECK(samples(1.0, 1e-3, 2).size() == 2);
}

TEST_CASE("samples change nothing of a run, and without them nothing is located or timed", "[engine][samples]") {
  for (const bool projected : {false, true}) {
    Case problem = test::compression_case(
        {.angle = 0.3, .shift = Vec2(0.002, 0.001), .per_cell = 2, .ghost = 1e-3, .load = 5e4, .steps = 3});
    problem.material.projected_dilatation = projected;
    Scene without = build_scene(problem);
    problem.samples = 40;
    Scene with = build_scene(problem);
    const RunRecord plain = run(without);
    const RunRecord measured = run(with);
    CHECK(without.points.position == with.points.position);
    CHECK(without.points.stress == with.points.stress);
    CHECK(plain.resultants.reactions == measured.resultants.reactions);
    CHECK(plain.resultants.loads == measured.resultants.loads);
    CHECK_FALSE(without.samples);
    const auto calls = [](const RunRecord& record) {
      long sum = 0;
      for (const Clock::Entry& entry : record.phases.entries()) sum += entry.name == "errors" ? entry.calls : 0;
      return sum;
    };
    CHECK(calls(plain) == 0);
    CHECK(calls(measured) == 3);
    CHECK(plain.phases.entries().size() + 1 == measured.phases.entries().size());
  }
}

TEST_CASE("the time of placing samples is booked under errors", "[engine][samples]") {
  Case problem = test::compression_case({});
  const auto names = [&] {
    Clock clock;
    static_cast<void>(build_scene(problem, clock));
    std::vector<std::string> found;
    for (const Clock::Entry& entry : clock.entries()) found.push_back(entry.name);
    return found;
  };
  CHECK(names() == std::vector<std::string>{"setup"});
  problem.samples = 10;
  CHECK(names() == std::vector<std::string>{"setup", "errors"});
}

TEST_CASE("samples at material points are carried as those are, to the last digit", "[engine][samples]") {
  for (const bool projected : {false, true})
    for (const auto& [name, grid] : grids()) {
      CAPTURE(name, projected);
      Case problem = test::disc_case(0.7, 0.1, Essential{.method = EssentialMethod::nitsche, .band = 0.01});
      problem.grid = grid;
      problem.ghost = 1e-3;
      problem.material.projected_dilatation = projected;
      problem.body_force = {Quantity(4e4), Quantity(-9e4)};
      std::get<QuasiStatic>(problem.analysis).load_steps = 3;
      Scene scene = build_scene(problem);
      scene.samples = scene.points;
      run(scene);
      CHECK(scene.samples->displacement.norm() > 1e-3);
      CHECK(scene.samples->position == scene.points.position);
      CHECK(scene.samples->displacement == scene.points.displacement);
      CHECK(scene.samples->strain == scene.points.strain);
      CHECK(scene.samples->stress == scene.points.stress);
    }
}

TEST_CASE("a sample in a cell without points has the polynomials of the nearest cell with some", "[engine][samples]") {
  const Mat2 gradient = (Mat2() << 1e-3, 4e-3, -2e-3, 5e-3).finished();
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    Case problem = test::disc_case(0.7, 0.1, Case::Free{});
    problem.grid = grid;
    problem.material_points = AcrossFill{.across = {6, 6}};  // the grid has finer cells
    problem.samples = 50;
    Scene scene = build_scene(problem);
    const PointSupports points = locate_points(*scene.basis, scene.points);
    const PointSupports served =
        locate_passive(*scene.basis, points.active, *scene.samples, [](std::size_t) { return ""; });
    for (const Index cell : served.cell) REQUIRE(points.active[static_cast<std::size_t>(cell)]);
    Index elsewhere = 0;
    for (Index p = 0; p < scene.samples->size(); ++p) {
      const auto cell = scene.basis->grid().locate(scene.samples->position.col(p), 0).value();
      elsewhere += points.active[static_cast<std::size_t>(cell)] ? 0 : 1;
    }
    CHECK(elsewhere >= 100);

    scene.samples->strain = Eigen::Matrix3Xd::Zero(3, scene.samples->size());
    const MaterialPoints before = *scene.samples;
    const Eigen::Matrix2Xd field = test::linear_field(*scene.basis, gradient);
    move_points({*scene.basis, *scene.material, field, nullptr}, served, *scene.samples);
    CHECK((scene.samples->displacement - gradient * before.position).norm() <= 1e-12 * before.position.norm());
    const Vec3 strain(gradient(0, 0), gradient(1, 1), gradient(0, 1) + gradient(1, 0));
    CHECK((scene.samples->strain.colwise() - strain).cwiseAbs().maxCoeff() <= 1e-11 * strain.norm());
  }
}

TEST_CASE("a cut corner without points has samples like any other place of the body", "[engine][samples]") {
  const test::CompressionSquare square{
      .angle = 0.4, .shift = Vec2(-0.134, 0.0433), .side = 1.0, .method = EssentialMethod::nitsche, .load = 1e-6};
  for (const auto& [name, grid] : test::every_grid({-1.0, -1.0}, 2.0, 5)) {
    if (grid.mesh || grid.basis == Case::BasisType::linear || grid.basis == Case::BasisType::powell_sabin) continue;
    CAPTURE(name);
    Case problem = test::compression_case(square);
    std::vector<Vec2> corners;
    for (const Case::Boundary& side : problem.boundaries) corners.push_back(side.piece.points.front());
    problem.grid = grid;
    problem.ghost = ghost_for_nitsche(grid.basis, grid.degree);
    const double line = -1.0 + grid.cell_size.y();  // the tip of the lowest corner lies below it, in one cell
    std::vector<Case::ListedPoint> points = test::patch_points(grid, corners);
    std::erase_if(points, [&](const Case::ListedPoint& p) { return p.position.y() < line; });
    problem.material_points = points;
    problem.samples = 300;
    Scene scene = build_scene(problem);
    scene.exact = test::compression_square(square).exact;
    const auto in_tip = scene.samples.value().position.row(1).array() < line;
    REQUIRE(in_tip.count() >= 5);
    run(scene);
    const Measured samples = measured(at_samples(scene));
    const Vec3 exact = scene.exact->stress(corners[0], 1.0);
    double worst = 0.0;
    for (Index p = 0; p < scene.samples->size(); ++p)
      if (in_tip[p]) worst = std::max(worst, (scene.samples->stress.col(p).head<3>() - exact).norm() / exact.norm());
    CHECK(samples.displacement <= 1e-3);
    CHECK(samples.stress <= 3e-3);
    CHECK(worst <= 0.03);
  }
}

TEST_CASE("samples do not depend on the number of threads", "[engine][samples]") {
  const int threads_before = omp_get_max_threads();
  set_blas_threads(1);
  const auto samples_with = [](int threads) {
    omp_set_num_threads(threads);
    Case problem = test::compression_case({.cells = 8, .method = EssentialMethod::grid, .load = 5e4, .steps = 2});
    problem.grid.basis = Case::BasisType::linear;  // whose stress jumps at the edges on which samples lie
    problem.samples = 160;
    Scene scene = build_scene(problem);
    REQUIRE(worth_threads(static_cast<std::size_t>(scene.samples->size())));
    run(scene);
    return scene.samples.value();
  };
  const MaterialPoints one = samples_with(1);
  const MaterialPoints two = samples_with(2);
  omp_set_num_threads(threads_before);
  CHECK(one.position == two.position);
  CHECK(one.stress == two.stress);
}

TEST_CASE("a sample outside the grid ends the run with its place", "[engine][samples]") {
  Case problem = test::compression_case({.steps = 2});
  problem.samples = 10;
  Scene scene = build_scene(problem);
  scene.samples->position.col(7) = Vec2(9.0, 0.5);
  CHECK_THROWS_WITH(run(scene), Contains("load step 1: sample point 7 at (9, 0.5)") && Contains("enlarge the grid"));
}
