// The cantilever under a following pressure (Bing et al. 2019, §4.2), by the paper's incremental loading.
#include <catch2/catch.hpp>
#include <cmath>

#include "../example_run.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using test::ExampleRun;

namespace {

struct Layout {
  double cell_size;
  int across, high;
  double pressure;  ///< [Pa]
  int steps;
};

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

std::vector<std::string> overrides(const Layout& l) {
  const auto set = [](const std::string& key, double value) { return key + "=" + number(value); };
  return {set("grid.cell_size", l.cell_size),
          set("analysis.load_steps", l.steps),
          set("boundaries.top.condition.value", l.pressure),
          set("boundaries.bottom.line.points", l.across),
          set("boundaries.top.line.points", l.across),
          set("boundaries.tip.line.points", l.high + 1),
          "material_points.across=[" + std::to_string(l.across) + "," + std::to_string(l.high) + "]"};
}

/// The left edge's central span is fixed, the rest of it a roller.
std::vector<std::string> central_support(const Layout& l) {
  std::vector<std::string> all = overrides(l);
  const double span = 2.0 / (l.high - 1);
  const std::string high = number(1.5 + 0.5 * span);
  const std::string low = number(1.5 - 0.5 * span);
  all.insert(all.end(),
             {"boundaries.upper.line.to=[0.25," + high + "]", "boundaries.support.line.from=[0.25," + high + "]",
              "boundaries.support.line.to=[0.25," + low + "]", "boundaries.lower.line.from=[0.25," + low + "]",
              "boundaries.upper.line.points=" + std::to_string(l.high / 2),
              "boundaries.lower.line.points=" + std::to_string(l.high / 2)});
  return all;
}

std::vector<std::string> clamped(const Layout& l) {
  std::vector<std::string> all = overrides(l);
  all.push_back("boundaries.left.line.points=" + std::to_string(l.high));
  return all;
}

/// Deflection of the middle of the tip [m].
double tip(ExampleRun&& run) {
  run.compute();
  return -run.scene.probes.at(0).history.back().displacement.y();
}
double tip(const std::string& file, const std::vector<std::string>& changes) {
  return tip(ExampleRun("cantilever/" + file + ".json", changes));
}

/// ∫ p n dS along a curve, from its ends alone.
Vec2 thrust(const SplineCurve& curve, double pressure) {
  const Vec2 across = curve.spans.back().position(1.0) - curve.spans.front().position(0.0);
  return pressure * Vec2(-across.y(), across.x());
}

}  // namespace

TEST_CASE("cantilever: the tip's deflection is that of the paper's scheme", "[verification][cantilever]") {
  CHECK_THAT(tip("central_support", central_support({0.75, 28, 8, 3000.0, 10})), WithinAbs(5.087, 0.02));
  CHECK_THAT(tip("central_support", central_support({1.5, 56, 16, 1500.0, 5})), WithinRel(2.216, 0.005));
  CHECK_THAT(tip("central_support", central_support({0.375, 112, 32, 1500.0, 5})), WithinRel(2.742, 0.005));
}

TEST_CASE("cantilever, left edge fixed over its height: towards the limit of finite elements with constant weights",
          "[verification][cantilever]") {
  constexpr double limit = 2.7605;  // examples/cantilever/finite_elements.py; 2.7525 with weights of the moved mesh
  const double coarse = tip("clamped", clamped({0.75, 112, 32, 1500.0, 5}));
  const double middle = tip("clamped", clamped({0.375, 224, 64, 1500.0, 5}));
  const double fine = tip("clamped", clamped({0.1875, 448, 128, 1500.0, 5}));
  CHECK_THAT(fine, WithinRel(limit, 0.005));
  CHECK(std::log2((limit - coarse) / (limit - middle)) >= 1.5);
  CHECK(std::log2((limit - middle) / (limit - fine)) >= 1.5);
}

TEST_CASE("cantilever: the deformed spline passes through the moved tracking points", "[verification][cantilever]") {
  ExampleRun run("cantilever/central_support.json", {});
  run.after_step = [&](int) {
    for (const BoundaryPiece& b : run.scene.boundary) {
      const SplineCurve curve = fit_spline(b.piece);
      for (std::size_t k = 0; k < curve.spans.size(); ++k)
        CHECK((curve.spans[k].position(0.0) - b.piece.points[k]).norm() <= 1e-14);
    }
  };
  run.compute();
  const Probe& probe = run.scene.probes.at(0);
  REQUIRE(probe.piece);  // on the tip's tracking point at its middle
  CHECK(probe.history.size() == 11);
  CHECK(probe.history.back().position == run.scene.boundary[1].piece.points[4]);
}

TEST_CASE("cantilever: the pressure's resultant is that of the current curve", "[verification][cantilever]") {
  for (const char* loading : {"residual", "incremental"}) {
    CAPTURE(loading);
    ExampleRun run("cantilever/central_support.json",
                   {"analysis.loading=" + std::string(loading), "boundaries.top.condition.value=1500", "ghost=0.001"});
    const bool total = run.scene.loading == Loading::residual;
    const int steps = run.scene.load_steps;
    Vec2 sum = Vec2::Zero();
    SplineCurve current = fit_spline(run.scene.boundary[2].piece);
    run.after_step = [&](int step) {
      if (total)
        sum = thrust(current, 1500.0 * step / steps);
      else
        sum += thrust(current, 1500.0 / steps);
      CHECK((run.record.resultants.loads.at("top").head<2>() - sum).norm() <= 1e-12 * sum.norm());
      current = fit_spline(run.scene.boundary[2].piece);
    };
    run.compute();
  }
}

TEST_CASE("a uniform pressure around a hole keeps its balance however the hole deforms", "[verification][pressure]") {
  Case problem;
  problem.file = "hole.json";
  problem.material = {.youngs_modulus = 1e6, .poissons_ratio = 0.25, .density = {}};
  problem.grid = {.lower = Vec2(-0.1, -0.1), .upper = Vec2(2.1, 1.6), .cell_size = Vec2(0.12, 0.12)};
  Piece sides{.name = "sides", .points = {{0, 0}, {2, 0}, {2, 1.5}, {0, 1.5}}, .corners = {0, 1, 2, 3}, .closed = true};
  Piece hole = circle({0.8, 0.6}, 0.35, 24, true);
  hole.name = "hole";
  problem.boundaries = {{sides, Essential{}}, {hole, Case::Pressure{Quantity(4e5)}}};
  problem.material_points = LatticeFill{{4, 4}, VolumeRule::clipped};
  std::get<QuasiStatic>(problem.analysis).load_steps = 5;
  problem.ghost = 1e-3;
  for (const Loading loading : {Loading::residual, Loading::incremental}) {
    std::get<QuasiStatic>(problem.analysis).loading = loading;
    Scene scene = build_scene(problem);
    RunRecord record;
    const double integral = 4e5 * 2.0 * 3.14159 * 0.35;
    double moved = 0.0;
    const auto after_step = [&](int) {
      CHECK(record.resultants.loads.at("hole").norm() <= 1e-12 * integral);
      for (std::size_t k = 0; k < hole.points.size(); ++k)
        moved = std::max(moved, (scene.boundary[1].piece.points[k] - hole.points[k]).norm());
    };
    run_load_steps(scene, {.after_step = after_step}, record);
    CHECK(moved > 0.1);  // a third of its radius
  }
}
