#include "shoreline/engine/assembler.hpp"

#include <omp.h>

#include <catch2/catch.hpp>

#include "../../engine/src/threads.hpp"
#include "dense_blocks.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Index functions = 15;

std::vector<Constraint> random_constraints(test::Random& random) {
  std::vector<Constraint> constraints;
  for (Index f = 0; f < functions; ++f)
    for (int component = 0; component < 2; ++component)
      if (random.uniform(0.0, 1.0) < 0.2) constraints.push_back({f, component, 0});
  return constraints;
}

/// The same, with values, and masters among the components that are free.
std::vector<Constraint> constraints_with_masters(test::Random& random) {
  std::vector<Constraint> constraints = random_constraints(random);
  std::vector<char> free(2 * functions, 1);
  for (const Constraint& c : constraints) free[static_cast<std::size_t>(2 * c.function + c.component)] = 0;
  for (Constraint& c : constraints) {
    c.value = random.uniform(-1.0, 1.0);
    for (Index k = 0; k < 2 * functions; ++k)
      if (free[static_cast<std::size_t>(k)] && random.uniform(0.0, 1.0) < 0.1)
        c.masters.push_back({k / 2, k % 2, random.uniform(-1.0, 1.0)});
  }
  return constraints;
}

/// All components from the free ones: u = T w + g, (C.4).
struct DenseConstraints {
  Eigen::MatrixXd map = Eigen::MatrixXd::Identity(2 * functions, 2 * functions);  ///< T, and zero columns
  Eigen::VectorXd value = Eigen::VectorXd::Zero(2 * functions);                   ///< g

  explicit DenseConstraints(const std::vector<Constraint>& constraints) {
    for (const Constraint& c : constraints) {
      const Index slave = 2 * c.function + c.component;
      map(slave, slave) = 0.0;
      for (const ComponentTerm& m : c.masters) map(slave, 2 * m.function + m.component) = m.coefficient;
      value[slave] = c.value;
    }
  }
};

/// Unknowns by their definition: components of functions in blocks, less constrained ones, ascending.
std::vector<Index> expected_unknowns(const ElementBlocks& blocks, const std::vector<Constraint>& constraints) {
  std::vector<char> free(2 * functions, 0);
  for (const Index f : blocks.function)
    free[2 * static_cast<std::size_t>(f)] = free[2 * static_cast<std::size_t>(f) + 1] = 1;
  for (const Constraint& c : constraints) free[static_cast<std::size_t>(2 * c.function + c.component)] = 0;
  std::vector<Index> unknowns;
  for (Index k = 0; k < 2 * functions; ++k)
    if (free[static_cast<std::size_t>(k)]) unknowns.push_back(k);
  return unknowns;
}

Eigen::MatrixXd dense(const SparseMatrix& sparse) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(sparse.size, sparse.size);
  for (Index j = 0; j < sparse.size; ++j)
    for (Index k = sparse.column[static_cast<std::size_t>(j)]; k < sparse.column[static_cast<std::size_t>(j) + 1];
         ++k) {
      const Index i = sparse.row[static_cast<std::size_t>(k)];
      matrix(i, j) = matrix(j, i) = sparse.value[static_cast<std::size_t>(k)];
    }
  return matrix;
}

}  // namespace

TEST_CASE("the assembled system is the dense one without the constrained rows", "[engine][assembler]") {
  test::Random random(1);
  for (int draw = 0; draw < 30; ++draw) {
    const ElementBlocks blocks = test::random_blocks(random, functions, 6);
    const std::vector<Constraint> constraints = random_constraints(random);
    const std::vector<Index> unknowns = expected_unknowns(blocks, constraints);
    Assembler assembler;
    CHECK_FALSE(assembler.prepare(blocks, constraints, functions));
    REQUIRE(assembler.equations() == static_cast<Index>(unknowns.size()));

    SparseMatrix matrix;
    Eigen::VectorXd force;
    assembler.assemble(blocks, matrix, force);
    const test::DenseSystem all = test::dense(blocks, functions);
    for (Index e = 0; e < assembler.equations(); ++e)
      CHECK(assembler.unknown(e) == unknowns[static_cast<std::size_t>(e)]);
    CHECK_THAT((dense(matrix) - all.matrix(unknowns, unknowns)).norm(), WithinAbs(0.0, 1e-13));
    CHECK_THAT((force - all.force(unknowns)).norm(), WithinAbs(0.0, 1e-14));
  }
}

