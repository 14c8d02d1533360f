#include "shoreline/engine/report.hpp"

#include <catch2/catch.hpp>

using namespace shoreline;
using Catch::Matchers::Contains;

TEST_CASE("the report of a projection has its errors and no load steps", "[engine][report]") {
  Summary summary;
  summary.title = "Sines";
  summary.completed = true;
  summary.degrees_of_freedom = 27;
  summary.projection_errors = ProjectionErrors{.l2 = 1.25e-3, .l2_relative = 2.5e-3, .derivative_l2 = {{0.5, 0.25}}};
  CHECK_THAT(report(summary, "out"), Contains("Sines: completed, 0 material points, 27 unknowns") &&
                                         Contains("L2 1.2500e-03, relative 2.500e-03") &&
                                         Contains("5.0000e-01 (x), 2.5000e-01 (y)") && !Contains("load step"));
}

TEST_CASE("a report has sizes, errors, cost, warnings and the folder", "[engine][report]") {
  Summary summary;
  summary.title = "Square";
  summary.completed = true;
  summary.steps = 1;
  summary.material_points = 64;
  summary.degrees_of_freedom = 50;
  summary.timings = {{"solve", 0.25}};
  summary.warnings = {"the band is wide"};
  CHECK_THAT(report(summary, "out/square"),
             Contains("Square: completed, 1 load step, 64 material points, 50 unknowns") && Contains("solve") &&
                 Contains("0.250") && Contains("warning: the band is wide") && Contains("results: out/square") &&
                 !Contains("errors") && !Contains("probes") && !Contains("fit"));

  summary.errors.emplace();
  summary.errors->stress[1] = {.mean_relative = 1.5e-4, .mean_absolute = 2.5, .max_absolute = 3.5};
  CHECK_THAT(report(summary, "out/square"),
             Contains("stress yy [Pa]") && Contains("1.500e-04") && Contains("2.500e+00") && Contains("3.500e+00"));

  summary.errors->boundary_radius["inner"] = {.mean = 2.0125, .exact = 2.0, .mean_relative = 6.25e-3};
  summary.displacement_fit["edge"] = {.l2 = 1.5e-5, .mean = 2.5e-5};
  summary.probes.push_back(
      {"tip", 0, 4, {{0.0, Vec2(1, 2), Vec2::Zero(), {}}, {1.0, Vec2(1, 5.25), Vec2(0, 3.25), {}}}});
  CHECK_THAT(report(summary, "out/square"), Contains("radius of inner: 2.0125 m, exact 2 m") && Contains("6.250e-03") &&
                                                Contains("edge") && Contains("1.500e-05") && Contains("2.500e-05 m") &&
                                                Contains("tip") && Contains("3.25") &&
                                                Contains("tracking point from (1, 2)"));
}
