#include "shoreline/engine/dynamics.hpp"

#include <catch2/catch.hpp>

#include "../moving_bodies.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

/// A body on its way, with what its speeds are measured by [m/s].
struct Flight {
  Case problem;
  double speed;
};

/// 50 steps: with a lumped mass through the cells of a grid of side 6; with the consistent one, which few points in a
/// cell make singular, as a body that fills the grid and hardly moves.
Flight flight(const Case::Grid& grid, MassForm mass, double pic) {
  const bool fills = mass == MassForm::consistent;
  Case problem = test::free_block(grid, Vec2(1.3, 1.2), Vec2(3.4, 3.3), 16);
  if (fills) problem.material_points = test::patch_points(grid, {Vec2(0, 0), Vec2(6, 0), Vec2(6, 6), Vec2(0, 6)});
  problem.analysis = ExplicitDynamics{.time_step = 0.02, .end_time = 1.0, .mass = mass, .pic = pic};
  return {problem, fills ? 1e-4 : 1.0};
}

/// Formulas times the speed of a flight.
std::array<Expression, 2> scaled(const Flight& flight, const std::string& x, const std::string& y) {
  const std::map<std::string, double> constants{{"speed", flight.speed}};
  return {Expression("speed*(" + x + ")", constants), Expression("speed*(" + y + ")", constants)};
}

template <class Use>
void for_every_scheme(Use&& use) {
  for (const auto& [name, grid] : test::every_grid(Vec2::Zero(), 6.0, 6))
    for (const MassForm mass : test::every_mass)
      for (const double pic : {0.0, 0.5, 1.0}) {
        CAPTURE(name, name_of(mass), pic);
        use(flight(grid, mass, pic));
      }
}

/// Runs a scene; its mass and momentum must stay.
void check_conservation(DynamicScene& scene) {
  const Eigen::VectorXd mass = scene.motion.mass;
  const Vec2 before = energies(scene, 0.0).momentum;
  test::run_steps(scene);
  CHECK(scene.motion.mass == mass);
  CHECK((energies(scene, 1.0).momentum - before).norm() <= 1e-12 * before.norm());
}

double largest(const Eigen::Matrix2Xd& field) { return field.cwiseAbs().maxCoeff(); }

const std::vector<Case::Law> laws = {Case::Law::linear_large, Case::Law::neo_hookean, Case::Law::hypoelastic};

}  // namespace

TEST_CASE("a free body keeps its mass and its momentum, whatever basis, mass matrix and transfer",
          "[engine][dynamics]") {
  for_every_scheme([](Flight flight) {
    flight.problem.initial_velocity = scaled(flight, "1.1+0.1*sin(X*Y)", "0.4*cos(X)-0.1*Y");
    DynamicScene scene = build_dynamic_scene(flight.problem);
    check_conservation(scene);
    CHECK(scene.body.points.displacement.row(0).mean() > 0.9 * flight.speed);  // of a cell, or less
    CHECK(scene.body.points.stress.norm() > 0.01 * flight.speed);
  });
}

TEST_CASE("a free body keeps its momentum with the consistent mass as it crosses cells", "[engine][dynamics]") {
  for (const double pic : {0.0, 0.5, 1.0}) {
    Case problem = test::free_block(test::unit_cells(6.0), Vec2(1.3, 1.2), Vec2(3.4, 3.3), 16);
    problem.material.youngs_modulus = 0.01;
    problem.analysis = ExplicitDynamics{.time_step = 0.02, .end_time = 0.5, .mass = MassForm::consistent, .pic = pic};
    problem.initial_velocity = test::formulas("1.1+0.1*sin(X*Y)", "0.4*cos(X)-0.1*Y");
    DynamicScene scene = build_dynamic_scene(problem);
    check_conservation(scene);
    CHECK(scene.body.points.displacement.row(0).minCoeff() > 0.4);
  }
}

