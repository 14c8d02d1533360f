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
