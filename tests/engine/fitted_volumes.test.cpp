// Weights fitted at every load step.
#include <catch2/catch.hpp>

#include "../every_grid.hpp"
#include "../scenes.hpp"
#include "shoreline/boundary/fitted_weights.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/engine/defaults.hpp"

using namespace shoreline;
using Catch::Matchers::WithinRel;

namespace {

double area_of(const Scene& scene) {
  std::vector<SplineCurve> curves;
  for (const BoundaryPiece& b : scene.boundary) curves.push_back(fit_spline(b.piece));
  return Region(curves).area();
}

/// A turned square that loses a fifth of its height in four steps.
Case squeezed(Case::BasisType basis, int degree) {
  Case problem = test::compression_case({.angle = 0.3, .cells = 6, .band = 0.01, .load = 2e5, .steps = 4});
  problem.grid.basis = basis;
  problem.grid.degree = degree;
  problem.ghost = ghost_for_nitsche(basis, degree);
  problem.material_points = LatticeFill{{degree + 1, degree + 1}, VolumeRule::fitted};
  problem.fitted = true;
  for (Case::Boundary& side : problem.boundaries)
    if (auto* support = std::get_if<Essential>(&side.condition)) support->method = EssentialMethod::nitsche;
  return problem;
}

}  // namespace

TEST_CASE("as a body moves, fitted weights sum to the area of its outline, and none becomes small or negative",
          "[engine][fitted_volumes]") {
  using Type = Case::BasisType;
  constexpr double least = least_weight;  // of the fit of cells, and again of that of all points
  for (const auto& [basis, degree] :
       {std::pair(Type::bilinear, 1), std::pair(Type::linear, 1), std::pair(Type::powell_sabin, 2),
        std::pair(Type::bspline, 2), std::pair(Type::bspline, 3)}) {
    Scene scene = build_scene(squeezed(basis, degree));
    const Eigen::VectorXd start = scene.points.volume;
    double before = area_of(scene);
    const double first = before;
    RunRecord record;
    const auto after_step = [&](int step) {
      CAPTURE(static_cast<int>(basis), degree, step);
      CHECK_THAT(scene.points.volume.sum(), WithinRel(before, 1e-12));
      CHECK((scene.points.volume.array() >= 0.9 * least * least * start.array() * before / first).all());
      before = area_of(scene);
    };
    run_load_steps(scene, {.after_step = after_step}, record);
    CAPTURE(static_cast<int>(basis), degree);
    CHECK(before < 0.9 * first);
    CHECK(record.weights.value().unserved < 0.02);
  }
}

TEST_CASE("on a body that has not moved, points of the fitted fill need no system of their own",
          "[engine][fitted_volumes]") {
  Case problem = squeezed(Case::BasisType::bspline, 2);
  problem.analysis = QuasiStatic{};
  Scene scene = build_scene(problem);
  RunRecord record;
  run_load_steps(scene, {}, record);
  CHECK(record.weights.value().cells_unmet == 0);
  CHECK(record.weights.value().factorisations == 0);
  CHECK(record.factorisations == 1);
}

TEST_CASE("a case that does not name fitted weights does nothing for them", "[engine][fitted_volumes]") {
  Scene scene = test::turned_square();
  RunRecord record;
  run_load_steps(scene, {}, record);
  CHECK_FALSE(record.weights.has_value());
  for (const Clock::Entry& phase : record.phases.entries()) CHECK(phase.name != "weights");
}
