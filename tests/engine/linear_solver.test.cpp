#include "shoreline/engine/linear_solver.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "../random.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

namespace {

/// Lower half of a dense matrix as a sparse one; entries that are zero are left out.
SparseMatrix sparse(const Eigen::MatrixXd& dense) {
  SparseMatrix matrix{.size = static_cast<Index>(dense.rows()), .column = {0}, .row = {}, .value = {}};
  for (Index j = 0; j < matrix.size; ++j) {
    for (Index i = j; i < matrix.size; ++i)
      if (i == j || dense(i, j) != 0.0) {
        matrix.row.push_back(i);
        matrix.value.push_back(dense(i, j));
      }
    matrix.column.push_back(static_cast<Index>(matrix.row.size()));
  }
  return matrix;
}

/// Springs between random pairs of n unknowns: positive definite through weak springs to the ground.
Eigen::MatrixXd springs(test::Random& random, Index n, double ground) {
  Eigen::MatrixXd matrix = ground * Eigen::MatrixXd::Identity(n, n);
  for (Index k = 0; k < 3 * n; ++k) {
    Eigen::VectorXd pair = Eigen::VectorXd::Zero(n);
    pair[random.whole(0, n - 1)] += 1.0;
    pair[random.whole(0, n - 1)] -= 1.0;
    matrix += random.uniform(0.1, 1.0) * pair * pair.transpose();
  }
  return matrix;
}

Eigen::VectorXd random_vector(test::Random& random, Eigen::Index n) {
  return Eigen::VectorXd::NullaryExpr(n, [&] { return random.uniform(-1.0, 1.0); });
}

LinearSolver factorized(const SparseMatrix& matrix) {
  LinearSolver solver;
  solver.analyse(matrix);
  solver.factorize(matrix);
  return solver;
}

double norm1(const Eigen::MatrixXd& matrix) { return matrix.cwiseAbs().colwise().sum().maxCoeff(); }

double relative(const Eigen::VectorXd& x, const Eigen::VectorXd& exact) { return (x - exact).norm() / exact.norm(); }

}  // namespace

TEST_CASE("positive definite systems are solved to rounding", "[engine][linear_solver]") {
  test::Random random(1);
  for (int draw = 0; draw < 20; ++draw) {
    const Eigen::MatrixXd a = springs(random, random.whole(1, 60), 0.1);
    const Eigen::VectorXd x = random_vector(random, a.rows());
    const LinearSolver solver = factorized(sparse(a));
    CHECK(solver.positive_definite());
    CHECK(relative(solver.solve(a * x), x) < 1e-13);
  }
}

TEST_CASE("one analysis serves every matrix of its pattern", "[engine][linear_solver]") {
  test::Random random(2);
  const Eigen::MatrixXd a = springs(random, 40, 0.1);
  LinearSolver solver;
  solver.analyse(sparse(a));
  for (int draw = 0; draw < 5; ++draw) {
    Eigen::MatrixXd other = a;
    other.diagonal() += random_vector(random, 40).cwiseAbs();
    other *= random.uniform(0.1, 10.0);
    solver.factorize(sparse(other));
    const Eigen::VectorXd x = random_vector(random, 40);
    CHECK(relative(solver.solve(other * x), x) < 1e-13);
  }
}

TEST_CASE("a badly scaled system loses no digit", "[engine][linear_solver]") {
  test::Random random(3);
  for (int draw = 0; draw < 10; ++draw) {
    const Eigen::MatrixXd a = springs(random, 40, 0.1);
    const Eigen::VectorXd scale =
        Eigen::VectorXd::NullaryExpr(40, [&] { return std::pow(10.0, random.uniform(-6.0, 6.0)); });
    const Eigen::MatrixXd bad = scale.asDiagonal() * a * scale.asDiagonal();  // diagonal from 1e-12 to 1e12
    const Eigen::VectorXd y = random_vector(random, 40);
    const Eigen::VectorXd x = factorized(sparse(bad)).solve(scale.cwiseProduct(a * y));
    CHECK(relative(scale.cwiseProduct(x), y) < 1e-12);
  }
}