TEST_CASE("the rows of each column ascend from the diagonal", "[engine][assembler]") {
  test::Random random(2);
  const ElementBlocks blocks = test::random_blocks(random, functions, 6);
  Assembler assembler;
  assembler.prepare(blocks, random_constraints(random), functions);
  SparseMatrix matrix;
  Eigen::VectorXd force;
  assembler.assemble(blocks, matrix, force);
  for (Index j = 0; j < matrix.size; ++j) {
    const auto begin = matrix.row.begin() + matrix.column[static_cast<std::size_t>(j)];
    const auto end = matrix.row.begin() + matrix.column[static_cast<std::size_t>(j) + 1];
    CHECK(*begin == j);
    CHECK(std::adjacent_find(begin, end, std::greater_equal<>()) == end);
  }
}

TEST_CASE("blocks over the same functions keep the pattern, others do not", "[engine][assembler]") {
  test::Random random(3);
  const ElementBlocks first = test::random_blocks(random, functions, 6);
  const std::vector<Constraint> constraints = {{2, 0, 0}, {5, 1, 0}};
  ElementBlocks second = first;
  for (double& entry : second.matrix) entry = random.uniform(-1.0, 1.0);
  Assembler assembler;
  SparseMatrix before;
  SparseMatrix after;
  Eigen::VectorXd force;
  CHECK_FALSE(assembler.prepare(first, constraints, functions));
  assembler.assemble(first, before, force);
  CHECK(assembler.prepare(second, constraints, functions));
  assembler.assemble(second, after, force);
  CHECK(after.column == before.column);
  CHECK(after.row == before.row);
  assembler.prepare(first, constraints, functions);
  assembler.assemble(first, after, force);
  CHECK(after.value == before.value);

  CHECK_FALSE(assembler.prepare(first, {{2, 0, 0}, {5, 0, 0}}, functions));
  ElementBlocks others = first;  // as many functions in each block
  for (Index& f : others.function) f = functions - 1 - f;
  CHECK_FALSE(assembler.prepare(others, {{2, 0, 0}, {5, 0, 0}}, functions));
  CHECK_FALSE(assembler.prepare(test::random_blocks(random, functions, 6), {{2, 0, 0}, {5, 0, 0}}, functions));
}

TEST_CASE("sums do not depend on the number of threads, to the last digit", "[engine][assembler]") {
  test::Random random(4);
  const ElementBlocks blocks = test::random_blocks(random, functions, 5000);
  REQUIRE(worth_threads(blocks.matrix.size()));
  Assembler assembler;
  assembler.prepare(blocks, {{3, 1, 0}, {5, 0, 0, 0.2, {{6, 0, 0.3}, {6, 1, -0.7}}}}, functions);
  const int threads_before = omp_get_max_threads();
  SparseMatrix serial;
  SparseMatrix parallel;
  Eigen::VectorXd serial_force;
  Eigen::VectorXd force;
  omp_set_num_threads(1);
  assembler.assemble(blocks, serial, serial_force);
  for (const int threads : {2, 3}) {
    omp_set_num_threads(threads);
    assembler.assemble(blocks, parallel, force);
    CHECK(parallel.value == serial.value);
    CHECK(force == serial_force);
  }
  omp_set_num_threads(threads_before);
}

TEST_CASE("a solution expands to its functions and zero elsewhere, reactions close the equilibrium",
          "[engine][assembler]") {
  test::Random random(5);
  for (int draw = 0; draw < 20; ++draw) {
    const ElementBlocks blocks = test::random_blocks(random, functions, 6);
    const std::vector<Constraint> constraints = random_constraints(random);
    const std::vector<Index> unknowns = expected_unknowns(blocks, constraints);
    Assembler assembler;
    assembler.prepare(blocks, constraints, functions);
    const Eigen::VectorXd solution =
        Eigen::VectorXd::NullaryExpr(assembler.equations(), [&] { return random.uniform(-1.0, 1.0); });
    const Eigen::Matrix2Xd increment = assembler.expand(solution);
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(2 * functions);
    expected(unknowns) = solution;
    CHECK(increment.reshaped() == expected);

    const test::DenseSystem all = test::dense(blocks, functions);
    const Eigen::VectorXd residual = all.matrix * expected - all.force;
    const Eigen::Matrix2Xd reactions = assembler.reactions(blocks, increment);
    for (const Constraint& c : constraints)
      CHECK_THAT(reactions(c.component, c.function), WithinAbs(residual[2 * c.function + c.component], 1e-13));
  }
}

