// The compression square of Bing et al. 2019, §4.1, from the cases of examples/compression.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/quasi_static.hpp"

using namespace shoreline;

namespace {

using Overrides = std::vector<std::string>;

struct Result {
  ErrorNorms errors;
  RunRecord record;
};

Result compute(const std::string& name, const Overrides& overrides) {
  const Case problem = read_case(std::string(SHORELINE_EXAMPLES) + "/compression/" + name, overrides);
  Scene scene = build_scene(problem);
  Result result;
  run_load_steps(scene, {.condition_estimate = problem.condition_estimate}, result.record);
  result.errors = error_norms(scene.points, scene.exact.value(), 1.0);
  return result;
}

/// The square whose outline runs through the outer of n points a cell and direction.
Overrides through_outer_points(int n) {
  const double low = 0.25 / n;
  const double high = 1.0 - low;
  return {fmt::format("material_points.per_cell={}", n),
          fmt::format("boundaries.bottom.points=[[{0},{0}],[{1},{0}]]", low, high),
          fmt::format("boundaries.right.points=[[{1},{0}],[{1},{1}]]", low, high),
          fmt::format("boundaries.top.points=[[{1},{1}],[{0},{1}]]", low, high),
          fmt::format("boundaries.left.points=[[{0},{1}],[{0},{0}]]", low, high),
          fmt::format("constants.y0={}", low)};
}

double stress_error(const Overrides& overrides) {
  return compute("implicit.json", overrides).errors.stress[1].mean_relative.value();
}

Overrides with(Overrides overrides, const std::string& one_more) {
  overrides.push_back(one_more);
  return overrides;
}

Overrides method(const std::string& name, double band) {
  Overrides overrides;
  for (const char* piece : {"bottom", "right", "left"}) {
    overrides.push_back(fmt::format("boundaries.{}.condition.method={}", piece, name));
    overrides.push_back(fmt::format("boundaries.{}.condition.band={}", piece, band));
  }
  return overrides;
}

double largest(const std::array<ErrorNorms::Component, 3>& stress) {
  return std::max({stress[0].mean_relative.value(), stress[1].mean_relative.value(), stress[2].mean_relative.value()});
}

}  // namespace

TEST_CASE("aligned square: conventional rollers and a spline traction are exact to rounding", "[verification]") {
  const int n = GENERATE(range(1, 9));
  CAPTURE(n);
  const ErrorNorms errors = compute("aligned.json", {fmt::format("material_points.per_cell={}", n)}).errors;
  CHECK(errors.stress[0].mean_relative.value() <= 1e-14);
  CHECK(errors.stress[1].mean_relative.value() <= 1e-14);
  CHECK(errors.displacement[1].mean_absolute <= 1e-16);
}

TEST_CASE("square through its outer points: the stress error is the paper's, and falls with order two",
          "[verification]") {
  const double e8 = stress_error(through_outer_points(8));
  const double e16 = stress_error(through_outer_points(16));
  const double e32 = stress_error(through_outer_points(32));
  CAPTURE(e8, e16, e32);
  CHECK(std::abs(e32 - 8.181e-5) <= 1e-7);  // Bing et al. 2019 §4.1.2: 8.18e-5
  CHECK(std::log2(e8 / e16) >= 1.95);
  CHECK(std::log2(e16 / e32) >= 1.95);
}

TEST_CASE("square through its outer points: whole volumes on the outline leave order one", "[verification]") {
  const auto whole = [](int n) {
    return stress_error(with(through_outer_points(n), "material_points.volumes=lattice"));
  };
  const double rate = std::log2(whole(8) / whole(32)) / 2.0;
  CHECK(rate >= 0.9);
  CHECK(rate <= 1.05);
}

TEST_CASE("turned square, one point a cell, implicit boundary: error as the band", "[verification]") {
  const std::string name = GENERATE(as<std::string>(), "rotated_45.json", "rotated_60.json");
  CAPTURE(name);
  const ErrorNorms wide = compute(name, method("implicit_boundary", 1e-6)).errors;
  CHECK(largest(wide.stress) <= 1e-7);
  CHECK(wide.displacement[1].mean_relative.value() <= 3e-7);
  const ErrorNorms narrow = compute(name, method("implicit_boundary", 1e-7)).errors;
  CHECK(largest(narrow.stress) <= 2e-8);
  CHECK(narrow.displacement[1].mean_relative.value() <= 3e-8);
}

TEST_CASE("turned square, one point a cell, Nitsche: exact whatever the band", "[verification]") {
  const std::string name = GENERATE(as<std::string>(), "rotated_45.json", "rotated_60.json");
  const double band = GENERATE(0.1, 0.01, 0.001);
  CAPTURE(name, band);
  const ErrorNorms errors = compute(name, method("nitsche", band)).errors;
  CHECK(largest(errors.stress) <= 1e-11);
  CHECK(errors.displacement[1].mean_relative.value() <= 1e-11);
}

TEST_CASE("turned square: the error falls with the band, then rises with the condition number", "[verification]") {
  const auto at = [](double band) {
    const Result result =
        compute("rotated_60.json", with(method("implicit_boundary", band), "diagnostics.condition_estimate=true"));
    return std::pair(largest(result.errors.stress), result.record.condition_estimate.value());
  };
  const auto [wide, condition_wide] = at(1e-3);
  const auto [best, condition_best] = at(1e-7);
  const auto [narrow, condition_narrow] = at(1e-12);
  CAPTURE(wide, best, narrow);
  CHECK(best < 1e-3 * wide);
  CHECK(narrow > best);
  CHECK(condition_best > 1e3 * condition_wide);
  CHECK(condition_narrow > 1e3 * condition_best);
}
