// The methods behind LinearSolver: band, CHOLMOD, multigrid.

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "../sparse_systems.hpp"

using namespace shoreline;
using test::random_vector;
using test::relative;
using test::sparse;

namespace {

/// A matrix over the nodes of a square grid, two unknowns each.
struct Lattice {
  Eigen::MatrixXd matrix;
  Unknowns unknowns;
};

/// Random springs between the unknowns of every cell, and from all to the ground.
Lattice lattice(test::Random& random, Index n, double ground) {
  Lattice l{ground * Eigen::MatrixXd::Identity(2 * n * n, 2 * n * n),
            {Eigen::Matrix2Xd(2, 2 * n * n), Eigen::VectorXi(2 * n * n), 4}};
  const auto equation = [n](Index i, Index j, int c) { return 2 * (j * n + i) + c; };
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      for (const int c : {0, 1}) {
        l.unknowns.place.col(equation(i, j, c)) << i, j;
        l.unknowns.component[equation(i, j, c)] = c;
      }
  for (Index j = 0; j + 1 < n; ++j)
    for (Index i = 0; i + 1 < n; ++i)
      for (int k = 0; k < 6; ++k) {
        Eigen::VectorXd pair = Eigen::VectorXd::Zero(2 * n * n);
        pair[equation(i + random.whole(0, 1), j + random.whole(0, 1), random.whole(0, 1))] += 1.0;
        pair[equation(i + random.whole(0, 1), j + random.whole(0, 1), random.whole(0, 1))] -= 1.0;
        l.matrix += random.uniform(0.1, 1.0) * pair * pair.transpose();
      }
  return l;
}

LinearSolver factorized(const Lattice& l, SolverType type) {
  LinearSolver solver;
  solver.analyse(sparse(l.matrix), l.unknowns, {.type = type});
  solver.factorize(sparse(l.matrix));
  return solver;
}

}  // namespace

TEST_CASE("every method solves the same systems", "[engine][linear_solver]") {
  test::Random random(9);
  for (int draw = 0; draw < 10; ++draw) {
    const Lattice l = lattice(random, random.whole(2, 9), 0.1);
    const Eigen::VectorXd x = random_vector(random, l.matrix.rows());
    for (const SolverType type :
         {SolverType::automatic, SolverType::band, SolverType::cholmod, SolverType::multigrid}) {
      if (type == SolverType::multigrid && !multigrid_available()) continue;
      const LinearSolver solver = factorized(l, type);
      CHECK(solver.positive_definite());
      CHECK(relative(solver.solve(l.matrix * x), x) < (type == SolverType::multigrid ? 1e-8 : 1e-13));
      CHECK(solver.use().unknowns == l.matrix.rows());
    }
    CHECK(factorized(l, SolverType::automatic).use().type == SolverType::band);
  }
}

TEST_CASE("the band is as wide as a line of the grid, along the shorter side", "[engine][linear_solver]") {
  for (const bool turned : {false, true}) {
    const Index across = 4;
    const Index along = 9;
    const Index n = 2 * across * along;
    Unknowns unknowns{Eigen::Matrix2Xd(2, n), Eigen::VectorXi(n), 4};
    for (Index e = 0; e < n; ++e) {
      const Index node = e / 2;  // numbered along the longer side
      const Eigen::Vector2d x(static_cast<double>(node % along), static_cast<double>(node / along));
      unknowns.place.col(e) = turned ? Eigen::Vector2d(x.y(), x.x()) : x;
      unknowns.component[e] = e % 2;
    }
    Eigen::MatrixXd a = 100.0 * Eigen::MatrixXd::Identity(n, n);
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j)
        if (i != j && (unknowns.place.col(i) - unknowns.place.col(j)).lpNorm<Eigen::Infinity>() < 1.5) a(i, j) = 1.0;
    LinearSolver solver;
    solver.analyse(sparse(a), unknowns, {.type = SolverType::band});
    solver.factorize(sparse(a));
    CHECK(solver.use().bytes == 8.0 * n * (2 * (across + 1) + 1 + 1));  // node (i+1, j+1), second component
  }
}

