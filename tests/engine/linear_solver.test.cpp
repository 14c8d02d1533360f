#include "shoreline/engine/linear_solver.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "../sparse_systems.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using test::random_vector;
using test::relative;
using test::sparse;

namespace {

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

LinearSolver factorized(const SparseMatrix& matrix) {
  LinearSolver solver;
  solver.analyse(matrix);
  solver.factorize(matrix);
  return solver;
}

double norm1(const Eigen::MatrixXd& matrix) { return matrix.cwiseAbs().colwise().sum().maxCoeff(); }

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
