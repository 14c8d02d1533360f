// The ghost penalty of effects.hpp.
#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "../scenes.hpp"
#include "dense_blocks.hpp"
#include "shoreline/engine/effects.hpp"

using namespace shoreline;
using Catch::Matchers::WithinRel;

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
