// The estimated error of the stress over the true one: on every basis, from h = 1/16 on.

#include <catch2/catch.hpp>
#include <cmath>

#include "../example_run.hpp"
#include "../plate_on_basis.hpp"

using namespace shoreline;

namespace {

struct Estimated {
  double stress;    ///< absolute L2 error
  double estimate;  ///< of it
  [[nodiscard]] double effectivity() const { return estimate / stress; }
};

Estimated compute(Case problem) {
  const int degree = problem.grid.basis == Case::BasisType::bspline ? problem.grid.degree : 1;
  problem.material_points = LatticeFill{{degree + 1, degree + 1}, VolumeRule::fitted};
  problem.fitted = true;
  Scene scene = build_scene(problem);
  RunRecord record;
  run_load_steps(scene, {.error_estimate = true}, record);
  return {error_norms(scene.points, *scene.exact, 1.0).stress_l2, record.error_estimate.value().stress_l2};
}

/// The plate under tractions, all supports by Nitsche's method.
Estimated plate(const Case::Grid& grid, int cells) {
  return compute(test::plate_on("plate_with_hole/neumann.json", grid, 1.0 / cells, 10.0));
}

/// An example on another grid.
Estimated example(const std::string& file, const Case::Grid& grid, int cells, double ghost) {
  Case problem = read_case(std::string(SHORELINE_EXAMPLES) + "/" + file, {});
  problem.grid.basis = grid.basis;
  problem.grid.degree = grid.degree;
  problem.grid.pattern = grid.pattern;
  problem.grid.cell_size = Vec2::Constant(1.0 / cells);
  problem.ghost = ghost;
  return compute(problem);
}

Estimated square(const Case::Grid& grid, int cells) { return example("smooth_square/square.json", grid, cells, 0.0); }

struct Discretisation {
  const char* name;
  Case::BasisType basis;
  int degree;  ///< order of the stress
  TrianglePattern pattern = TrianglePattern::diagonal;
};

constexpr Discretisation all[] = {
    {"bilinear", Case::BasisType::bilinear, 1},
    {"linear, diagonal", Case::BasisType::linear, 1},
    {"linear, four", Case::BasisType::linear, 1, TrianglePattern::four},
    {"Powell-Sabin, diagonal", Case::BasisType::powell_sabin, 2},
    {"Powell-Sabin, four", Case::BasisType::powell_sabin, 2, TrianglePattern::four},
    {"B-splines of degree 2", Case::BasisType::bspline, 2},
    {"B-splines of degree 3", Case::BasisType::bspline, 3},
};

Case::Grid grid_of(const Discretisation& d) {
  Case::Grid grid;
  grid.basis = d.basis;
  grid.degree = d.degree;
  grid.pattern = d.pattern;
  return grid;
}

}  // namespace

TEST_CASE("the estimate is the error of the stress within 0.7 and 1.4, and falls with its order",
          "[verification][estimate]") {
  for (const auto& solve : {&plate, &square})
    for (const Discretisation& d : all) {
      CAPTURE(d.name, solve == &plate ? "plate" : "square");
      const Estimated middle = solve(grid_of(d), 16);
      const Estimated fine = solve(grid_of(d), 32);
      for (const Estimated& e : {middle, fine}) {
        CHECK(e.effectivity() >= 0.7);
        CHECK(e.effectivity() <= 1.4);
      }
      CHECK(std::log2(middle.estimate / fine.estimate) >= d.degree - 0.3);
    }
}

TEST_CASE("a cylinder whose inner radius doubles in one step carries its stress far, but not into the estimate",
          "[verification][estimate]") {
  for (const Discretisation& d : all) {
    CAPTURE(d.name);
    const Estimated found =
        example("thick_cylinder/implicit.json", grid_of(d), 4, ghost_for_nitsche(d.basis, d.degree));
    CHECK(found.effectivity() >= 0.7);
    CHECK(found.effectivity() <= 1.4);
  }
}
