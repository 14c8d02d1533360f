// Near ν = ½ on every basis: with the projected dilatation pressures are as accurate as those of a compressible body.
#include <catch2/catch.hpp>
#include <cmath>

#include "../nearly_incompressible.hpp"
#include "../plate_on_basis.hpp"

using namespace shoreline;

namespace {

constexpr double nearly = 0.4999;

const std::vector<test::Held> methods = {
    {EssentialMethod::grid, 0.0}, {EssentialMethod::nitsche, 0.0}, {EssentialMethod::implicit_boundary, 1e-3}};

/// L2 errors of one run.
struct Errors {
  double displacement;  ///< relative
  double pressure;      ///< [Pa m]
};

Errors solve(const Case& problem) {
  Scene scene = build_scene(problem);
  RunRecord record;
  run_load_steps(scene, {}, record);
  return {error_norms(scene.points, *scene.exact, 1.0).displacement_l2_relative.value(),
          test::pressure_error(scene, problem.material.poissons_ratio)};
}

Errors manufactured(const Case::Grid& grid, const test::Held& held, double poissons_ratio, bool projected) {
  return solve(
      test::on_grid(parse_case(test::manufactured_text(poissons_ratio), "square.json", {}), grid, held, projected));
}

/// Linear triangles lock at a narrow band without its consistent part whatever ν is: their edge follows no smooth
/// displacement.
bool locks_at_band(const test::Held& held, const Case::Grid& grid) {
  return held.method == EssentialMethod::implicit_boundary && grid.basis == Case::BasisType::linear;
}

/// A quarter of a thick cylinder on another grid: rollers, and the exact displacement on the curved outer edge.
Case cylinder(const Case::Grid& under, const test::Held& held, double poissons_ratio, bool projected) {
  Case problem = read_case(std::string(SHORELINE_EXAMPLES) + "/thick_cylinder/implicit.json",
                           {"boundaries.3.condition.value=1", "exact.pressure=1",
                            "material.poissons_ratio=" + std::to_string(poissons_ratio)});
  const Essential support{.method = held.method,
                          .band = held.band > 0.0 ? held.band : nitsche_band(under.basis),
                          .narrows = held.band == 0.0};
  for (Case::Boundary& side : problem.boundaries)
    if (auto* roller = std::get_if<Essential>(&side.condition)) {
      *roller = support;
      roller->normal_only = true;
    }
  problem.boundaries[1].condition = Case::Displacement{Case::FromExact{}, support};
  problem.grid = under;
  problem.ghost = ghost_for_nitsche(under.basis, under.degree);
  problem.material.projected_dilatation = projected;
  const int order = under.basis == Case::BasisType::bspline ? 2 * under.degree : 2;
  problem.material_points = test::polygon_points(test::basis_of(under)->grid(), test::outline(problem, 0.05), order);
  return problem;
}

}  // namespace

TEST_CASE("square: the pressure's error at ν = 0.4999 is at most twice that at 0.3, on every basis and support",
          "[stability][incompressible]") {
  for (const test::Held& held : methods)
    for (const auto& [name, grid] : test::grids_under_square(held.method, 12)) {
      CAPTURE(name, static_cast<int>(held.method));
      const Errors compressible = manufactured(grid, held, 0.3, true);
      const Errors projected = manufactured(grid, held, nearly, true);
      const Errors reference = locks_at_band(held, grid) ? manufactured(grid, held, 0.3, false) : compressible;
      CHECK(projected.pressure <= 2.0 * reference.pressure);
      CHECK(projected.displacement <= 1.5 * compressible.displacement);
    }
}

TEST_CASE("square: without a projection the pressure at ν = 0.4999 is lost", "[stability][incompressible]") {
  for (const test::Held& held : methods)
    for (const auto& [name, grid] : test::grids_under_square(held.method, 12)) {
      CAPTURE(name, static_cast<int>(held.method));
      const double plain = manufactured(grid, held, nearly, false).pressure;
      const double projected = manufactured(grid, held, nearly, true).pressure;
      // crossed triangles do not lock where no boundary cuts them
      const bool crossed = name == "linear, four" && held.method == EssentialMethod::grid;
      CHECK(plain >= (crossed ? 1.0 : 50.0) * projected);
    }
}

