// The critical time step.

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "../../engine/src/dynamics/time_step.hpp"
#include "../moving_bodies.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// A bar of 6 x 1 cells, full of points up to @p length.
Case bar(Case::Grid grid, double length, MassForm mass) {
  grid.lower = Vec2::Zero();
  grid.upper = Vec2(6, 1);
  grid.cell_size = Vec2::Ones();
  Case problem = test::free_block(grid, Vec2::Zero(), grid.upper, 1);
  problem.material_points = test::patch_points(grid, {Vec2(0, 0), Vec2(length, 0), Vec2(length, 1), Vec2(0, 1)});
  test::settings_of(problem).mass = mass;
  return problem;
}

std::vector<test::NamedGrid> grids() {
  std::vector<test::NamedGrid> all = test::every_grid(Vec2::Zero(), 6.0, 6);
  std::erase_if(all, [](const test::NamedGrid& named) { return named.grid.mesh != nullptr; });
  return all;
}

/// 2/√λ_max of K x = λ M x, both dense and by definition.
double critical_by_eigenvalues(const DynamicScene& scene, MassForm form) {
  const Basis& basis = *scene.body.basis;
  const Grid& cells = basis.grid();
  const double e = 1.0, nu = 0.25;
  const Mat3 tangent = LinearElastic(e, nu, Plane::strain).tangent(Stress::Zero());
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(basis.functions(), basis.functions());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(2 * basis.functions(), 2 * basis.functions());
  std::vector<char> full(static_cast<std::size_t>(cells.cells() / cells.parts()), 0);
  for (Index p = 0; p < scene.body.points.size(); ++p) {
    const Vec2 x = scene.body.points.position.col(p);
    const Index cell = cells.locate(x, 0).value();
    full[static_cast<std::size_t>(cell / cells.parts())] = 1;
    const Support s = basis.support(cell, x);
    const auto strain = [&](Eigen::Index a) {
      Eigen::Matrix<double, 3, 2> b;
      b << s.gradient(0, a), 0.0, 0.0, s.gradient(1, a), s.gradient(1, a), s.gradient(0, a);
      return b;
    };
    for (Eigen::Index a = 0; a < s.value.size(); ++a)
      for (Eigen::Index b = 0; b < s.value.size(); ++b) {
        m(s.function[a], s.function[b]) += scene.motion.mass[p] * s.value[a] * s.value[b];
        k.block<2, 2>(2 * s.function[a], 2 * s.function[b]) +=
            scene.body.points.volume[p] * strain(a).transpose() * tangent * strain(b);
      }
  }
  std::vector<char> lumped(static_cast<std::size_t>(basis.functions()), form == MassForm::lumped ? 1 : 0);
  for (Index cell = 0; cell < cells.cells() && form == MassForm::partly_lumped; ++cell)
    if (full[static_cast<std::size_t>(cell / cells.parts())] == 0)
      for (const Index f : basis.functions_of(cell)) lumped[static_cast<std::size_t>(f)] = 1;
  for (Index i = 0; i < basis.functions(); ++i)
    for (Index j = 0; j < i; ++j)
      if (lumped[static_cast<std::size_t>(i)] != 0 || lumped[static_cast<std::size_t>(j)] != 0) {
        m(i, i) += m(i, j);
        m(j, j) += m(i, j);
        m(i, j) = m(j, i) = 0.0;
      }
  std::vector<Index> moving;
  for (Index f = 0; f < basis.functions(); ++f)
    if (m(f, f) > 0.0) moving.insert(moving.end(), {2 * f, 2 * f + 1});
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(2 * basis.functions(), 2 * basis.functions());
  for (Index i = 0; i < basis.functions(); ++i)
    for (Index j = 0; j < basis.functions(); ++j) both(2 * i, 2 * j) = both(2 * i + 1, 2 * j + 1) = m(i, j);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(k(moving, moving), both(moving, moving),
                                                                         Eigen::EigenvaluesOnly);
  return 2.0 / std::sqrt(solver.eigenvalues().maxCoeff());
}

/// Kinetic energy after @p steps of a given size, in parts of that of the start; from random velocities so small that
/// the body stays linear.
double growth(MassForm mass, double share_of_critical, int steps) {
  DynamicScene scene = build_dynamic_scene(bar(test::unit_cells(6.0), 6.0, mass));
  const double dt = share_of_critical * first_step(scene).critical;
  test::Random random(1);
  scene.motion.velocity = 1e-12 * random.field(scene.body.points.size());
  const double start = energies(scene, 0.0).kinetic;
  DynamicRecord record;
  TimeStep step(scene);
  for (int k = 0; k < steps; ++k) {
    step.begin(k * dt, dt, record);
    step.finish(k * dt, dt, false, record);
  }
  return energies(scene, steps * dt).kinetic / start;
}

/// Without Poisson's effect, of modulus 1 to a strain of 1e-3 and 4 beyond: the critical step falls by one half.
class Stiffening final : public LargeStrainMaterial {
 public:
  [[nodiscard]] std::string name() const override { return "stiffening"; }
  [[nodiscard]] Stress updated(const Stress&, const Mat2&, const Mat2& d) const override {
    return {of(d(0, 0) - 1.0), of(d(1, 1) - 1.0), 0.5 * of(d(0, 1) + d(1, 0)), 0.0};
  }
  [[nodiscard]] double energy(const Stress&, const Mat2&) const override { return 0.0; }
  [[nodiscard]] bool objective() const override { return false; }
  [[nodiscard]] double wave_modulus() const override { return 1.0; }

 private:
  [[nodiscard]] static double of(double strain) {
    return strain + std::copysign(3.0 * std::max(0.0, std::abs(strain) - 1e-3), strain);
  }
};

