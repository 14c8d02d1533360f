// Supports, prescribed motion, damping and the energy of vibrations in explicit dynamics.

#include <catch2/catch.hpp>
#include <numbers>

#include "../moving_bodies.hpp"
#include "shoreline/engine/quasi_static.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// The base moves along itself.
Case::Displacement shaken(const char* formula) {
  return {.value = std::array{Quantity(Expression(formula)), Quantity(0.0)},
          .support = {.method = EssentialMethod::grid}};
}

/// Points of a scene on the line y = 2.
std::vector<Index> on_base(const DynamicScene& scene) {
  std::vector<Index> found;
  for (Index p = 0; p < scene.body.points.size(); ++p)
    if (std::abs(scene.body.points.position(1, p) - 2.0) < 1e-12) found.push_back(p);
  return found;
}

}  // namespace

TEST_CASE("the rate of momentum is weight and reaction, at every step", "[engine][dynamics]") {
  for (const auto& [name, grid] : test::every_grid(Vec2::Zero(), 6.0, 6)) {
    if (grid.mesh) continue;  // no edges along the base
    for (const MassForm mass : test::every_mass)
      for (const double pic : {0.0, 0.5, 1.0}) {
        CAPTURE(name, name_of(mass), pic);
        Case problem = test::standing_block(grid, {});
        problem.gravity = Vec2(0.01, -0.03);
        problem.analysis = ExplicitDynamics{.time_step = 0.05, .end_time = 2.0, .mass = mass, .pic = pic};
        DynamicScene scene = build_dynamic_scene(problem);
        CHECK(test::worst_imbalance(scene) < 1e-10);
        CHECK(energies(scene, 2.0).momentum.y() < -0.01);
      }
  }
}

TEST_CASE("reactions of a base that is shaken are the rate of momentum", "[engine][dynamics]") {
  for (const MassForm mass : test::every_mass)
    for (const double pic : {0.0, 1.0}) {
      CAPTURE(name_of(mass), pic);
      Case problem = test::standing_block(test::unit_cells(6.0), {.base = shaken("0.05*sin(3*t)")});
      problem.analysis = ExplicitDynamics{.time_step = 0.05, .end_time = 2.0, .mass = mass, .pic = pic};
      DynamicScene scene = build_dynamic_scene(problem);
      CHECK(test::worst_imbalance(scene) < 1e-10);
      CHECK(scene.body.points.stress.row(2).cwiseAbs().maxCoeff() > 1e-3);
    }
}

TEST_CASE("rollers let the body slide and hold it across, exactly", "[engine][dynamics]") {
  for (const auto& [name, grid] : test::every_grid(Vec2::Zero(), 6.0, 6)) {
    if (grid.mesh) continue;
    CAPTURE(name);
    Case problem = test::standing_block(grid, {.base = test::grid_roller});
    problem.material_points = VertexFill{{4, 4}};
    problem.gravity = Vec2(0.05, -0.05);
    problem.analysis = ExplicitDynamics{.time_step = 0.02, .end_time = 1.0};
    DynamicScene scene = build_dynamic_scene(problem);
    const std::vector<Index> held = on_base(scene);
    REQUIRE(held.size() == 9);
    test::run_steps(scene);
    for (const Index p : held) {
      CHECK_THAT(scene.body.points.displacement(1, p), WithinAbs(0.0, 1e-14));
      CHECK(scene.body.points.displacement(0, p) > 0.01);
    }
    CHECK(scene.body.points.displacement.row(1).minCoeff() < -1e-3);
  }
}

