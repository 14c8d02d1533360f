// The ghost penalty of effects.hpp.
#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "../every_grid.hpp"
#include "../scenes.hpp"
#include "dense_blocks.hpp"
#include "shoreline/bases/projection.hpp"
#include "shoreline/engine/effects.hpp"

using namespace shoreline;
using Catch::Matchers::WithinRel;

namespace {

/// A turned square with sides of 0.1 @p unit, somewhere in a grid with @p cells cells in 0.2 @p unit.
std::vector<std::pair<std::string, Scene>> scenes(Index cells, double unit = 1.0) {
  std::vector<std::pair<std::string, Scene>> all;
  for (const auto& [name, grid] : test::every_grid(Vec2(-0.11, -0.1) * unit, 0.2 * unit, cells)) {
    Case problem = test::compression_case({.angle = 0.6, .shift = Vec2(0.003, -0.002) * unit, .side = 0.1 * unit});
    problem.grid = grid;
    std::vector<Vec2> body;
    for (const Case::Boundary& side : problem.boundaries) body.push_back(side.piece.points[0]);
    problem.material_points = test::patch_points(grid, body);
    all.emplace_back(name, build_scene(problem));
  }
  return all;
}

/// The field f, in both components, nearest to it in the mean of squares.
template <class F>
Eigen::Matrix2Xd field(const Basis& basis, F&& f) {
  const WeightedPoints points = integration_points(basis.grid(), 2 * basis.degree() + 2);
  Eigen::MatrixXd value(static_cast<Eigen::Index>(points.x.size()), 2);
  for (std::size_t k = 0; k < points.x.size(); ++k)
    value.row(static_cast<Eigen::Index>(k)) << f(points.x[k]), -2.0 * f(points.x[k]);
  return project(basis, points, value, Mass::consistent).transpose();
}

/// A polynomial of degree p of the distance along a direction, 1 at 0.1 unit.
auto power(int degree, double unit = 1.0) {
  return [=](const Vec2& x) { return std::pow((0.8 * x.x() + 0.6 * x.y()) / (0.1 * unit), degree); };
}

}  // namespace

TEST_CASE("the ghost penalty does not see linear fields and resists all others", "[engine][effects]") {
  test::Random random(1);
  const Scene scene = test::turned_square();
  const test::Step step(scene);
  const ElementBlocks blocks = test::blocks_of(*ghost_penalty(1e-3, scene.material), step.state);
  REQUIRE(blocks.size() > 10);
  Mat2 gradient;
  gradient << 1.0, 2.0, -3.0, 0.5;
  const Eigen::Matrix2Xd linear = test::linear_field(*scene.basis, gradient).colwise() + Vec2(1.0, 2.0);
  const Eigen::Matrix2Xd other = random.field(scene.basis->functions());
  CHECK(test::times(blocks, linear).norm() < 1e-12 * test::times(blocks, other).norm());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Eigen::MatrixXd matrix = test::block_matrix(blocks, b);
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    CHECK(eigenvalues.minCoeff() >= -1e-13 * eigenvalues.maxCoeff());
  }
}

TEST_CASE("the ghost penalty scales with stiffness and does not depend on the unit of length", "[engine][effects]") {
  test::Random random(2);
  const Scene scene = test::turned_square();
  const Scene large = test::turned_square(12.5);
  const test::Step step(scene);
  const test::Step large_step(large);
  const auto stiffer = std::make_shared<LinearElastic>(3e6, 0.25, Plane::strain);
  const Eigen::Matrix2Xd field = random.field(scene.basis->functions());
  const auto energy = [&](double gamma, const std::shared_ptr<const Material>& material, const StepState& state) {
    return test::times(test::blocks_of(*ghost_penalty(gamma, material), state), field).cwiseProduct(field).sum();
  };
  const double reference = energy(1e-3, scene.material, step.state);
  CHECK(reference > 0.0);
  CHECK_THAT(energy(2e-3, scene.material, step.state), WithinRel(2.0 * reference, 1e-12));
  CHECK_THAT(energy(1e-3, stiffer, step.state), WithinRel(3.0 * reference, 1e-12));
  CHECK_THAT(energy(1e-3, scene.material, large_step.state), WithinRel(reference, 1e-9));
}

TEST_CASE("on every basis the ghost penalty leaves polynomials of the basis's degree free, and finds all others",
          "[engine][effects]") {
  for (const auto& [name, scene] : scenes(9)) {
    CAPTURE(name);
    const int p = scene.basis->degree();
    const test::Step step(scene);
    const ElementBlocks blocks = test::blocks_of(*ghost_penalty(1e-3, scene.material), step.state);
    REQUIRE(blocks.size() > 10);
    const auto force = [&](int degree) { return test::times(blocks, field(*scene.basis, power(degree))).norm(); };
    CHECK(force(p + 1) > 0.0);
    for (int degree = 0; degree <= p; ++degree) CHECK(force(degree) <= 1e-7 * force(p + 1));
  }
}

TEST_CASE("on every basis the ghost penalty does not depend on the unit of length", "[engine][effects]") {
  const auto small = scenes(9);
  const auto large = scenes(9, 40.0);
  for (std::size_t k = 0; k < small.size(); ++k) {
    CAPTURE(small[k].first);
    const int p = small[k].second.basis->degree();
    const auto energy = [&](const Scene& scene, double unit) {
      const test::Step step(scene);
      const Eigen::Matrix2Xd u = field(*scene.basis, power(p + 1, unit));
      return test::times(test::blocks_of(*ghost_penalty(1e-3, scene.material), step.state), u).cwiseProduct(u).sum();
    };
    CHECK_THAT(energy(large[k].second, 40.0), WithinRel(energy(small[k].second, 1.0), 1e-7));
  }
}

TEST_CASE("under refinement the ghost penalty of a smooth field falls with order 2p + 1", "[engine][effects]") {
  const auto coarse = scenes(12);
  const auto fine = scenes(24);
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    CAPTURE(coarse[k].first);
    const int p = coarse[k].second.basis->degree();
    const auto energy = [&](const Scene& scene) {  // jumps of order h on faces of length 1/h·h in a strip of width h
      const test::Step step(scene);
      const Eigen::Matrix2Xd u = field(*scene.basis, power(p + 1));
      return test::times(test::blocks_of(*ghost_penalty(1e-3, scene.material), step.state), u).cwiseProduct(u).sum();
    };
    const double order = std::log2(energy(coarse[k].second) / energy(fine[k].second));
    CHECK(std::abs(order - (2 * p + 1)) <= 0.3);
  }
}