/// A bar whose halves run into each other, which strains it into the stiff range.
/// @param room  of the grid around it
DynamicScene stiffening_bar(MassForm mass, double room) {
  Case problem = bar(test::unit_cells(6.0), 6.0, mass);
  problem.initial_velocity = test::formulas("0.01*(3-x)", "0");
  problem.grid.lower = Vec2::Constant(-room);
  problem.grid.upper = Vec2(6.0 + room, 1.0 + room);
  test::settings_of(problem).end_time = 20.0;
  DynamicScene scene = build_dynamic_scene(problem);
  scene.law = std::make_shared<Stiffening>();
  return scene;
}

}  // namespace

TEST_CASE("the critical step is 2/sqrt(lambda_max) of the dense matrices", "[engine][dynamics]") {
  for (const auto& [name, grid] : grids())
    for (const auto& [mass, length] : {std::pair(MassForm::consistent, 6.0), std::pair(MassForm::lumped, 6.0),
                                       std::pair(MassForm::lumped, 4.0), std::pair(MassForm::partly_lumped, 4.0)}) {
      CAPTURE(name, name_of(mass), length);
      DynamicScene scene = build_dynamic_scene(bar(grid, length, mass));
      const double expected = critical_by_eigenvalues(scene, mass);
      CHECK_THAT(first_step(scene).critical, WithinRel(expected, 0.02));
    }
}

TEST_CASE("the first step of auto is its share of the critical one, and the Courant number that of p-waves",
          "[engine][dynamics]") {
  Case problem = bar(test::unit_cells(6.0), 6.0, MassForm::lumped);
  test::settings_of(problem).safety = 0.3;
  test::settings_of(problem).end_time = 100.0;
  DynamicScene scene = build_dynamic_scene(problem);
  const FirstStep first = first_step(scene);
  CHECK_THAT(first.dt, WithinRel(0.3 * first.critical, 1e-14));
  CHECK_THAT(first.courant, WithinRel(first.dt * std::sqrt(1.2), 1e-12));  // λ + 2μ = 1.2, ρ = h = 1
}

TEST_CASE("a given time step is made smaller so that whole steps reach the end", "[engine][dynamics]") {
  Case problem = bar(test::unit_cells(6.0), 6.0, MassForm::lumped);
  test::settings_of(problem).time_step = 0.3;
  test::settings_of(problem).end_time = 1.0;
  DynamicScene scene = build_dynamic_scene(problem);
  const DynamicRecord record = test::run_steps(scene);
  CHECK(record.steps == 4);
  CHECK(record.t == 1.0);
  CHECK_THAT(record.smallest_step, WithinRel(0.25, 1e-12));
  CHECK_THAT(record.largest_step, WithinRel(0.25, 1e-12));
}

TEST_CASE("a time step above the critical one is refused, with both", "[engine][dynamics]") {
  Case problem = bar(test::unit_cells(6.0), 6.0, MassForm::lumped);
  DynamicScene scene = build_dynamic_scene(problem);
  const double critical = first_step(scene).critical;
  scene.settings.end_time = 30.0 * critical;
  scene.settings.time_step = 1.2 * critical;
  CHECK_THROWS_WITH(first_step(scene), Contains(fmt::format("found {:.4g} s", 1.2 * critical)) &&
                                           Contains(fmt::format("expected at most {:.4g} s", critical)) &&
                                           Contains("lumped"));
  DynamicRecord record;
  CHECK_THROWS_AS(run_time_steps(scene, {}, record), InvalidArgument);
  CHECK(record.steps == 0);
  scene.settings.time_step = 0.95 * critical;
  CHECK_NOTHROW(run_time_steps(scene, {}, record));
}

TEST_CASE("below the critical step motions stay bounded, above it they grow without bound", "[engine][dynamics]") {
  CHECK(growth(MassForm::consistent, 0.95, 1000) < 20.0);
  CHECK(growth(MassForm::lumped, 0.95, 1000) < 20.0);
  CHECK(growth(MassForm::consistent, 1.1, 20) > 1e6);
}

TEST_CASE("a run whose limit falls below its step ends with step, time, point and cause", "[engine][dynamics]") {
  DynamicScene scene = stiffening_bar(MassForm::consistent, 0.0);
  const double critical = first_step(scene).critical;
  scene.settings.time_step = 0.95 * critical;
  DynamicRecord record;
  std::string message = "no error";
  try {
    run_time_steps(scene, {}, record);
  } catch (const ComputationError& error) {
    message = error.what();
  }
  CHECK_THAT(message, Contains(fmt::format("step {} (t = ", record.steps + 1)) && Contains("material point ") &&
                          Contains("is above the critical step, which has fallen from") &&
                          Contains("the fastest motion is that of the function at ") && Contains("\"partly_lumped\"") &&
                          Contains("\"auto\""));
  CHECK(record.steps > 0);
  CHECK(record.smallest_critical_step < 0.8 * critical);
}

TEST_CASE("auto follows a limit that falls", "[engine][dynamics]") {
  DynamicScene scene = stiffening_bar(MassForm::lumped, 1.0);
  scene.settings.safety = 0.3;
  const DynamicRecord record = test::run_steps(scene);
  CHECK(record.t == 20.0);
  CHECK(record.largest_step <= 0.3 * record.critical_step_at_start * (1.0 + 1e-12));
  CHECK(record.smallest_critical_step < 0.8 * record.critical_step_at_start);
  CHECK(record.smallest_step <= 0.3 * record.smallest_critical_step * (1.0 + 1e-12));
  CHECK(record.time_of_smallest > 0.0);
  CHECK(energies(scene, 20.0).kinetic < 0.01);
}
