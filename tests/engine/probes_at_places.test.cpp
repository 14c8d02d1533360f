// Probes at their very places: the same material, whatever the points are.

#include <catch2/catch.hpp>

#include "../patch_square.hpp"
#include "../plate_on_basis.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::run;

namespace {

long calls(const RunRecord& record, const std::string& phase) {
  long sum = 0;
  for (const Clock::Entry& entry : record.phases.entries()) sum += entry.name == phase ? entry.calls : 0;
  return sum;
}

Case turned_case(int steps) {
  return test::compression_case(
      {.angle = 0.3, .cells = 5, .method = EssentialMethod::nitsche, .ghost = 1e-3, .load = 1.0, .steps = steps});
}

/// The plate with a hole under tractions, with points of fitted weights, and the same probes at places or nearest.
Scene plate(int degree, int per_cell, bool at_place) {
  Case::Grid grid;
  grid.basis = Case::BasisType::bspline;
  grid.degree = degree;
  Case problem = test::plate_on("plate_with_hole/neumann.json", grid, 0.125, 10.0);
  problem.material_points = LatticeFill{{per_cell, per_cell}, VolumeRule::fitted};
  problem.fitted = true;
  problem.probes = {{"inside", Vec2(0.83, 0.71), at_place},
                    {"on the hole", 0.5 * Vec2(std::cos(0.8), std::sin(0.8)), at_place},
                    {"corner", Vec2(1.5, 0.0), at_place}};
  return build_scene(problem);
}

}  // namespace

TEST_CASE("patch test: a probe at a place inside, on an edge or in a corner is exact on every basis",
          "[engine][probes]") {
  for (const auto& [name, grid] : test::every_grid(Vec2(-1.0, -1.0), 2.0, 9))
    for (const Loading loading : {Loading::residual, Loading::incremental})
      for (const bool projected : {false, true}) {
        CAPTURE(name, loading, projected);
        test::PatchSquare patch = test::patch_square(grid, 3, loading, projected);
        const Vec2 corner = patch.problem.boundaries[2].piece.points.front();
        const Vec2 on_top = 0.3 * corner + 0.7 * patch.problem.boundaries[2].piece.points.back();
        patch.problem.probes = {{"corner", corner, true}, {"inside", Vec2(0.017, -0.243), true}, {"top", on_top, true}};
        Scene scene = build_scene(patch.problem);
        run(scene);
        const Vec2 largest = patch.exact.displacement(corner, 1.0);
        const Vec3 stress = patch.exact.stress(corner, 1.0);
        for (std::size_t k = 0; k < 3; ++k) {
          const Probe& probe = scene.probes[k];
          const Vec2 place = patch.problem.probes[k].position;
          REQUIRE(probe.history.size() == 4);
          CHECK(probe.history.front().position == place);
          for (const ProbeState& state : probe.history) {
            CHECK((state.displacement - patch.exact.displacement(place, state.t)).norm() <= 1e-11 * largest.norm());
            CHECK((state.stress.value().head<3>() - state.t * stress).norm() <= 1e-10 * stress.norm());
          }
        }
      }
}

TEST_CASE("probes at places change nothing of a run, and without them nothing is built, located or timed",
          "[engine][probes]") {
  Case problem = test::compression_case(
      {.angle = 0.3, .shift = Vec2(0.002, 0.001), .per_cell = 2, .ghost = 1e-3, .load = 5e4, .steps = 3});
  Clock clock;
  Scene without = build_scene(problem, clock);
  CHECK(clock.entries().size() == 1);
  problem.probes = {{"near", Vec2(0.01, 0.02)}};
  Scene nearest = build_scene(problem);
  problem.probes.push_back({"there", Vec2(0.01, 0.02), true});
  Scene with = build_scene(problem, clock);
  REQUIRE(clock.entries().size() == 2);
  CHECK(clock.entries()[1].name == "probes");
  const RunRecord plain = run(without);
  const RunRecord near = run(nearest);
  const RunRecord measured = run(with);
  CHECK(without.points.position == with.points.position);
  CHECK(without.points.stress == with.points.stress);
  CHECK(plain.resultants.reactions == measured.resultants.reactions);
  CHECK(plain.resultants.loads == measured.resultants.loads);
  CHECK(nearest.probes[0].history.back().displacement == with.probes[0].history.back().displacement);
  CHECK_FALSE(without.places);
  CHECK_FALSE(nearest.places);
  CHECK(calls(plain, "probes") == 0);
  CHECK(calls(near, "probes") == 0);
  CHECK(calls(measured, "probes") == 2 * 3);  // located and moved in three steps
}