TEST_CASE("an indefinite system is solved by LU, and said to be so", "[engine][linear_solver]") {
  test::Random random(4);
  for (int draw = 0; draw < 10; ++draw) {
    Eigen::MatrixXd a = springs(random, 30, 0.1);
    const Index flipped = random.whole(0, 29);
    a(flipped, flipped) -= 3.0 * a(flipped, flipped);
    LinearSolver solver = factorized(sparse(a));
    REQUIRE_FALSE(solver.positive_definite());
    CHECK((solver.smallest_pivot_equation() >= 0 && solver.smallest_pivot_equation() < 30));
    const Eigen::VectorXd x = random_vector(random, 30);
    CHECK(relative(solver.solve(a * x), x) < 1e-12);

    Eigen::MatrixXd definite = a;  // the same solver forgets the LU
    definite(flipped, flipped) *= -1.0;
    solver.factorize(sparse(definite));
    CHECK(solver.positive_definite());
    CHECK(relative(solver.solve(definite * x), x) < 1e-13);
  }
}

TEST_CASE("refinement with shifted factors solves a singular system whose right side lets it, and no other",
          "[engine][linear_solver]") {
  test::Random random(8);
  for (int draw = 0; draw < 10; ++draw) {
    const Index n = random.whole(5, 30);
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 2, n + 2);
    a.topLeftCorner(n, n) = springs(random, n, 0.1);
    a.bottomRightCorner(2, 2) << 1.0, -1.0, -1.0, 1.0;  // two unknowns that nothing holds
    LinearSolver solver;
    solver.analyse(sparse(a));
    CHECK_THROWS_AS(solver.factorize(sparse(a)), SingularMatrix);
    solver.factorize(sparse(a), 1e-9);
    CHECK(solver.positive_definite());
    Eigen::VectorXd x = random_vector(random, n + 2);
    x[n + 1] = -x[n];  // no part in the null space
    Eigen::VectorXd y = Eigen::VectorXd::Zero(n + 2);
    for (int k = 0; k < 4; ++k) y = solver.refined(a * x, y);
    CHECK(relative(y, x) < 1e-6);
    const Eigen::VectorXd pushed = a * x + Eigen::VectorXd::Unit(n + 2, n);
    const Eigen::VectorXd once = solver.refined(pushed, y);
    CHECK_THAT(solver.refined(pushed, once)[n] / once[n], WithinAbs(2.0, 1e-6));  // without end

    Eigen::MatrixXd indefinite = a;
    indefinite(0, 0) = -1.0;
    CHECK_THROWS_AS(solver.factorize(sparse(indefinite), 1e-9), SingularMatrix);
  }
}

TEST_CASE("a singular system is refused where its null space lives", "[engine][linear_solver]") {
  test::Random random(5);
  for (int draw = 0; draw < 10; ++draw) {
    const Index held = random.whole(5, 20);
    const Index loose = random.whole(2, 10);  // joined by springs among themselves alone
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(held + loose, held + loose);
    a.topLeftCorner(held, held) = springs(random, held, 0.1);
    for (Index k = held; k + 1 < held + loose; ++k) {
      a(k, k) += 1.0;
      a(k + 1, k + 1) += 1.0;
      a(k + 1, k) = a(k, k + 1) = -1.0;
    }
    try {
      static_cast<void>(factorized(sparse(a)));
      FAIL("accepted");
    } catch (const SingularMatrix& singular) {
      CHECK(singular.equation() >= held);
      CHECK(singular.equation() < held + loose);
      CHECK(std::abs(singular.pivot()) < 1e-15);
      CHECK_THAT(singular.what(), Catch::Matchers::Contains("equation " + std::to_string(singular.equation())));
    }
  }
}

TEST_CASE("an equation without stiffness, or with one that is not finite, is named", "[engine][linear_solver]") {
  for (const double diagonal : {0.0, double(NAN), double(INFINITY)}) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(5, 5);
    a(3, 3) = diagonal;
    try {
      static_cast<void>(factorized(sparse(a)));
      FAIL("accepted");
    } catch (const SingularMatrix& singular) {
      CHECK(singular.equation() == 3);
    }
  }
}

TEST_CASE("the condition estimate is the condition number of the scaled matrix, from below and within three",
          "[engine][linear_solver]") {
  test::Random random(6);
  for (int draw = 0; draw < 30; ++draw) {
    const Index n = random.whole(2, 50);
    Eigen::MatrixXd a = springs(random, n, std::pow(10.0, random.uniform(-8.0, 0.0)));
    const Eigen::VectorXd scale = random_vector(random, n);  // with signs: A⁻¹ of a constant vector is not large
    a = (scale.asDiagonal() * a * scale.asDiagonal()).eval();
    const Eigen::VectorXd unit = a.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = unit.asDiagonal() * a * unit.asDiagonal();
    const double exact = norm1(scaled) * norm1(scaled.inverse());
    const double estimate = factorized(sparse(a)).condition_estimate();
    CHECK(estimate <= 1.001 * exact);
    CHECK(estimate >= exact / 3.0);
  }
}

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
  if (!multigrid_available()) return;
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
