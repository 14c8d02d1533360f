// What the effects of effects.hpp that resist motion remember from step to step.
#include <catch2/catch.hpp>

#include "../scenes.hpp"
#include "dense_blocks.hpp"
#include "shoreline/engine/effects.hpp"

using namespace shoreline;

TEST_CASE("what a support and a ghost penalty have taken up they exert again", "[engine][effects]") {
  test::Random random(3);
  const Scene scene = test::disc();
  const test::Step step(scene);
  const Eigen::Matrix2Xd increment = random.field(scene.basis->functions());
  std::vector<std::unique_ptr<Contribution>> effects;
  effects.push_back(ghost_penalty(0.1, scene.material));
  for (const EssentialMethod method : {EssentialMethod::implicit_boundary, EssentialMethod::nitsche})
    for (const bool roller : {false, true})
      effects.push_back(essential_on(0, "rim", {.normal_only = roller, .method = method, .band = 0.1}, scene.material));
  for (const auto& effect : effects) {
    CAPTURE(effect->name());
    const Eigen::Matrix2Xd force = test::times(test::blocks_of(*effect, step.state), increment);
    effect->accept(step.state, increment);
    const ElementBlocks after = test::blocks_of(*effect, step.state);
    CHECK((test::nodal_forces(after, scene.basis->functions()) + force).norm() <= 1e-11 * force.norm());

    Resultants resultants;
    effect->report(resultants);
    if (!resultants.reactions.empty())
      CHECK((resultants.reactions.at("rim") + test::total(*scene.basis, force)).norm() <= 1e-11 * force.norm());
  }
}

TEST_CASE("with incremental loading supports and ghost penalty look at the increment alone", "[engine][effects]") {
  Scene scene = test::disc();
  scene.loading = Loading::incremental;
  const test::Step step(scene);
  const auto effect = essential_on(0, "rim", {}, scene.material);
  const Eigen::Matrix2Xd increment = test::linear_field(*scene.basis, Mat2::Identity()).array() + 1.0;
  effect->accept(step.state, increment);
  Resultants once;
  effect->report(once);
  const auto ghost = ghost_penalty(0.1, scene.material);
  ghost->accept(step.state, test::Random(4).field(scene.basis->functions()));
  for (const auto* each : {effect.get(), ghost.get()})
    CHECK(test::nodal_forces(test::blocks_of(*each, step.state), scene.basis->functions()).isZero(0.0));
  effect->accept(step.state, increment);
  Resultants twice;
  effect->report(twice);
  CHECK((twice.reactions.at("rim") - 2.0 * once.reactions.at("rim")).norm() < 1e-12 * once.reactions.at("rim").norm());
}

TEST_CASE("a support that moves as prescribed exerts the traction of that motion", "[engine][effects]") {
  const Scene scene = test::disc();
  test::Step step(scene);
  const Mat2 gradient = (Mat2() << 0.3, -0.2, 0.5, 0.1).finished();
  step.prescribed = test::linear_field(*scene.basis, gradient);
  const Mat3 tangent = scene.material->tangent(Stress::Zero());
  const Vec3 strain(gradient(0, 0), gradient(1, 1), gradient(0, 1) + gradient(1, 0));
  const Vec3 s = tangent * strain;
  const Mat2 stress = (Mat2() << s[0], s[2], s[2], s[1]).finished();
  for (const EssentialMethod method : {EssentialMethod::implicit_boundary, EssentialMethod::nitsche}) {
    const auto effect = essential_on(0, "rim", {.method = method, .band = 0.1}, scene.material);
    const ElementBlocks blocks = test::blocks_of(*effect, step.state);
    // equations met by the prescribed motion itself: K d_a − f = ∫ Mᵀ σ(d_a) n dS
    const Eigen::Matrix2Xd left =
        test::times(blocks, step.prescribed) - test::nodal_forces(blocks, scene.basis->functions());
    Eigen::Matrix2Xd expected = Eigen::Matrix2Xd::Zero(2, scene.basis->functions());
    const std::vector<BoundaryPoint> points = boundary_points(step.edges[0].curve, step.edges[0].segments, gauss(2));
    for (std::size_t k = 0; k < points.size(); ++k) {
      const BoundaryPoint& p = points[k];
      const Support support = scene.basis->support(step.edges[0].support_cell[k / 2], p.x);
      for (Eigen::Index a = 0; a < support.value.size(); ++a)
        expected.col(support.function[a]) += p.weight * support.value[a] * (stress * p.normal);
    }
    CHECK((left - expected).norm() <= 1e-10 * expected.norm());

    effect->accept(step.state, step.prescribed);
    Resultants resultants;
    effect->report(resultants);
    CHECK(resultants.reactions.at("rim").head<2>().norm() <= 1e-9 * stress.norm());  // ∮ σ n dS = 0
    CHECK((resultants.reactions.at("rim") + test::total(*scene.basis, expected)).norm() <= 1e-9 * stress.norm());
  }
}

TEST_CASE("the error of a piece is its displacement's distance from the exact one", "[engine][effects]") {
  const Scene scene = test::disc();
  const test::Step step(scene);
  const Vec2 offset(3e-3, -4e-3);
  const Eigen::Matrix2Xd uniform = offset.replicate(1, scene.basis->functions());
  const auto rest = [](const BoundaryPoint&, double) -> Vec2 { return Vec2::Zero(); };
  double length = 0.0;
  for (const BoundaryPoint& p : step.edges[0].points) length += p.weight;
  const auto error_after = [&](Contribution& effect) {
    effect.accept(step.state, uniform);
    Resultants resultants;
    effect.report(resultants);
    return resultants.displacement_errors.at("rim");
  };
  const auto fixed = boundary_error(0, "rim", false, rest);
  CHECK(error_after(*fixed) == Approx(5e-3 * std::sqrt(length)).epsilon(1e-12));
  CHECK(error_after(*fixed) == Approx(1e-2 * std::sqrt(length)).epsilon(1e-12));  // it adds up over the steps
  const auto roller = boundary_error(0, "rim", true, rest);
  CHECK(error_after(*roller) == Approx(5e-3 * std::sqrt(0.5 * length)).epsilon(1e-3));  // mean of (n·e)² on a circle
  const auto moved = boundary_error(0, "rim", false, [&](const BoundaryPoint&, double) { return offset; });
  CHECK(error_after(*moved) <= 1e-15);
}
