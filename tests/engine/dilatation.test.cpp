#include "shoreline/engine/dilatation.hpp"

#include <omp.h>

#include <catch2/catch.hpp>
#include <limits>

#include "../../engine/src/effects/slip_points.hpp"
#include "../../engine/src/threads.hpp"
#include "../nearly_incompressible.hpp"
#include "../random.hpp"
#include "../scenes.hpp"
#include "dense_blocks.hpp"
#include "shoreline/engine/effects.hpp"
#include "shoreline/engine/linear_solver.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;

namespace {

/// The disc, which its grid cuts anywhere, on another basis.
Scene projected_disc(Case::Grid grid, int per_cell = 4) {
  Case problem = test::disc_case(1.0, 0.21, Essential{});
  grid.cell_size = problem.grid.cell_size;
  problem.grid = grid;
  problem.material_points = LatticeFill{{per_cell, per_cell}, VolumeRule::clipped};
  problem.material.projected_dilatation = true;
  return build_scene(problem);
}

std::vector<test::NamedGrid> grids() { return test::every_grid(Vec2(-1.6, -1.6), 3.3, 15); }

Eigen::Matrix2Xd random_field(const Basis& basis) {
  test::Random random(5);
  Eigen::Matrix2Xd field(2, basis.functions());
  for (Index f = 0; f < basis.functions(); ++f) field.col(f) = random.vector(-1.0, 1.0);
  return field;
}

/// tr ε of a field at every point.
Eigen::RowVectorXd own(const Scene& scene, const PointSupports& supports, const Eigen::Matrix2Xd& field) {
  Eigen::RowVectorXd trace(scene.points.size());
  for (Index c = 0; c < supports.cells(); ++c)
    for (Index k = supports.first[static_cast<std::size_t>(c)]; k < supports.first[static_cast<std::size_t>(c) + 1];
         ++k) {
      const Index p = supports.point[static_cast<std::size_t>(k)];
      trace[p] = scene.basis->support(supports.cell[static_cast<std::size_t>(c)], scene.points.position.col(p))
                     .gradient_of(field)
                     .trace();
    }
  return trace;
}

test::CompressionSquare square_of(EssentialMethod method) {
  if (method == EssentialMethod::grid) return {.per_cell = 2, .method = method};
  return {.angle = 0.5,
          .shift = Vec2(0.003, 0.001),
          .band = method == EssentialMethod::nitsche ? 0.01 : 1e-3,
          .method = method,
          .ghost = 1e-3};
}

Scene projected_square(const test::CompressionSquare& square) {
  Case problem = test::compression_case(square);
  problem.material.projected_dilatation = true;
  return build_scene(problem);
}

}  // namespace

TEST_CASE("the projection is orthogonal over the points' volumes and keeps constants", "[engine][dilatation]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Scene scene = projected_disc(grid);
    const PointSupports supports = locate_points(*scene.basis, scene.points);
    const Dilatation dilatation(*scene.basis, {scene.projected->groups, 1.0}, scene.points, supports);
    const Eigen::Matrix2Xd linear = test::linear_field(*scene.basis, (Mat2() << 2.0, 0.3, -0.7, 1.0).finished());
    CHECK(dilatation.correction(scene.points, supports, linear).cwiseAbs().maxCoeff() <= 1e-10);

    const Eigen::Matrix2Xd field = random_field(*scene.basis);
    const Eigen::RowVectorXd trace = own(scene, supports, field);
    const Eigen::RowVectorXd lost = dilatation.correction(scene.points, supports, field);
    const Eigen::RowVectorXd projected = trace + lost;
    const auto product = [&](const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) {
      return a.cwiseProduct(b).dot(scene.points.volume.transpose());
    };
    CHECK(std::abs(product(lost, projected)) <= 1e-10 * product(trace, trace));
    CHECK(product(lost, lost) > 0.01 * product(trace, trace));
    double energy = 0.0;
    for (const DilatationPatch& patch : dilatation.patches()) {
      Eigen::VectorXd local(2 * static_cast<Eigen::Index>(patch.functions.size()));
      for (std::size_t a = 0; a < patch.functions.size(); ++a)
        local.segment<2>(2 * static_cast<Eigen::Index>(a)) = field.col(patch.functions[a]);
      energy += (patch.divergence * local).squaredNorm();
    }
    CHECK(energy == Approx(product(projected, projected)).epsilon(1e-10));
  }
}