TEST_CASE("a consistent mass that too few points make singular is told, with what to do", "[engine][dynamics]") {
  Case problem = test::free_block(test::every_grid(Vec2::Zero(), 6.0, 6)[4].grid, Vec2(1.3, 1.2), Vec2(3.4, 3.3), 3);
  problem.analysis = ExplicitDynamics{.time_step = 1e-3, .end_time = 1.0, .mass = MassForm::consistent};
  DynamicScene scene = build_dynamic_scene(problem);
  CHECK_THROWS_WITH(first_step(scene), Contains("mass matrix is singular") && Contains("\"partly_lumped\""));
}

TEST_CASE("a body that moves as one does so for ever, without stress", "[engine][dynamics]") {
  for_every_scheme([](Flight flight) {
    flight.problem.initial_velocity = scaled(flight, "1.1", "-0.6");
    DynamicScene scene = build_dynamic_scene(flight.problem);
    test::run_steps(scene);
    const Vec2 velocity = flight.speed * Vec2(1.1, -0.6);
    CHECK(largest(scene.motion.velocity.colwise() - velocity) < 1e-10 * flight.speed);
    CHECK(largest(scene.body.points.displacement.colwise() - velocity) < 1e-10 * flight.speed);
    CHECK(scene.body.points.stress.cwiseAbs().maxCoeff() < 1e-9 * flight.speed);
  });
}

TEST_CASE("a body in free fall has v = g t and the sum of that in displacement", "[engine][dynamics]") {
  for (const bool as_field : {false, true})
    for_every_scheme([&](Flight flight) {
      const Vec2 g = flight.speed * Vec2(0.3, -0.3);
      if (as_field)
        flight.problem.gravity_field = scaled(flight, "0.3", "-0.3");
      else
        flight.problem.gravity = g;
      DynamicScene scene = build_dynamic_scene(flight.problem);
      const double dt = 0.02;
      test::run_steps(scene, [&](const DynamicRecord& record, double t) {
        const double n = record.steps;
        const Vec2 fallen = dt * dt * n * (n + 1.0) / 2.0 * g;
        REQUIRE(largest(scene.motion.velocity.colwise() - g * t) < 1e-9 * flight.speed);
        REQUIRE(largest(scene.body.points.displacement.colwise() - fallen) < 1e-9 * flight.speed);
      });
      CHECK(scene.body.points.stress.cwiseAbs().maxCoeff() < 1e-8 * flight.speed);
    });
}

TEST_CASE("a body force per volume acts on the current volume", "[engine][dynamics]") {
  Case problem = flight(test::unit_cells(6.0), MassForm::lumped, 0.0).problem;
  problem.material.density = 4.0;
  problem.body_force = {Quantity(0.2), Quantity(Expression("0.1*t"))};
  problem.initial_velocity = test::formulas("0.1*X", "0");  // expands
  DynamicScene scene = build_dynamic_scene(problem);
  Vec2 momentum = energies(scene, 0.0).momentum;
  double volume = scene.body.points.volume.sum();
  double before = 0.0;
  test::run_steps(scene, [&](const DynamicRecord&, double t) {
    momentum += (t - before) * volume * Vec2(0.2, 0.1 * before);
    REQUIRE((energies(scene, t).momentum - momentum).norm() < 1e-12);
    volume = scene.body.points.volume.sum();
    before = t;
  });
  CHECK(volume > 1.05 * 2.1 * 2.1);
}

TEST_CASE("an impulse: a constant traction on a free body gives it the momentum F t", "[engine][dynamics]") {
  for (const auto& [name, grid] : test::every_grid(Vec2::Zero(), 6.0, 6))
    for (const MassForm mass : test::every_mass) {
      CAPTURE(name, name_of(mass));
      Case problem = test::standing_block(
          grid, {.base = Case::Free{}, .top = Case::Traction{std::array{Quantity(0.0), Quantity(1e-3)}}});
      problem.analysis = ExplicitDynamics{.end_time = 2.0, .mass = mass};
      DynamicScene scene = build_dynamic_scene(problem);
      const double dt = std::min(0.05, 0.5 * first_step(scene).critical);
      scene.settings.time_step = dt;
      scene.settings.end_time = 40.0 * dt;
      CHECK(test::worst_imbalance(scene) < 1e-10);
      CHECK_THAT(energies(scene, 0.0).momentum.y(), WithinRel(1e-3 * 2.0 * 40.0 * dt, 1e-3));  // the top narrows
    }
}

