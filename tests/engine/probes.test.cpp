#include "shoreline/engine/probes.hpp"

#include <catch2/catch.hpp>

#include "../random.hpp"
#include "../scenes.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

/// A turned square under a load so small that the strain's square is nothing, and its exact solution.
Case turned_case(int steps = 1) {
  return test::compression_case(
      {.angle = 0.3, .cells = 5, .method = EssentialMethod::nitsche, .ghost = 1e-3, .load = 1.0, .steps = steps});
}

Vec2 place(const Probe& probe) { return probe.history.front().position; }

}  // namespace

TEST_CASE("no point of the body is nearer than a probe's, and tracking points carry no stress", "[engine][probes]") {
  test::Random random(1);
  Case problem = turned_case();
  for (int k = 0; k < 50; ++k) problem.probes.push_back({"p" + std::to_string(k), 0.1 * random.vector()});
  const Scene scene = build_scene(problem);
  REQUIRE(scene.probes.size() == 50);
  int tracked = 0;
  for (std::size_t k = 0; k < 50; ++k) {
    const Probe& probe = scene.probes[k];
    CHECK(probe.name == problem.probes[k].name);
    const double distance = (place(probe) - problem.probes[k].position).norm();
    for (Index p = 0; p < scene.points.size(); ++p)
      CHECK((scene.points.position.col(p) - problem.probes[k].position).norm() >= distance);
    for (const BoundaryPiece& b : scene.boundary)
      for (const Vec2& x : b.piece.points) CHECK((x - problem.probes[k].position).norm() >= distance - 1e-10);
    const Vec2 expected = probe.piece ? scene.boundary[*probe.piece].piece.points[probe.point]
                                      : Vec2(scene.points.position.col(static_cast<Index>(probe.point)));
    CHECK(place(probe) == expected);
    CHECK(probe.history.front().stress.has_value() != probe.piece.has_value());
    tracked += probe.piece ? 1 : 0;
  }
  CHECK(tracked > 0);
  CHECK(tracked < 50);
}

TEST_CASE("where a material point lies on a tracking point, the probe is on the material point", "[engine][probes]") {
  Case problem = test::compression_case({.cells = 4});
  problem.material_points = VertexFill{{2, 2}};
  problem.probes = {{"corner", Vec2(0.08, -0.08)}};
  const Scene scene = build_scene(problem);
  CHECK_FALSE(scene.probes[0].piece);
  CHECK_THAT((place(scene.probes[0]) - Vec2(0.05, -0.05)).norm(), WithinAbs(0.0, 1e-15));
}

TEST_CASE("a probe's history is the exact motion of the material that it was placed on", "[engine][probes]") {
  Case problem = turned_case(4);
  const test::CompressionSquare square{.angle = 0.3, .cells = 5, .load = 1.0};
  problem.probes = {{"inside", Vec2(0.011, 0.024)}, {"corner", Vec2(-0.08, 0.04)}};
  Scene scene = build_scene(problem);
  const ExactSolution exact = *test::compression_square(square).exact;
  RunRecord record;
  run_load_steps(scene, {}, record);
  REQUIRE_FALSE(scene.probes[0].piece);
  REQUIRE(scene.probes[1].piece);
  for (const Probe& probe : scene.probes) {
    REQUIRE(probe.history.size() == 5);
    for (std::size_t k = 0; k < 5; ++k) {
      const ProbeState& state = probe.history[k];
      CHECK(state.t == static_cast<double>(k) / 4.0);
      CHECK_THAT((state.displacement - exact.displacement(place(probe), state.t)).norm(), WithinAbs(0.0, 1e-12));
      CHECK_THAT((state.position - place(probe) - state.displacement).norm(), WithinAbs(0.0, 1e-16));
      if (state.stress)
        CHECK_THAT((state.stress->head<3>() - exact.stress(place(probe), state.t)).norm(), WithinAbs(0.0, 1e-5));
    }
  }
  CHECK(scene.probes[1].history.back().displacement.norm() > 5e-8);  // of 0.1 m at a strain of 8e-7
}

TEST_CASE("a case without probes has none", "[engine][probes]") { CHECK(build_scene(turned_case()).probes.empty()); }

TEST_CASE("a probe on a tracking point that may be re-spaced is refused", "[engine][probes]") {
  Case problem = turned_case();
  problem.probes = {{"inside", Vec2::Zero()}};
  problem.respacing = 3.0;
  CHECK_NOTHROW(build_scene(problem));
  problem.probes.push_back({"corner", Vec2(-0.08, 0.04)});
  CHECK_THROWS_AS(build_scene(problem), CaseError);
  CHECK_THROWS_WITH(build_scene(problem), Contains("square.json: /probes/1/position: ") &&
                                              Contains("tracking point 1 of piece \"top\"") && Contains("respace"));
}
