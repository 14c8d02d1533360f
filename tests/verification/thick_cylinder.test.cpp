// The thick cylinder (Bing et al. 2019, §4.3): the pressure doubles the inner radius in one linear step.
#include <catch2/catch.hpp>
#include <cmath>

#include "../example_run.hpp"

using namespace shoreline;
using Catch::Matchers::WithinRel;

namespace {

/// Relative error of the inner radius.
double radius_error_of(const std::string& file, double h, std::vector<std::string> overrides = {}) {
  overrides.push_back("grid.cell_size=" + std::to_string(h));
  test::ExampleRun run("thick_cylinder/" + file + ".json", overrides);
  run.compute();
  const BoundaryPiece& inner = run.scene.boundary[3];
  REQUIRE(inner.piece.name == "inner");
  const auto error = radius_error(*inner.original, fit_spline(inner.piece), *run.scene.exact, 1.0);
  REQUIRE(error);
  CHECK_THAT(error->exact, WithinRel(2.0040625, 1e-9));
  return std::abs(error->mean / error->exact - 1.0);
}

std::string shifted(double h) {
  const std::string corner = std::to_string(-0.3 * h);
  return "grid.lower=[" + corner + "," + corner + "]";
}

}  // namespace

TEST_CASE("thick cylinder: the inner radius converges with order two", "[verification][thick_cylinder]") {
  const double coarse = radius_error_of("conventional", 0.25);
  const double fine = radius_error_of("conventional", 0.125);
  CHECK(coarse <= 5.5e-3);
  CHECK(fine <= 1.5e-3);
  CHECK(std::log2(coarse / fine) >= 1.8);
}

TEST_CASE("thick cylinder: rollers off the grid lines do as well as rollers on them",
          "[verification][thick_cylinder]") {
  for (const double h : {0.5, 0.25, 0.125}) {
    CAPTURE(h);
    const double conventional = radius_error_of("conventional", h);
    CHECK_THAT(radius_error_of("implicit", h), WithinRel(conventional, 0.05));
    if (h <= 0.25) CHECK_THAT(radius_error_of("implicit", h, {shifted(h)}), WithinRel(conventional, 0.05));
  }
}

TEST_CASE("thick cylinder: with equal volumes the radius does not converge", "[verification][thick_cylinder]") {
  for (const double h : {0.5, 0.25, 0.125})
    CHECK(radius_error_of("conventional", h, {"material_points.volumes=equal"}) > 0.2);
}
