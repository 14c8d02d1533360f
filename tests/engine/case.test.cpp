#include "shoreline/engine/case.hpp"

#include <catch2/catch.hpp>

using namespace shoreline;

TEST_CASE("a case asks for nothing by itself", "[engine][case]") {
  const Case problem;
  CHECK(problem.boundaries.empty());
  CHECK(problem.ghost == 0.0);
  CHECK_FALSE(problem.body_force);
  CHECK_FALSE(problem.gravity);
  CHECK_FALSE(problem.exact);
  CHECK(problem.probes.empty());
  CHECK(problem.respacing == 0.0);
  CHECK_FALSE(problem.condition_estimate);
  CHECK_FALSE(problem.material.density);
}

TEST_CASE("a case is plane strain in one step of residual loading unless it says otherwise", "[engine][case]") {
  const Case problem;
  CHECK(problem.plane == Plane::strain);
  CHECK(std::get<QuasiStatic>(problem.analysis).loading == Loading::residual);
  CHECK(std::get<QuasiStatic>(problem.analysis).load_steps == 1);
  CHECK(problem.threads == 0);
  CHECK(problem.output.every == 1);
  CHECK(std::holds_alternative<Case::Free>(Case::Condition{}));
  CHECK(VertexFill{}.volumes == VolumeRule::clipped);
}
