// Bilinear cells under supports that no grid line follows: inclined rollers, and a displacement prescribed on an
// ellipse.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <numbers>

#include "../example_run.hpp"

using namespace shoreline;

namespace {

/// A sector of a thick cylinder between rollers at 20° and 110°.
std::string sector(double h) {
  return fmt::format(R"({{"analysis": {{"type": "quasi_static", "plane": "strain"}},
    "material": {{"type": "linear_elastic", "youngs_modulus": 1e6, "poissons_ratio": 0.25}},
    "grid": {{"lower": [-1.03, -0.02], "upper": [2.2, 2.2], "cell_size": {}}},
    "boundaries": [
      {{"name": "right", "line": {{"from": [0.9396926207859084, 0.3420201433256687],
                                 "to": [1.8793852415718169, 0.6840402866513374]}}, "condition": {{"type": "roller"}}}},
      {{"name": "outer", "arc": {{"centre": [0, 0], "radius": 2, "from": 20, "to": 110, "points": 33}}}},
      {{"name": "left", "line": {{"from": [-0.6840402866513374, 1.8793852415718169],
                                "to": [-0.3420201433256687, 0.9396926207859084]}}, "condition": {{"type": "roller"}}}},
      {{"name": "inner", "arc": {{"centre": [0, 0], "radius": 1, "from": 110, "to": 20, "points": 33}},
       "condition": {{"type": "pressure", "value": 1e4}}}}],
    "material_points": {{"per_cell": 4}},
    "exact": {{"type": "thick_cylinder", "inner_radius": 1, "outer_radius": 2, "pressure": 1e4}}}})",
                     h);
}

/// An ellipse whose rim is moved as in pure bending, σ_xx = c y.
std::string ellipse(double h) {
  std::string points;
  constexpr int number = 48;
  for (int k = 0; k <= number; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k % number) / number;
    points += fmt::format("{}[{:.17g}, {:.17g}]", k == 0 ? "" : ", ", 0.03 + 0.9 * std::cos(angle),
                          0.02 + 0.6 * std::sin(angle));
  }
  return fmt::format(R"({{"analysis": {{"type": "quasi_static", "plane": "stress"}},
    "material": {{"type": "linear_elastic", "youngs_modulus": 1e6, "poissons_ratio": 0.3}},
    "grid": {{"lower": [-1.013, -0.719], "upper": [1.1, 0.8], "cell_size": {}}},
    "boundaries": [{{"name": "rim", "points": [{}], "condition": {{"type": "displacement", "value": "exact"}}}}],
    "material_points": {{"per_cell": 4}}, "constants": {{"c": 1e-3}},
    "exact": {{"type": "expressions", "displacement": ["c*X*Y", "-c*(X*X + 0.3*Y*Y)/2"],
              "stress": ["1e6*c*Y", "0", "0"]}}}})",
                     h, points);
}

/// Relative L2 error of the displacement.
double error(const std::string& text, const std::vector<std::string>& pieces, const std::string& method, double band) {
  std::vector<std::string> overrides;
  for (const std::string& piece : pieces) {
    overrides.push_back("boundaries." + piece + ".condition.method=" + method);
    if (band > 0.0) overrides.push_back(fmt::format("boundaries.{}.condition.band={}", piece, band));
  }
  Scene scene = build_scene(parse_case(text, "body.json", overrides));
  RunRecord record;
  run_load_steps(scene, {}, record);
  return error_norms(scene.points, *scene.exact, 1.0).displacement_l2_relative.value();
}

}  // namespace

TEST_CASE(
    "bilinear cells keep order two under inclined rollers and on a prescribed ellipse, and lock at a band of 1e-6",
    "[verification]") {
  for (const bool rollers : {true, false}) {
    const auto body = [&](double h) { return rollers ? sector(h) : ellipse(h); };
    const std::vector<std::string> held =
        rollers ? std::vector<std::string>{"right", "left"} : std::vector<std::string>{"rim"};
    for (const char* const method : {"nitsche", "implicit_boundary"}) {
      const double coarse = error(body(1.0 / 8.0), held, method, 0.0);
      const double fine = error(body(1.0 / 32.0), held, method, 0.0);
      CAPTURE(rollers, method, coarse, fine);
      CHECK(std::log2(coarse / fine) / 2.0 >= 1.8);
      CHECK(fine <= 2e-3);
    }
    const double usual = error(body(1.0 / 16.0), held, "implicit_boundary", 0.0);
    const double narrow = error(body(1.0 / 16.0), held, "implicit_boundary", 1e-6);
    CAPTURE(rollers, usual, narrow);
    CHECK(narrow >= 3.0 * usual);
  }
}
