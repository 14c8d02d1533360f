// The forms of the mass matrix.

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "../../engine/src/dynamics/mass_matrix.hpp"
#include "../moving_bodies.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// The mass of points on a grid, by definition and as a MassMatrix.
struct Masses {
  explicit Masses(const Case::Grid& grid, const std::vector<Case::ListedPoint>& points)
      : basis(test::basis_of(grid)),
        table(*basis),
        consistent(Eigen::MatrixXd::Zero(basis->functions(), basis->functions())),
        sees_empty(at(basis->functions()), 0) {
    const Grid& cells = basis->grid();
    std::vector<char> full(at(cells.cells() / cells.parts()), 0);
    std::vector<Index> occupied_cells;
    for (const Case::ListedPoint& p : points) {
      const Index cell = cells.locate(p.position, 0).value();
      full[at(cell / cells.parts())] = 1;
      occupied_cells.push_back(cell);
      const Support s = basis->support(cell, p.position);
      for (Eigen::Index a = 0; a < s.value.size(); ++a)
        for (Eigen::Index b = 0; b < s.value.size(); ++b)
          consistent(s.function[a], s.function[b]) += p.volume * s.value[a] * s.value[b];
    }
    for (Index cell = 0; cell < cells.cells(); ++cell)
      if (full[at(cell / cells.parts())] == 0)
        for (const Index f : basis->functions_of(cell)) sees_empty[at(f)] = 1;
    std::ranges::sort(occupied_cells);
    occupied_cells.erase(std::unique(occupied_cells.begin(), occupied_cells.end()), occupied_cells.end());
    occupied.find(table, occupied_cells);
    fill_blocks(points);
  }

  /// All columns of a form of the matrix.
  [[nodiscard]] Eigen::MatrixXd dense(MassForm form) const {
    MassMatrix mass(table, form);
    mass.assemble(occupied, consistent.rowwise().sum(), blocks);
    Eigen::MatrixXd all(consistent.rows(), consistent.cols());
    for (Index f = 0; f < basis->functions(); ++f) {
      Eigen::Matrix2Xd unit = Eigen::Matrix2Xd::Zero(2, basis->functions());
      unit.col(f) = Vec2(1.0, 2.0);
      const Eigen::Matrix2Xd& column = mass.times(unit);
      CHECK(column.row(1) == 2.0 * column.row(0));
      all.col(f) = column.row(0);
    }
    return all;
  }

  std::unique_ptr<const Basis> basis;
  ElementTable table;
  OccupiedElements occupied;
  std::vector<double> blocks;
  Eigen::MatrixXd consistent;
  std::vector<char> sees_empty;

 private:
  void fill_blocks(const std::vector<Case::ListedPoint>& points) {
    const auto n = static_cast<std::size_t>(table.n);
    blocks.assign(occupied.element.size() * n * n, 0.0);
    for (const Case::ListedPoint& p : points) {
      const Index cell = basis->grid().locate(p.position, 0).value();
      const Support s = basis->support(cell, p.position);
      double* const block = &blocks[at(occupied.number[at(cell / table.parts)]) * n * n];
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b)
          block[table.place_of(cell)[a] * n + table.place_of(cell)[b]] +=
              p.volume * s.value[static_cast<Eigen::Index>(a)] * s.value[static_cast<Eigen::Index>(b)];
    }
  }
};

/// A turned square on a grid of side 4, with empty elements around.
Masses turned_body(const Case::Grid& grid) {
  return Masses(grid, test::patch_points(grid, {Vec2(2.1, 0.6), Vec2(3.3, 1.9), Vec2(1.9, 3.2), Vec2(0.7, 2.0)}));
}

std::vector<test::NamedGrid> grids() { return test::every_grid(Vec2::Zero(), 4.0, 5); }

}  // namespace

TEST_CASE("the consistent mass is the sum over the points of m phi_i phi_j, the lumped one its row sums",
          "[engine][dynamics]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Masses body = turned_body(grid);
    const double size = body.consistent.norm();
    CHECK((body.dense(MassForm::consistent) - body.consistent).norm() <= 1e-14 * size);
    const Eigen::MatrixXd lumped = body.consistent.rowwise().sum().asDiagonal();
    CHECK((body.dense(MassForm::lumped) - lumped).norm() <= 1e-14 * size);
  }
}

TEST_CASE("the partly lumped mass is symmetric, with the row sums of the consistent one, and definite where it is",
          "[engine][dynamics]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Masses body = turned_body(grid);
    const Eigen::MatrixXd m = body.dense(MassForm::partly_lumped);
    const double size = body.consistent.norm();
    CHECK((m - m.transpose()).norm() <= 1e-15 * size);
    CHECK((m.rowwise().sum() - body.consistent.rowwise().sum()).norm() <= 1e-14 * size);
    CHECK(m.diagonal().minCoeff() >= 0.0);
    CHECK(m.minCoeff() >= 0.0);  // functions here are not negative
    const auto lowest = [](const Eigen::MatrixXd& of) {
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(of).eigenvalues().minCoeff();
    };
    CHECK(lowest(m) >= -1e-14 * size);
    // x' (M_partly - M) x is a sum of M_ij (x_i - x_j)^2
    CHECK(lowest(m - body.consistent) >= -1e-14 * size);
  }
}