TEST_CASE("points that integrate alike give the same displacement and stress at a place, not at the nearest point",
          "[engine][probes]") {
  const auto differences = [](int degree, int few, int many, bool at_place) {
    Scene coarse = plate(degree, few, at_place);
    Scene fine = plate(degree, many, at_place);
    run(coarse);
    run(fine);
    std::vector<double> found;
    for (std::size_t k = 0; k < coarse.probes.size(); ++k) {
      const ProbeState& a = coarse.probes[k].history.back();
      const ProbeState& b = fine.probes[k].history.back();
      found.push_back((a.displacement - b.displacement).norm() / b.displacement.norm());
      if (at_place) found.push_back((*a.stress - *b.stress).norm() / b.stress->norm());
    }
    return found;
  };
  CHECK(differences(1, 2, 5, false)[0] >= 1e-3);
  for (const double there : differences(1, 2, 5, true))
    CHECK(there <= 1e-11);                                // weights integrate the stiffness exactly
  const double nearest = differences(2, 3, 8, false)[0];  // here, all but the highest mixed monomials
  CHECK(nearest >= 1e-2);
  for (const double there : differences(2, 3, 8, true)) CHECK(there <= 0.02 * nearest);
}

TEST_CASE("a place outside the body is refused, and one on its outline is not", "[engine][probes]") {
  Case problem = turned_case(1);
  problem.probes = {{"far", Vec2(0.08, 0.0)}, {"edge", problem.boundaries[0].piece.points.front(), true}};
  CHECK_NOTHROW(build_scene(problem));
  problem.probes.push_back({"off", Vec2(-0.08, 0.04), true});
  CHECK_THROWS_AS(build_scene(problem), CaseError);
  CHECK_THROWS_WITH(build_scene(problem), Contains("square.json: /probes/2/position: found (-0.08, 0.04), outside the "
                                                   "outline") &&
                                              Contains("expected a place in the body or on its outline"));
}

TEST_CASE("re-spaced tracking points do not move a probe at its place", "[engine][probes]") {
  Case problem = turned_case(4);
  const Vec2 corner = problem.boundaries[2].piece.points.front();
  problem.probes = {{"corner", corner, true}};
  problem.respacing = 3.0;
  Scene scene = build_scene(problem);
  run(scene);
  const ExactSolution exact = *test::compression_square({.angle = 0.3, .cells = 5, .load = 1.0}).exact;
  const Vec2 displacement = exact.displacement(corner, 1.0);
  CHECK((scene.probes[0].history.back().displacement - displacement).norm() <= 1e-5 * displacement.norm());
}

TEST_CASE("a place that leaves the grid ends the run with the name of its probe", "[engine][probes]") {
  Case problem = turned_case(2);
  problem.probes = {{"near", Vec2::Zero()}, {"tip", Vec2::Zero(), true}, {"toe", Vec2(0.01, 0.0), true}};
  Scene scene = build_scene(problem);
  scene.places.value().position.col(1) = Vec2(9.0, 0.5);
  CHECK_THROWS_WITH(run(scene), Contains("load step 1: probe \"toe\" at (9, 0.5)") && Contains("enlarge the grid"));
}
