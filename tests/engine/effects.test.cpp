#include "shoreline/engine/effects.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "../scenes.hpp"
#include "dense_blocks.hpp"
#include "shoreline/boundary/essential.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

namespace {

double length_of(const Edge& edge) {
  double length = 0.0;
  for (const BoundaryPoint& p : edge.points) length += p.weight;
  return length;
}

std::unique_ptr<Contribution> constant_traction(int piece, const Vec2& value) {
  return traction_on(piece, "piece", {[value](const BoundaryPoint&, double) { return value; }});
}

}  // namespace

TEST_CASE("the stiffness of a cell is positive semidefinite and resists no rigid motion", "[engine][effects]") {
  const Scene scene = test::turned_square();
  const test::Step step(scene);
  const ElementBlocks blocks = test::blocks_of(*stiffness_of(scene.material), step.state);
  Mat2 rotation;
  rotation << 0.0, -1.0, 1.0, 0.0;
  const Eigen::Matrix2Xd turn = test::linear_field(*scene.basis, rotation);
  const Eigen::Matrix2Xd shift = Eigen::Matrix2Xd::Ones(2, scene.basis->functions());
  CHECK(static_cast<Index>(blocks.size()) == step.state.supports.cells());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Eigen::MatrixXd matrix = test::block_matrix(blocks, b);
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    CHECK(eigenvalues.minCoeff() >= -1e-14 * eigenvalues.maxCoeff());
    CHECK(blocks.times(b, shift).norm() <= 1e-14 * matrix.norm());
    CHECK(blocks.times(b, turn).norm() <= 1e-14 * matrix.norm());
  }
}

TEST_CASE("the internal force of a uniform stress is that of its traction on the boundary", "[engine][effects]") {
  Scene scene = test::turned_square();
  Mat2 stress;
  stress << 3.0, -1.0, -1.0, 2.0;
  scene.points.stress.colwise() = Stress(3.0, 2.0, -1.0, 7.0);
  const test::Step step(scene);
  ElementBlocks blocks = test::blocks_of(*stiffness_of(scene.material), step.state);
  for (int piece = 0; piece < 4; ++piece)
    traction_on(piece, "side", {[stress](const BoundaryPoint& p, double) -> Vec2 { return stress * -p.normal; }})
        ->add(step.state, blocks);
  const Eigen::Matrix2Xd force = test::nodal_forces(blocks, scene.basis->functions());
  CHECK_THAT(force.cwiseAbs().maxCoeff(), WithinAbs(0.0, 1e-15));  // single terms are about 0.05

  scene.loading = Loading::incremental;  // which does not look back
  const test::Step incremental(scene);
  CHECK(test::nodal_forces(test::blocks_of(*stiffness_of(scene.material), incremental.state), scene.basis->functions())
            .isZero(0.0));
}

TEST_CASE("a body force has the body's resultant and moment", "[engine][effects]") {
  const Scene scene = test::turned_square();
  const test::Step step(scene);
  const Vec2 weight(2.0, -30.0);
  const auto effect = body_force([=](const PlaceTime& at) -> Vec2 { return at.t * weight; });
  const Vec3 sum =
      test::total(*scene.basis, test::nodal_forces(test::blocks_of(*effect, step.state), scene.basis->functions()));
  const Vec2 centre(0.003, -0.002);
  CHECK_THAT((sum - resultant(centre, 0.01 * weight)).norm(), WithinAbs(0.0, 1e-14));

  effect->accept(step.state, {});
  Resultants resultants;
  effect->report(resultants);
  CHECK_THAT((resultants.loads.at("body_force") - sum).norm(), WithinAbs(0.0, 1e-14));
}

TEST_CASE("a uniform traction on a curved piece has resultant t times length and its moment", "[engine][effects]") {
  const Scene scene = test::disc();
  const test::Step step(scene);
  const Vec2 t(3.0, -5.0);
  const Edge& rim = step.state.edges[0];
  const auto effect = constant_traction(0, t);
  const Vec3 sum =
      test::total(*scene.basis, test::nodal_forces(test::blocks_of(*effect, step.state), scene.basis->functions()));
  Vec3 expected = Vec3::Zero();
  for (const BoundaryPoint& p : rim.points) expected += resultant(p.x, p.weight * t);
  CHECK_THAT((sum.head<2>() - length_of(rim) * t).norm(), WithinAbs(0.0, 1e-12));
  CHECK_THAT((sum - expected).norm(), WithinAbs(0.0, 1e-12));

  effect->accept(step.state, {});
  Resultants resultants;
  effect->report(resultants);
  CHECK_THAT((resultants.loads.at("piece") - expected).norm(), WithinAbs(0.0, 1e-12));
}

TEST_CASE("a pressure around a closed curve has no resultant and no moment", "[engine][effects]") {
  const Scene scene = test::disc();
  const test::Step step(scene);
  const auto effect = pressure_on(0, "rim", {[](const BoundaryPoint&, double t) { return 7.0 * t; }});
  const Eigen::Matrix2Xd force = test::nodal_forces(test::blocks_of(*effect, step.state), scene.basis->functions());
  CHECK(force.norm() > 1.0);
  CHECK_THAT(test::total(*scene.basis, force).norm(), WithinAbs(0.0, 1e-12));
  for (Index f = 0; f < scene.basis->functions(); ++f)  // it pushes inward
    CHECK(force.col(f).dot(scene.basis->control_point(f)) <= 1e-12);
}

TEST_CASE("incremental loading adds what the load gains in the step", "[engine][effects]") {
  Scene scene = test::disc();
  scene.loading = Loading::incremental;
  const test::Step step(scene, 0.75, 0.5);
  const auto effect = pressure_on(0, "rim", {[](const BoundaryPoint&, double t) { return t; }});
  scene.loading = Loading::residual;
  const test::Step whole(scene, 0.25);
  const Index n = scene.basis->functions();
  CHECK((test::nodal_forces(test::blocks_of(*effect, step.state), n) -
         test::nodal_forces(test::blocks_of(*effect, whole.state), n))
            .norm() < 1e-14);
}