TEST_CASE("what stands on a line follows the displacement that is prescribed there", "[engine][dynamics]") {
  for (const std::optional<double> time_step : {std::optional(0.03), std::optional<double>()})
    for (const MassForm mass : {MassForm::lumped, MassForm::partly_lumped}) {
      CAPTURE(time_step.value_or(0.0), name_of(mass));
      Case problem = test::standing_block(test::unit_cells(6.0), {.base = shaken("0.4*(1-cos(2*t))")});
      problem.material_points = VertexFill{{4, 4}};
      problem.analysis = ExplicitDynamics{.time_step = time_step, .safety = 0.4, .end_time = 1.234, .mass = mass};
      DynamicScene scene = build_dynamic_scene(problem);
      const std::vector<Index> held = on_base(scene);
      REQUIRE(held.size() == 9);
      const auto prescribed = [](double t) { return 0.4 * (1.0 - std::cos(2.0 * t)); };
      double before = 0.0;
      test::run_steps(scene, [&](const DynamicRecord&, double t) {
        const double speed = (prescribed(t) - prescribed(before)) / (t - before);
        before = t;
        for (const Index p : held) {
          REQUIRE_THAT(scene.body.points.displacement(0, p), WithinAbs(prescribed(t), 1e-12));
          REQUIRE_THAT(scene.body.points.displacement(1, p), WithinAbs(0.0, 1e-14));
          REQUIRE_THAT(scene.motion.velocity(0, p), WithinAbs(speed, 1e-10));
        }
        const Vec2& end = scene.body.boundary[0].piece.points.front();
        REQUIRE_THAT(end.x() - 2.0, WithinAbs(prescribed(t), 1e-9));
      });
    }
}

TEST_CASE("damping brings a block to rest at its static solution", "[engine][dynamics]") {
  Case problem = test::standing_block(test::unit_cells(6.0), {.sides = test::grid_roller});
  problem.gravity = Vec2(0.0, -1e-6);
  problem.analysis = ExplicitDynamics{.safety = 0.9, .end_time = 300.0, .damping = 0.5};
  problem.history = 1;
  DynamicScene scene = build_dynamic_scene(problem);
  const DynamicRecord record = test::run_steps(scene);
  double fastest = 0.0;
  for (const HistoryState& state : record.history) fastest = std::max(fastest, state.kinetic);
  CHECK(fastest > 0.0);
  CHECK(record.history.back().kinetic < 1e-9 * fastest);
  CHECK(record.history.back().total() < record.history.front().total());

  problem.analysis = QuasiStatic{};
  problem.material.law = Case::Law::linear_elastic;
  Scene at_rest = build_scene(problem);
  RunRecord ignored;
  run_load_steps(at_rest, {}, ignored);
  CHECK((scene.body.points.displacement - at_rest.points.displacement).norm() <=
        1e-5 * at_rest.points.displacement.norm());
  CHECK((scene.body.points.stress - at_rest.points.stress).norm() <= 1e-5 * at_rest.points.stress.norm());
  CHECK_THAT(record.resultants.reactions.at("base").y(), WithinRel(4e-6, 1e-6));
}

TEST_CASE("without damping a free vibration keeps its energy", "[engine][dynamics]") {
  for (const Case::Law law : {Case::Law::linear_large, Case::Law::neo_hookean, Case::Law::hypoelastic}) {
    Case problem = test::standing_block(test::unit_cells(6.0), {});
    problem.material.law = law;
    problem.initial_velocity = test::formulas("1e-5*(y-2)", "-1e-5*(y-2)");  // of the bilinear basis
    problem.analysis = ExplicitDynamics{.safety = 0.5, .end_time = 800.0, .mass = MassForm::consistent};
    problem.history = 1;
    DynamicScene scene = build_dynamic_scene(problem);
    const double start = energies(scene, 0.0).total();
    const DynamicRecord record = test::run_steps(scene);
    REQUIRE(record.steps > 2000);  // about 100 periods of the lowest frequency
    for (const HistoryState& state : record.history) REQUIRE_THAT(state.total(), WithinRel(start, 0.2));
    const auto mean = [&](std::size_t from, std::size_t to) {
      double sum = 0.0;
      for (std::size_t k = from; k < to; ++k) sum += record.history[k].total();
      return sum / static_cast<double>(to - from);
    };
    const std::size_t n = record.history.size();
    CHECK_THAT(mean(n / 2, n), WithinRel(mean(0, n / 2), 1e-3));
  }
}