TEST_CASE("internal forces of projected stresses are the stiffness times the increment", "[engine][dilatation]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    Scene scene = projected_disc(grid);
    const PointSupports supports = locate_points(*scene.basis, scene.points);
    const Dilatation dilatation(*scene.basis, *scene.projected, scene.points, supports);
    const Eigen::Matrix2Xd none(2, 0);
    const std::vector<Edge> edges;
    const StepState step{*scene.basis, scene.points, supports, edges, Loading::residual, 1.0, 0.0, none, &dilatation};
    const Eigen::Matrix2Xd field = random_field(*scene.basis);
    const auto without_lambda = stiffness_of(std::make_shared<LinearElastic>(1e6 / 1.25, 0.0, Plane::strain));
    ElementBlocks blocks = test::blocks_of(*without_lambda, step);
    projected_dilatation()->add(step, blocks);
    const Eigen::Matrix2Xd force = test::times(blocks, field);

    const Eigen::RowVectorXd trace = own(scene, supports, field);
    const Eigen::RowVectorXd correction = dilatation.correction(scene.points, supports, field);
    for (Index c = 0; c < supports.cells(); ++c)
      for (Index k = supports.first[static_cast<std::size_t>(c)]; k < supports.first[static_cast<std::size_t>(c) + 1];
           ++k) {
        const Index p = supports.point[static_cast<std::size_t>(k)];
        const Mat2 g = scene.basis->support(supports.cell[static_cast<std::size_t>(c)], scene.points.position.col(p))
                           .gradient_of(field);
        scene.points.stress.col(p) = scene.material->updated(Stress::Zero(), {g(0, 0), g(1, 1), g(0, 1) + g(1, 0)});
        for (const Eigen::Index normal : {0, 1, 3}) scene.points.stress(normal, p) += correction[p];
      }
    const Eigen::Matrix2Xd internal =
        test::nodal_forces(test::blocks_of(*without_lambda, step), scene.basis->functions());
    CHECK((force + internal).norm() <= 1e-10 * force.norm());
  }
}

TEST_CASE("a displacement that is prescribed along an edge and met adds no slip", "[engine][dilatation]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Scene scene = projected_disc(grid);
    const test::Step step(scene);
    const Eigen::Matrix2Xd field = random_field(*scene.basis);
    Dilatation dilatation(*scene.basis, *scene.projected, scene.points, step.supports);
    const Eigen::RowVectorXd before = dilatation.correction(scene.points, step.supports, field);
    dilatation.let_slip(step.edges[0], slip_points(*scene.basis, step.edges[0]), field);
    const Eigen::RowVectorXd after = dilatation.correction(scene.points, step.supports, field);
    CHECK((after - before).norm() <= 1e-10 * before.norm());
    const Eigen::RowVectorXd slipping = dilatation.correction(scene.points, step.supports, 2.0 * field);
    CHECK((slipping - 2.0 * before).norm() > 0.1 * before.norm());
  }
}

TEST_CASE("projected dilatation: a load that is held does not move the body again", "[engine][dilatation]") {
  for (const EssentialMethod method :
       {EssentialMethod::grid, EssentialMethod::nitsche, EssentialMethod::implicit_boundary})
    for (const double poissons_ratio : {0.3, 0.4999}) {
      test::CompressionSquare square = square_of(method);
      square.load = 1e-12;
      square.held_load = true;
      square.steps = 5;
      square.poissons_ratio = poissons_ratio;
      Scene scene = projected_square(square);
      RunRecord record;
      std::vector<double> increment;
      run_load_steps(
          scene,
          {.condition_estimate = true, .after_step = [&](int) { increment.push_back(record.largest_increment); }},
          record);
      CAPTURE(static_cast<int>(method), poissons_ratio);
      const double rounding = std::numeric_limits<double>::epsilon() * record.condition_estimate.value();
      CHECK(increment.at(0) > 0.0);
      for (std::size_t k = 1; k < 5; ++k) CHECK(increment.at(k) <= std::max(1e-12, rounding) * increment[0]);
    }
}

