// The plate with a hole on bases other than the bilinear one, Nitsche's method, integrated exactly: orders p + 1 and p.
#include <catch2/catch.hpp>

#include "../plate_on_basis.hpp"

using namespace shoreline;

namespace {

constexpr double chord = 0.001;

Case::Grid grid_of(Case::BasisType basis, int degree = 2) {
  Case::Grid grid;
  grid.basis = basis;
  grid.degree = degree;
  return grid;
}

/// @param more  factor of the ghost penalty
test::PlateResult plate(const char* file, const Case::Grid& grid, double h, double more = 1.0) {
  Case problem = test::plate_on(std::string("plate_with_hole/") + file, grid, h, chord);
  problem.ghost *= more;
  Scene scene = build_scene(problem);
  test::PlateResult result = test::compute(scene);
  CHECK(result.record.warnings.empty());
  return result;
}

}  // namespace

TEST_CASE("plate on Powell-Sabin splines: orders three and two", "[verification][plate]") {
  const Case::Grid grid = grid_of(Case::BasisType::powell_sabin);
  const test::PlateResult coarse = plate("neumann.json", grid, 0.125);
  const test::PlateResult fine = plate("neumann.json", grid, 0.0625);
  CHECK(coarse.displacement <= 4.9e-4);
  CHECK(coarse.stress <= 9.5e-3);
  CHECK(fine.displacement <= 4.1e-5);
  CHECK(fine.stress <= 2.5e-3);
  CHECK(std::log2(coarse.displacement / fine.displacement) >= 2.8);
  CHECK(std::log2(coarse.stress / fine.stress) >= 1.8);

  const test::PlateResult moved_coarse = plate("dirichlet.json", grid, 0.125);
  const test::PlateResult moved_fine = plate("dirichlet.json", grid, 0.0625);
  CHECK(moved_coarse.displacement <= 2.2e-4);
  CHECK(moved_fine.displacement <= 2.6e-5);
  CHECK(std::log2(moved_coarse.displacement / moved_fine.displacement) >= 2.8);
}

TEST_CASE("plate on Powell-Sabin splines: ten times the penalty doubles the error, a hundred times it makes it eight",
          "[verification][plate]") {
  const Case::Grid grid = grid_of(Case::BasisType::powell_sabin);
  const double error = plate("neumann.json", grid, 0.0625).displacement;
  CHECK(std::abs(plate("neumann.json", grid, 0.0625, 10.0).displacement / error - 2.0) <= 0.3);
  CHECK(std::abs(plate("neumann.json", grid, 0.0625, 100.0).displacement / error - 8.0) <= 1.0);
}

TEST_CASE("plate on quadratic B-splines: orders three and two", "[verification][plate]") {
  const Case::Grid grid = grid_of(Case::BasisType::bspline);
  for (const char* file : {"neumann.json", "dirichlet.json"}) {
    const test::PlateResult coarse = plate(file, grid, 0.125);
    const test::PlateResult fine = plate(file, grid, 0.0625);
    CHECK(fine.displacement <= 3.9e-5);
    CHECK(fine.stress <= 2.5e-3);
    CHECK(std::log2(coarse.displacement / fine.displacement) >= 2.8);
    CHECK(std::log2(coarse.stress / fine.stress) >= 1.8);
  }
}

TEST_CASE("plate on linear triangles: orders two and one", "[verification][plate]") {
  const Case::Grid grid = grid_of(Case::BasisType::linear);
  const test::PlateResult coarse = plate("neumann.json", grid, 0.125);
  const test::PlateResult fine = plate("neumann.json", grid, 0.03125);
  CHECK(fine.displacement <= 2.2e-3);
  CHECK(fine.stress <= 2.5e-2);
  CHECK(std::log2(coarse.displacement / fine.displacement) / 2.0 >= 1.6);
  CHECK(std::log2(coarse.stress / fine.stress) / 2.0 >= 0.8);
}
