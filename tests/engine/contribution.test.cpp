#include "shoreline/engine/contribution.hpp"

#include <catch2/catch.hpp>

#include "../scenes.hpp"

using namespace shoreline;

namespace {

/// A bed of springs of one's own: an effect needs a name and its blocks, nothing else.
class Ground final : public Contribution {
 public:
  [[nodiscard]] std::string name() const override { return "ground"; }
  [[nodiscard]] std::string needs() const override { return "values on the edge"; }
  void add(const StepState& step, ElementBlocks& blocks) const override {
    for (const Index cell : step.supports.cell)
      blocks.add(blocks.append(step.basis.functions_of(cell)), 1e3 * Eigen::Matrix<double, 8, 8>::Identity());
  }
};

}  // namespace

TEST_CASE("a resultant is the force and its moment about the origin, counter-clockwise", "[engine][contribution]") {
  CHECK(resultant(Vec2(2.0, 0.0), Vec2(0.0, 3.0)) == Vec3(0.0, 3.0, 6.0));
  CHECK(resultant(Vec2(0.0, 2.0), Vec2(3.0, 0.0)) == Vec3(3.0, 0.0, -6.0));
  CHECK(resultant(Vec2(5.0, 7.0), Vec2(5.0, 7.0))[2] == 0.0);
}

TEST_CASE("a load counts whole with residual loading, and what it gains with incremental", "[engine][contribution]") {
  Scene scene = test::compression_square({.cells = 2});
  const auto ramp = [](double t) -> Vec2 { return Vec2(10.0, -20.0) * t; };
  CHECK(test::Step(scene, 0.75, 0.5).state.load(ramp) == Vec2(7.5, -15.0));
  scene.loading = Loading::incremental;
  CHECK(test::Step(scene, 0.75, 0.5).state.load(ramp) == Vec2(2.5, -5.0));
}

TEST_CASE("an effect of one's own takes part in a run", "[engine][contribution]") {
  Case free_body = test::compression_case({.cells = 4});
  for (Case::Boundary& b : free_body.boundaries)
    if (std::holds_alternative<Essential>(b.condition)) b.condition = Case::Free{};
  Scene held_by_ground = build_scene(free_body);
  held_by_ground.contributions.push_back(std::make_unique<Ground>());
  RunRecord record;
  REQUIRE_NOTHROW(run_load_steps(held_by_ground, {}, record));
  CHECK(record.effects.entries().back().name == "ground");
  CHECK(record.resultants.reactions.empty());  // it reports none
  CHECK(record.resultants.loads.count("top") == 1);
}