TEST_CASE("prescribed values move to the right-hand side and come back in the increment", "[engine][assembler]") {
  test::Random random(6);
  for (int draw = 0; draw < 20; ++draw) {
    const ElementBlocks blocks = test::random_blocks(random, functions, 6);
    std::vector<Constraint> constraints = random_constraints(random);
    for (Constraint& c : constraints) c.value = random.uniform(-1.0, 1.0);
    const std::vector<Index> unknowns = expected_unknowns(blocks, constraints);
    Assembler assembler;
    assembler.prepare(blocks, constraints, functions);
    SparseMatrix matrix;
    Eigen::VectorXd force;
    assembler.assemble(blocks, matrix, force);
    Eigen::VectorXd prescribed = Eigen::VectorXd::Zero(2 * functions);
    for (const Constraint& c : constraints) prescribed[2 * c.function + c.component] = c.value;
    const test::DenseSystem all = test::dense(blocks, functions);
    const Eigen::VectorXd expected = all.force - all.matrix * prescribed;
    CHECK_THAT((force - expected(unknowns)).norm(), WithinAbs(0.0, 1e-13));
    CHECK(assembler.expand(Eigen::VectorXd::Zero(assembler.equations())).reshaped() == prescribed);
  }
}

TEST_CASE("with masters the system is that of the free components, and expands to all", "[engine][assembler]") {
  test::Random random(7);
  for (int draw = 0; draw < 30; ++draw) {
    const ElementBlocks blocks = test::random_blocks(random, functions, 6);
    const std::vector<Constraint> constraints = constraints_with_masters(random);
    const DenseConstraints all(constraints);
    Assembler assembler;
    assembler.prepare(blocks, constraints, functions);
    SparseMatrix matrix;
    Eigen::VectorXd force;
    assembler.assemble(blocks, matrix, force);
    const test::DenseSystem system = test::dense(blocks, functions);
    const Eigen::MatrixXd expected = all.map.transpose() * system.matrix * all.map;
    const Eigen::VectorXd expected_force = all.map.transpose() * (system.force - system.matrix * all.value);
    std::vector<Index> unknowns;
    for (Index e = 0; e < assembler.equations(); ++e) unknowns.push_back(assembler.unknown(e));
    CHECK_THAT((dense(matrix) - expected(unknowns, unknowns)).norm(), WithinAbs(0.0, 1e-12));
    CHECK_THAT((force - expected_force(unknowns)).norm(), WithinAbs(0.0, 1e-12));
    CHECK_THAT(expected.norm() - Eigen::MatrixXd(expected(unknowns, unknowns)).norm(), WithinAbs(0.0, 1e-12));

    const Eigen::VectorXd solution =
        Eigen::VectorXd::NullaryExpr(assembler.equations(), [&] { return random.uniform(-1.0, 1.0); });
    Eigen::VectorXd free = Eigen::VectorXd::Zero(2 * functions);
    free(unknowns) = solution;
    const Eigen::VectorXd expanded = all.map * free + all.value;
    CHECK_THAT((assembler.expand(solution).reshaped() - expanded).norm(), WithinAbs(0.0, 1e-13));
  }
}

TEST_CASE("a pattern holds while masters and coefficients stay, whatever the values", "[engine][assembler]") {
  test::Random random(8);
  const ElementBlocks blocks = test::random_blocks(random, functions, 6);
  const Index f = blocks.function[0];
  const Index other = (f + 1) % functions;
  Assembler assembler;
  CHECK_FALSE(assembler.prepare(blocks, {{f, 0, 0, 1.0, {{other, 0, 0.5}}}}, functions));
  CHECK(assembler.prepare(blocks, {{f, 0, 0, 2.0, {{other, 0, 0.5}}}}, functions));
  CHECK_FALSE(assembler.prepare(blocks, {{f, 0, 0, 2.0, {{other, 0, 0.6}}}}, functions));
  CHECK_FALSE(assembler.prepare(blocks, {{f, 0, 0, 2.0, {{other, 1, 0.6}}}}, functions));
  CHECK_FALSE(assembler.prepare(blocks, {{f, 0, 0, 2.0}}, functions));
}