TEST_CASE("a pressure all around a body has no resultant", "[engine][dynamics]") {
  for (const auto& [name, grid] : test::every_grid(Vec2::Constant(-1.6), 3.2, 8)) {
    CAPTURE(name);
    Case problem = test::disc_case(1.0, 0.4, Case::Pressure{Quantity(0.1)});
    problem.grid = grid;
    problem.material = {.law = Case::Law::neo_hookean, .youngs_modulus = 1.0, .poissons_ratio = 0.25, .density = 1.0};
    problem.analysis = ExplicitDynamics{.safety = 0.5, .end_time = 1.0};
    DynamicScene scene = build_dynamic_scene(problem);
    test::run_steps(
        scene, [&](const DynamicRecord& record, double) { REQUIRE(record.resultants.loads.at("rim").norm() < 1e-12); });
    CHECK(energies(scene, 1.0).momentum.norm() < 1e-12);
    CHECK(scene.body.points.volume.sum() < 0.99 * scene.motion.volume.sum());
  }
}

TEST_CASE("points deform with the whole velocity gradient", "[engine][dynamics]") {
  Case::Grid one_cell = test::unit_cells(6.0);
  one_cell.cell_size = Vec2(6, 6);
  for (const Case::Law law : laws) {
    Case problem = test::free_block(one_cell, Vec2(2, 2), Vec2(4, 4), 18);
    problem.material.law = law;
    problem.material.youngs_modulus = 2e-9;  // so soft that the shear goes on as it began
    problem.material.poissons_ratio = 0.0;
    problem.initial_velocity = test::formulas("y-3", "0");
    problem.analysis = ExplicitDynamics{.time_step = 0.01, .end_time = 1.0, .mass = MassForm::consistent};
    DynamicScene scene = build_dynamic_scene(problem);
    test::run_steps(scene);
    const Eigen::Vector4d sheared(1.0, 0.0, 1.0, 1.0);  // D_xx, D_yx, D_xy, D_yy
    CHECK((scene.motion.deformation.colwise() - sheared).cwiseAbs().maxCoeff() < 1e-5);
    if (law != Case::Law::neo_hookean) continue;
    CHECK((scene.body.points.stress.colwise() - Stress(1e-9, 0.0, 1e-9, 0.0)).cwiseAbs().maxCoeff() < 1e-13);
  }
}

TEST_CASE("the volume of a point is J times that of the start", "[engine][dynamics]") {
  Case problem = flight(test::unit_cells(6.0), MassForm::lumped, 0.0).problem;
  problem.initial_velocity = test::formulas("0.4*sin(X*Y)", "0.3*cos(X)");
  DynamicScene scene = build_dynamic_scene(problem);
  test::run_steps(scene);
  for (Index p = 0; p < scene.body.points.size(); ++p) {
    const Eigen::Vector4d d = scene.motion.deformation.col(p);
    CHECK_THAT(scene.body.points.volume[p], WithinRel((d[0] * d[3] - d[1] * d[2]) * scene.motion.volume[p], 1e-13));
  }
}

TEST_CASE("energies and momentum of the points at the start", "[engine][dynamics]") {
  Case problem = test::free_block(test::unit_cells(6.0), Vec2(1, 2), Vec2(3, 4), 8);
  problem.material.density = 3.0;
  problem.gravity = Vec2(0.0, -2.0);
  problem.initial_velocity = test::formulas("0.5", "1");
  const DynamicScene scene = build_dynamic_scene(problem);
  const HistoryState at_start = energies(scene, 0.0);
  CHECK_THAT(at_start.kinetic, WithinRel(0.5 * 12.0 * 1.25, 1e-13));
  CHECK(at_start.strain == 0.0);
  CHECK_THAT(at_start.gravity, WithinRel(12.0 * 2.0 * 3.0, 1e-13));  // of the centre at height 3
  CHECK_THAT(at_start.total(), WithinRel(7.5 + 72.0, 1e-13));
  CHECK((at_start.momentum - 12.0 * Vec2(0.5, 1.0)).norm() < 1e-12);
}