TEST_CASE("square: the projection keeps the orders of displacement and pressure", "[stability][incompressible]") {
  for (const test::Held& held : {methods[0], methods[1]}) {
    const auto coarse_grids = test::grids_under_square(held.method, 12);
    const auto fine_grids = test::grids_under_square(held.method, 24);
    for (std::size_t k = 0; k < coarse_grids.size(); ++k)
      for (const double poissons_ratio : {0.3, nearly}) {
        const auto& [name, grid] = coarse_grids[k];
        CAPTURE(name, poissons_ratio, static_cast<int>(held.method));
        const Errors coarse = manufactured(grid, held, poissons_ratio, true);
        const Errors fine = manufactured(fine_grids[k].grid, held, poissons_ratio, true);
        const int p = test::basis_of(grid)->degree();
        CHECK(std::log2(coarse.displacement / fine.displacement) >= p + 0.7);
        CHECK(std::log2(coarse.pressure / fine.pressure) >= p - 0.1);
        const std::array<Errors, 3> bound{{{1.4e-2, 1.8e-7}, {1.5e-4, 5e-9}, {3e-5, 1.2e-9}}};
        CHECK(fine.displacement <= bound.at(static_cast<std::size_t>(p) - 1).displacement);
        CHECK(fine.pressure <= bound.at(static_cast<std::size_t>(p) - 1).pressure);
      }
  }
}

TEST_CASE("thick cylinder: on a curved edge, too, the pressure at ν = 0.4999 is as good as at 0.3",
          "[stability][incompressible]") {
  for (const test::Held& held : {methods[1], methods[2]})
    for (const auto& [name, grid] : test::every_grid(Vec2(-0.2, -0.1), 5.6, 28)) {
      CAPTURE(name, static_cast<int>(held.method));
      const double plain = solve(cylinder(grid, held, 0.3, false)).pressure;
      CHECK(solve(cylinder(grid, held, nearly, true)).pressure <= 2.0 * plain);
    }
}

TEST_CASE("thick cylinder: without a projection the pressure at ν = 0.4999 is lost", "[stability][incompressible]") {
  for (const auto& [name, grid] : test::every_grid(Vec2(-0.2, -0.1), 5.6, 14)) {
    CAPTURE(name);
    const double plain = solve(cylinder(grid, methods[1], nearly, false)).pressure;
    CHECK(plain >= 10.0 * solve(cylinder(grid, methods[1], nearly, true)).pressure);
  }
}

TEST_CASE("patch test: a linear displacement between rollers is exact with the projected dilatation",
          "[stability][incompressible]") {
  for (const double poissons_ratio : {0.3, 0.49, nearly})
    for (const test::Held& held : {methods[0], methods[1]})
      for (const auto& [name, grid] : test::grids_under_square(held.method, 7)) {
        CAPTURE(name, poissons_ratio, static_cast<int>(held.method));
        Case problem =
            parse_case(test::manufactured_text(poissons_ratio), "square.json",
                       {"body_force=[0,0]", "constants.b=1e-4", R"J(exact.displacement=["2*b*X","-1.5*b*Y"])J",
                        R"J(exact.stress=["b*(0.5*la + 4*mu)", "b*(0.5*la - 3*mu)", "0"])J"});
        problem = test::on_grid(problem, grid, held, true);
        const Essential roller{
            .normal_only = true, .method = held.method, .band = nitsche_band(grid.basis), .narrows = true};
        problem.boundaries[0].condition = roller;
        problem.boundaries[2].condition = Case::Traction{Case::FromExact{}};
        problem.boundaries[3].condition = roller;
        Scene scene = build_scene(problem);
        RunRecord record;
        run_load_steps(scene, {}, record);
        const ErrorNorms norms = error_norms(scene.points, *scene.exact, 1.0);
        CHECK(norms.displacement_l2_relative.value() <= 1e-10);
        CHECK(norms.stress_l2_relative.value() <= 1e-10);
        CHECK(record.warnings.empty());
      }
}