TEST_CASE("projected dilatation: reactions balance loads, and both loadings agree", "[engine][dilatation]") {
  for (const EssentialMethod method :
       {EssentialMethod::grid, EssentialMethod::nitsche, EssentialMethod::implicit_boundary}) {
    CAPTURE(static_cast<int>(method));
    test::CompressionSquare square = square_of(method);
    square.load = 1.0;
    square.steps = 3;
    square.poissons_ratio = 0.49;
    Scene residual = projected_square(square);
    square.loading = Loading::incremental;
    Scene incremental = projected_square(square);
    RunRecord first;
    RunRecord second;
    run_load_steps(residual, {}, first);
    run_load_steps(incremental, {}, second);
    for (const RunRecord& record : {first, second}) {
      const Vec3 sum = test::imbalance(record.resultants);
      CHECK(sum.head<2>().norm() <= 1e-5 * square.load * square.side);
    }
    CHECK(test::imbalance(first.resultants).head<2>().norm() <= 1e-10 * square.load * square.side);
    CHECK((residual.points.displacement - incremental.points.displacement).norm() <=
          1e-4 * residual.points.displacement.norm());
    CHECK((residual.points.stress - incremental.points.stress).norm() <= 1e-4 * residual.points.stress.norm());
  }
}

TEST_CASE("nothing of the projection is made where no case asks for it, a step takes one factorisation",
          "[engine][dilatation]") {
  const auto effects = [](const Scene& scene) {
    std::vector<std::string> names;
    for (const auto& effect : scene.contributions) names.push_back(effect->name());
    return names;
  };
  test::CompressionSquare square = square_of(EssentialMethod::nitsche);
  square.load = 1e-3;
  square.steps = 2;
  const Scene plain = test::compression_square(square);
  CHECK_FALSE(plain.projected.has_value());
  CHECK(std::ranges::count(effects(plain), "projected_dilatation") == 0);
  Scene scene = projected_square(square);
  CHECK(std::ranges::count(effects(scene), "projected_dilatation") == 1);
  RunRecord record;
  run_load_steps(scene, {}, record);
  CHECK(record.factorisations == 2);
  CHECK(record.analyses == 1);
}

TEST_CASE("a nearly incompressible body without the projection is warned of, once", "[engine][dilatation]") {
  const auto warnings = [](double poissons_ratio, Plane plane, bool projected) {
    Case problem = test::compression_case(
        {.cells = 4, .load = 1e-3, .steps = 2, .plane = plane, .poissons_ratio = poissons_ratio});
    problem.material.projected_dilatation = projected;
    Scene scene = build_scene(problem);
    RunRecord record;
    run_load_steps(scene, {}, record);
    return record.warnings;
  };
  const std::vector<std::string> one = warnings(0.47, Plane::strain, false);
  REQUIRE(one.size() == 1);
  CHECK_THAT(one[0], Contains("0.47") && Contains("material.dilatation") && Contains("projected"));
  CHECK(warnings(0.44, Plane::strain, false).empty());
  CHECK(warnings(0.47, Plane::stress, false).empty());
  CHECK(warnings(0.47, Plane::strain, true).empty());
}

TEST_CASE("the projection does not depend on the number of threads, to the last digit", "[engine][dilatation]") {
  const int threads_before = omp_get_max_threads();
  set_blas_threads(1);
  const auto stress_with = [](int threads) {
    omp_set_num_threads(threads);
    Scene scene = projected_square({.angle = 0.3, .cells = 150, .ghost = 1e-3, .steps = 1, .poissons_ratio = 0.499});
    REQUIRE(worth_threads(static_cast<std::size_t>(scene.points.size())));
    RunRecord record;
    run_load_steps(scene, {}, record);
    return scene.points.stress;
  };
  const Eigen::Matrix4Xd one = stress_with(1);
  const Eigen::Matrix4Xd two = stress_with(2);
  omp_set_num_threads(threads_before);
  CHECK(one == two);
}
