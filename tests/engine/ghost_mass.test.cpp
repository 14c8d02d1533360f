// The ghost mass, engine/src/dynamics/ghost_mass.hpp.

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <set>

#include "../../engine/src/dynamics/mass_matrix.hpp"
#include "../moving_bodies.hpp"
#include "shoreline/bases/projection.hpp"

using namespace shoreline;

namespace {

std::vector<char> all_active(const Basis& basis) {
  return std::vector<char>(static_cast<std::size_t>(basis.grid().cells()), 1);
}

/// A field of a basis nearest to a function, (functions).
template <class F>
Eigen::VectorXd nearest(const Basis& basis, F&& f) {
  const WeightedPoints points = integration_points(basis.grid(), 2 * basis.degree() + 2);
  Eigen::MatrixXd value(static_cast<Eigen::Index>(points.x.size()), 1);
  for (std::size_t k = 0; k < points.x.size(); ++k) value(static_cast<Eigen::Index>(k), 0) = f(points.x[k]);
  return project(basis, points, value, Mass::consistent).col(0);
}

Eigen::MatrixXd ghost(const Basis& basis, double gamma, double density) {
  GhostMass mass(gamma, density);
  mass.find(basis, all_active(basis));
  return mass.matrix();
}

/// A block of which the top row of elements holds a sliver alone.
Case sliver_case(Case::Grid grid, double unit, double modulus, double density) {
  Case problem = test::free_block(grid, Vec2(1.0, 1.0) * unit, Vec2(3.0, 3.02) * unit, 24);
  problem.material.youngs_modulus = modulus;
  problem.material.density = density;
  problem.gravity = Vec2(0.0, -0.01 * modulus / (density * unit));
  ExplicitDynamics& settings = test::settings_of(problem);
  settings.mass = MassForm::consistent;
  settings.ghost = 1e-2;
  settings.pic = 1.0;
  settings.end_time = 0.05 * unit * std::sqrt(density / modulus);
  settings.time_step = settings.end_time / 10.0;
  return problem;
}

}  // namespace

TEST_CASE("a ghost mass does not see polynomials of the basis, and no rigid motion", "[engine][ghost_mass]") {
  for (const auto& [name, grid] : test::every_grid(Vec2::Zero(), 1.0, 4)) {
    CAPTURE(name);
    const std::unique_ptr<const Basis> basis = test::basis_of(grid);
    const Eigen::MatrixXd mass = ghost(*basis, 1e-3, 2.0);
    const double size = mass.cwiseAbs().maxCoeff();
    REQUIRE(size > 0.0);
    CHECK(mass.rowwise().sum().cwiseAbs().maxCoeff() < 1e-12 * size);
    CHECK((mass - mass.transpose()).cwiseAbs().maxCoeff() < 1e-14 * size);
    const int p = basis->degree();
    const Eigen::VectorXd power = nearest(*basis, [p](const Vec2& x) { return std::pow(x.x() - 2.0 * x.y(), p); });
    CHECK((mass * power).cwiseAbs().maxCoeff() < 1e-9 * size * power.cwiseAbs().maxCoeff());
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(mass).eigenvalues();
    CHECK(eigenvalues.minCoeff() > -1e-12 * size);
    CHECK(eigenvalues.maxCoeff() > 1e-3 * size);
  }
}

TEST_CASE("a ghost mass is to the mass what it was in other units and on finer grids", "[engine][ghost_mass]") {
  const auto coarse = test::every_grid(Vec2::Zero(), 1.0, 4);
  const auto scaled = test::every_grid(Vec2::Zero(), 1.0 / 1024.0, 4);
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    CAPTURE(coarse[k].name);
    const Eigen::MatrixXd here = ghost(*test::basis_of(coarse[k].grid), 1e-2, 1.0);
    const Eigen::MatrixXd there = ghost(*test::basis_of(scaled[k].grid), 1e-2, 2700.0);
    CHECK((there - 2700.0 / (1024.0 * 1024.0) * here).norm() < 1e-8 * there.norm());  // the mass of an element is ρ h²
  }
}

TEST_CASE("units of length, mass and time leave the steps of a body with a sliver as they are",
          "[engine][ghost_mass]") {
  for (std::size_t k = 0; k < test::every_grid(Vec2::Zero(), 4.0, 4).size(); ++k) {
    DynamicRecord record[2];
    std::string name;
    for (const int other : {0, 1}) {
      const double unit = other == 0 ? 1.0 : 64.0, modulus = other == 0 ? 1.0 : 32768.0,
                   density = other == 0 ? 1.0 : 8.0;
      const auto named = test::every_grid(Vec2::Zero(), 4.0 * unit, 4)[k];
      name = named.name;
      DynamicScene scene = build_dynamic_scene(sliver_case(named.grid, unit, modulus, density));
      run_time_steps(scene, {}, record[other]);
    }
    CAPTURE(name);
    // all units are powers of two, and that of time is 64 √(8/32768) s = 1 s: rounding is the same
    CHECK(record[0].steps == 10);
    CHECK(record[1].steps == 10);
    CHECK(record[1].mass_iterations == record[0].mass_iterations);
    CHECK_THAT(record[1].critical_step_at_start, Catch::Matchers::WithinRel(record[0].critical_step_at_start, 1e-9));
  }
}

TEST_CASE("with a ghost mass momentum changes by what gravity gives, on every basis", "[engine][ghost_mass]") {
  for (const auto& [name, grid] : test::every_grid(Vec2::Zero(), 4.0, 4)) {
    CAPTURE(name);
    DynamicScene scene = build_dynamic_scene(sliver_case(grid, 1.0, 1.0, 1.0));
    CHECK(test::worst_imbalance(scene) < 1e-12);
  }
}

TEST_CASE("without the key no ghost mass is made, and no weights are fitted", "[engine][ghost_mass]") {
  Case problem = sliver_case(test::unit_cells(4.0), 1.0, 1.0, 1.0);
  const auto phases = [&] {
    DynamicScene scene = build_dynamic_scene(problem);
    DynamicRecord record;
    run_time_steps(scene, {}, record);
    std::set<std::string> names;
    for (const Clock::Entry& entry : record.phases.entries()) names.insert(entry.name);
    CHECK(!record.weights);
    return names;
  };
  CHECK(phases().contains("ghost_mass"));
  test::settings_of(problem).ghost = 0.0;
  test::settings_of(problem).mass = MassForm::lumped;
  CHECK(!phases().contains("ghost_mass"));
  CHECK(!phases().contains("weights"));
}
