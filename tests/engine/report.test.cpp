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

  summary.errors->places = 81;
  CHECK_THAT(report(summary, "out"), Contains("errors at 81 material points\n") && !Contains("strain energy"));
  summary.errors->at_samples = true;
  summary.strain_energy = 2.5e-3;
  CHECK_THAT(report(summary, "out"),
             Contains("errors at 81 sample points\n") && Contains("strain energy: 2.500000e-03 J/m"));

  summary.errors->displacement_l2 = 1.125e-6;
  summary.errors->stress_l2 = 7.5;
  CHECK_THAT(report(summary, "out"), Contains("absolute 1.125e-06 m^2, 7.500e+00 Pa m") && !Contains("over time"));

  summary.error_estimate = ErrorEstimate{.stress_l2 = 6.0, .stress_l2_relative = 0.0125, .stress_at_point = {}};
  CHECK_THAT(report(summary, "out"),
             Contains("estimated error of stress: L2 6.000e+00 Pa m, relative 1.250e-02; 0.8 times the error"));

  summary.errors->boundary_radius["inner"] = {.mean = 2.0125, .exact = 2.0, .mean_relative = 6.25e-3};
  summary.displacement_fit["edge"] = {.l2 = 1.5e-5, .mean = 2.5e-5};
  summary.probes.push_back(
      {"tip", 0, 4, {{0.0, Vec2(1, 2), Vec2::Zero(), {}}, {1.0, Vec2(1, 5.25), Vec2(0, 3.25), {}}}});
  CHECK_THAT(report(summary, "out/square"), Contains("radius of inner: 2.0125 m, exact 2 m") && Contains("6.250e-03") &&
                                                Contains("edge") && Contains("1.500e-05") && Contains("2.500e-05 m") &&
                                                Contains("tip") && Contains("3.25") &&
                                                Contains("tracking point from (1, 2)"));
}

TEST_CASE("the report of a dynamic run speaks of steps, time steps and energies", "[engine][report]") {
  Summary summary;
  summary.title = "Bar";
  summary.completed = true;
  summary.steps = 250;
  summary.dynamics.emplace();
  summary.dynamics->law = "linear_elastic";
  summary.dynamics->objective = false;
  summary.dynamics->mass = "lumped";
  summary.dynamics->pic = 0.25;
  summary.dynamics->end_time = 2.5;
  summary.dynamics->smallest_step = 0.0075;
  summary.dynamics->largest_step = 0.0125;
  summary.dynamics->critical_step_at_start = 0.015;
  summary.dynamics->smallest_critical_step = 0.0135;
  summary.dynamics->time_of_smallest = 1.75;
  summary.dynamics->courant = 0.9;
  summary.history = {{.t = 0.0, .kinetic = 11.5, .strain = 0.0, .gravity = 0.0},
                     {.t = 2.5, .kinetic = 3.25, .strain = 4.5, .gravity = -0.125}};
  summary.errors.emplace();
  summary.errors->over_time = {{"velocity", 1.5e-3, 2.5e-3}};
  CHECK_THAT(report(summary, "out"), Contains("Bar: completed, 250 steps, ") && !Contains("load step") &&
                                         Contains("linear_elastic, not objective") && Contains("lumped") &&
                                         Contains("0.25 PIC, 0.75 FLIP") &&
                                         Contains("0.0075 to 0.0125, until t = 2.5") &&
                                         Contains("0.015 at the start, smallest 0.0135 at t = 1.75") &&
                                         Contains("0.9") && !Contains("damping") && !Contains("dropped"));
  CHECK_THAT(report(summary, "out"), Contains("11.5") && Contains("3.25") && Contains("4.5") && Contains("-0.125") &&
                                         Contains("7.625") &&
                                         Contains("over time, velocity [m/s]: rms 1.500e-03, mean of rms 2.500e-03"));

  summary.dynamics->damping = 0.05;
  summary.dynamics->dropped_points = 3;
  summary.dynamics->objective = true;
  CHECK_THAT(report(summary, "out"),
             Contains("damping             0.05") && Contains("dropped points      3") && !Contains("not objective"));
}

TEST_CASE("the report tells of weak spots in two lines, where there is something to tell", "[engine][report]") {
  Summary summary;
  CHECK_THAT(report(summary, "out"), !Contains("weak spots"));
  summary.diagnostics = Diagnostics{.smallest_cut = Diagnostics::Cut{1.25e-9, 7, Vec2(0.5, 1.5)},
                                    .smallest_pivot = Diagnostics::Pivot{1e-8, Vec2(1.0, 2.0), 1},
                                    .stray_points = 2,
                                    .first_stray = Vec2(3.0, 4.0),
                                    .fewest_points = 1};
  CHECK_THAT(report(summary, "out"), Contains("smallest cut 1.25e-09 of the cell around (0.5, 1.5)") &&
                                         Contains("smallest pivot 1.0e-08, y of the function at (1, 2)") &&
                                         Contains("fewest points in a cell 1; stray points 2, first at (3, 4)"));
}

TEST_CASE("the report tells what fitting the weights came to", "[engine][report]") {
  Summary summary;
  CHECK_THAT(report(summary, "out"), !Contains("fitted weights"));
  summary.fitted_weights = WeightReport{.changed = 0.25, .bounded = 7};
  CHECK_THAT(report(summary, "out"), Contains("fitted weights: 25 % of the points changed") &&
                                         Contains("7 at the bound") && !Contains("unmet") &&
                                         !Contains("without points"));
  summary.fitted_weights->iterations = 3;
  summary.fitted_weights->unmet = 2e-3;
  summary.fitted_weights->unserved = 1e-5;
  CHECK_THAT(report(summary, "out"), Contains("unmet by up to 2.0e-03") && Contains("1.0e-05 of the body"));
}