TEST_CASE("only functions that see an empty element are lumped, with all that couples to them", "[engine][dynamics]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Masses body = turned_body(grid);
    const Eigen::MatrixXd m = body.dense(MassForm::partly_lumped);
    MassMatrix mass(body.table, MassForm::partly_lumped);
    mass.assemble(body.occupied, body.consistent.rowwise().sum(), body.blocks);
    for (Index i = 0; i < body.basis->functions(); ++i) {
      CHECK(mass.lumped(i) == (body.sees_empty[at(i)] != 0));
      for (Index j = 0; j < body.basis->functions(); ++j) {
        if (i == j) continue;
        const bool moved = body.sees_empty[at(i)] != 0 || body.sees_empty[at(j)] != 0;
        const double expected = moved ? 0.0 : body.consistent(i, j);
        REQUIRE(std::abs(m(i, j) - expected) <= 1e-15 * body.consistent.norm());
      }
    }
  }
}

TEST_CASE("where no element is empty the partly lumped mass is the consistent one", "[engine][dynamics]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Masses body(grid, test::patch_points(grid, {Vec2(0, 0), Vec2(4, 0), Vec2(4, 4), Vec2(0, 4)}));
    CHECK((body.dense(MassForm::partly_lumped) - body.consistent).norm() <= 1e-14 * body.consistent.norm());
  }
}

TEST_CASE("a field that the mass gives back has the held components and solves for the others", "[engine][dynamics]") {
  test::Random random(3);
  for (const auto& [name, grid] : grids())
    for (const MassForm form : test::every_mass) {
      CAPTURE(name, name_of(form));
      const Masses body(grid, test::patch_points(grid, {Vec2(0, 0), Vec2(4, 0), Vec2(4, 4), Vec2(0, 4)}));
      const Index functions = body.basis->functions();
      MassMatrix mass(body.table, form);
      mass.assemble(body.occupied, body.consistent.rowwise().sum(), body.blocks);
      // one component held at a value, one that follows two others
      const HeldComponents held(
          {{.function = 1, .component = 0, .piece = 0, .value = 0.7},
           {.function = 3, .component = 1, .piece = 0, .value = -0.2, .masters = {{4, 1, 0.5}, {5, 0, -1.5}}}});
      const Eigen::Matrix2Xd force = random.field(functions);
      Eigen::Matrix2Xd x = random.field(functions);
      mass.solve(held, force, x, 1e-13);
      CHECK(x(0, 1) == 0.7);
      CHECK(std::abs(x(1, 3) - (-0.2 + 0.5 * x(1, 4) - 1.5 * x(0, 5))) <= 1e-14 * x.norm());
      Eigen::Matrix2Xd rest = mass.times(x) - force;
      rest(1, 4) += 0.5 * rest(1, 3);
      rest(0, 5) -= 1.5 * rest(1, 3);
      rest(0, 1) = rest(1, 3) = 0.0;
      CHECK(rest.norm() <= 1e-11 * force.norm());
    }
}

TEST_CASE("what the partly lumped mass has on its diagonal alone is solved by division, however coarse the tolerance",
          "[engine][dynamics]") {
  test::Random random(7);
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Masses body = turned_body(grid);
    MassMatrix mass(body.table, MassForm::partly_lumped);
    mass.assemble(body.occupied, body.consistent.rowwise().sum(), body.blocks);
    const Eigen::Matrix2Xd field = random.field(body.basis->functions());
    const Eigen::Matrix2Xd force = mass.times(field);
    Eigen::Matrix2Xd x = Eigen::Matrix2Xd::Zero(2, body.basis->functions());
    mass.solve(HeldComponents(), force, x, 0.1);
    for (Index f = 0; f < body.basis->functions(); ++f)
      if (mass.lumped(f) && mass.row_sum()[f] > 0.0) CHECK((x.col(f) - field.col(f)).norm() <= 1e-13);
  }
}

TEST_CASE("functions without mass stay at zero, and a singular mass is told", "[engine][dynamics]") {
  const Case::Grid grid = test::unit_cells(4.0);
  const Masses body(grid, {{Vec2(1.3, 1.4), 1.0}, {Vec2(1.6, 1.5), 1.0}});  // two points for four nodes
  for (const MassForm form : test::every_mass) {
    MassMatrix mass(body.table, form);
    mass.assemble(body.occupied, body.consistent.rowwise().sum(), body.blocks);
    Eigen::Matrix2Xd x = Eigen::Matrix2Xd::Ones(2, body.basis->functions());
    const Eigen::Matrix2Xd force = Eigen::Matrix2Xd::Ones(2, body.basis->functions());
    if (form == MassForm::consistent) {
      CHECK_THROWS_AS(mass.solve(HeldComponents(), force, x, 1e-13), ComputationError);
      continue;
    }
    mass.solve(HeldComponents(), body.consistent.rowwise().sum().transpose().replicate(2, 1), x, 1e-13);
    for (Index f = 0; f < body.basis->functions(); ++f)
      CHECK(x.col(f) == Vec2::Constant(body.consistent.row(f).sum() > 0.0 ? 1.0 : 0.0));
  }
}
