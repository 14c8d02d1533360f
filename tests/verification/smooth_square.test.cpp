// A smooth displacement on the unit square, exactly integrated: the error of every basis and its order.

#include <catch2/catch.hpp>
#include <cmath>

#include "../exact_points.hpp"
#include "../example_run.hpp"

using namespace shoreline;

namespace {

struct Errors {
  double displacement;
  double stress;
};

/// @param grid  overrides that name the basis
Errors solve(std::vector<std::string> grid, int cells) {
  grid.push_back("grid.cell_size=" + std::to_string(1.0 / cells));
  Case problem = read_case(std::string(SHORELINE_EXAMPLES) + "/smooth_square/square.json", grid);
  const Scene empty = build_scene(problem);
  problem.material_points = test::exact_points(empty.basis->grid(), {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 4);
  Scene scene = build_scene(problem);
  RunRecord record;
  run_load_steps(scene, {}, record);
  const ErrorNorms norms = error_norms(scene.points, *scene.exact, 1.0);
  return {norms.displacement_l2_relative.value(), norms.stress_l2_relative.value()};
}

void check_published(const Errors& errors, double displacement, double stress) {
  CHECK(errors.displacement == Approx(displacement).epsilon(0.02));
  CHECK(errors.stress == Approx(stress).epsilon(0.02));
}

double rate(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace

TEST_CASE("smooth square: Powell-Sabin splines and quadratic B-splines reach orders 3 and 2", "[verification]") {
  struct Published {
    std::vector<std::string> grid;
    std::array<Errors, 3> errors;  ///< on 8, 16 and 32 cells a side
  };
  for (const Published& published :
       {Published{{"grid.basis=powell_sabin"}, {{{1.098e-3, 9.10e-3}, {1.255e-4, 2.05e-3}, {1.520e-5, 4.90e-4}}}},
        Published{{"grid.basis=bspline", "grid.degree=2"},
                  {{{1.548e-3, 8.04e-3}, {1.730e-4, 1.925e-3}, {2.100e-5, 4.76e-4}}}}}) {
    CAPTURE(published.grid.front());
    std::array<Errors, 3> found{};
    for (std::size_t k = 0; k < 3; ++k) {
      found[k] = solve(published.grid, 8 << k);
      check_published(found[k], published.errors[k].displacement, published.errors[k].stress);
    }
    CHECK(rate(found[1].displacement, found[2].displacement) >= 2.9);
    CHECK(rate(found[1].stress, found[2].stress) >= 1.95);
  }
}

TEST_CASE("smooth square: bilinear functions and linear triangles reach orders 2 and 1", "[verification]") {
  for (const auto& [basis, displacement, stress] :
       {std::tuple("bilinear", 3.902e-4, 1.519e-2), std::tuple("linear", 1.100e-3, 2.913e-2)}) {
    const std::vector<std::string> grid{std::string("grid.basis=") + basis};
    CAPTURE(basis);
    const Errors middle = solve(grid, 32);
    const Errors fine = solve(grid, 64);
    check_published(fine, displacement, stress);
    CHECK(rate(middle.displacement, fine.displacement) >= 1.95);
    CHECK(rate(middle.stress, fine.stress) >= 0.97);
  }
}

TEST_CASE("smooth square: cubic B-splines reach orders 4 and 3", "[verification]") {
  const std::vector<std::string> grid{"grid.basis=bspline", "grid.degree=3"};
  const Errors middle = solve(grid, 16);
  const Errors fine = solve(grid, 32);
  CHECK(rate(middle.displacement, fine.displacement) >= 3.8);
  CHECK(rate(middle.stress, fine.stress) >= 2.8);
}