TEST_CASE("the band refuses and pivots as CHOLMOD does", "[engine][linear_solver]") {
  test::Random random(10);
  for (int draw = 0; draw < 10; ++draw) {
    Lattice l = lattice(random, random.whole(3, 7), 0.1);
    const Index loose = random.whole(0, static_cast<int>(l.matrix.rows()) - 1);
    l.matrix.row(loose).setZero();
    l.matrix.col(loose).setZero();
    l.matrix(loose, loose) = -1.0;
    const Eigen::VectorXd x = random_vector(random, l.matrix.rows());
    for (const SolverType type : {SolverType::band, SolverType::cholmod}) {
      const LinearSolver solver = factorized(l, type);
      CHECK_FALSE(solver.positive_definite());
      CHECK(solver.smallest_pivot() == 0.0);
      CHECK(solver.smallest_pivot_equation() == loose);
      CHECK(relative(solver.solve(l.matrix * x), x) < 1e-12);
    }
    l.matrix(loose, loose) = 1.0;
    const Index other = loose == 0 ? 1 : loose - 1;
    const double stiffness = l.matrix(other, other);
    l.matrix.row(other).setZero();
    l.matrix.col(other).setZero();
    l.matrix(other, other) = stiffness;
    l.matrix(loose, other) = l.matrix(other, loose) = std::sqrt(stiffness);  // one of both is loose
    for (const SolverType type : {SolverType::band, SolverType::cholmod}) try {
        static_cast<void>(factorized(l, type));
        FAIL("accepted");
      } catch (const SingularMatrix& singular) {
        CHECK((singular.equation() == loose || singular.equation() == other));
        CHECK(std::abs(singular.pivot()) < 1e-15);
      }
  }
}

TEST_CASE("the smallest pivot of a diagonal block is found by the band and by CHOLMOD", "[engine][linear_solver]") {
  test::Random random(11);
  Lattice l = lattice(random, 6, 1.0);
  for (const Index weak : {20, 21}) {
    l.matrix.row(weak).setZero();
    l.matrix.col(weak).setZero();
  }
  l.matrix(20, 20) = l.matrix(21, 21) = 1.0;
  l.matrix(20, 21) = l.matrix(21, 20) = 1.0 - 1e-6;  // pivots 1 and 2e-6
  for (const SolverType type : {SolverType::band, SolverType::cholmod}) {
    const LinearSolver solver = factorized(l, type);
    CHECK_THAT(solver.smallest_pivot(), Catch::Matchers::WithinRel(2e-6, 1e-5));
    CHECK((solver.smallest_pivot_equation() == 20 || solver.smallest_pivot_equation() == 21));
  }
}

TEST_CASE("the band does not see the threads of the BLAS, and leaves them", "[engine][linear_solver]") {
  test::Random random(12);
  const Lattice l = lattice(random, 12, 0.1);
  const Eigen::VectorXd f = random_vector(random, l.matrix.rows());
  set_blas_threads(1);
  const Eigen::VectorXd one = factorized(l, SolverType::band).solve(f);
  set_blas_threads(2);
  CHECK(factorized(l, SolverType::band).solve(f) == one);
  set_blas_threads(1);
}

TEST_CASE("multigrid serves every matrix of its pattern, and says where it does not converge",
          "[engine][linear_solver][multigrid]") {
  if (!multigrid_available()) {
    WARN("multigrid is not installed, so it is not tested");
    return;
  }
  test::Random random(13);
  const Lattice l = lattice(random, 8, 0.1);
  LinearSolver solver;
  solver.analyse(sparse(l.matrix), l.unknowns, {.type = SolverType::multigrid});
  const Eigen::VectorXd x = random_vector(random, l.matrix.rows());
  for (int draw = 0; draw < 3; ++draw) {
    Eigen::MatrixXd other = l.matrix;
    other.diagonal() += random_vector(random, l.matrix.rows()).cwiseAbs();
    solver.factorize(sparse(other));
    CHECK(relative(solver.solve(other * x), x) < 1e-8);
    CHECK(solver.use().iterations > 0);
  }
  Eigen::MatrixXd indefinite = l.matrix;
  indefinite.diagonal().array() -= 3.0;
  CHECK_THROWS_AS(
      [&] {
        solver.factorize(sparse(indefinite));
        static_cast<void>(solver.solve(x));
      }(),
      NotConverged);
}

TEST_CASE("the BLAS at work has a name", "[engine][linear_solver]") {
  set_blas_threads(1);
  CHECK_THAT(blas_name(), Catch::Matchers::Contains("OpenBLAS"));
  CHECK_FALSE(blas_at_work().reference);
}
