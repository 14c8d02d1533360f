#include "shoreline/boundary/fitted_weights.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "../random.hpp"
#include "shoreline/bases/quadrature.hpp"
#include "shoreline/boundary/body_moments.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

namespace {

Eigen::VectorXd powers(const Vec2& x, int order) {
  Eigen::VectorXd m(monomials(order));
  for (int degree = 0, k = 0; degree <= order; ++degree)
    for (int b = 0; b <= degree; ++b, ++k) m[k] = std::pow(x.x(), degree - b) * std::pow(x.y(), b);
  return m;
}

/// Moments of the square [−s/2, s/2]² less what lies right of a slanted line, x > cut + 0.3 y, by Gauss quadrature.
Eigen::VectorXd cut_square(double s, double cut, int order) {
  const QuadratureRule rule = gauss(8);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(monomials(order));
  for (Eigen::Index j = 0; j < 8; ++j) {
    const double y = s * (rule.point[j] - 0.5);
    const double width = std::clamp(cut + 0.3 * y + 0.5 * s, 0.0, s);
    for (Eigen::Index i = 0; i < 8; ++i)
      sum += rule.weight[i] * rule.weight[j] * s * width * powers({width * rule.point[i] - 0.5 * s, y}, order);
  }
  return sum;
}

/// A lattice of n² points of that part, each with an equal share of the square.
std::pair<Eigen::Matrix2Xd, Eigen::VectorXd> lattice(double s, double cut, int n) {
  std::vector<Vec2> inside;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (const Vec2 x = s * (Vec2(i + 0.5, j + 0.5) / n - Vec2(0.5, 0.5)); x.x() < cut + 0.3 * x.y())
        inside.push_back(x);
  Eigen::Matrix2Xd x(2, static_cast<Eigen::Index>(inside.size()));
  for (std::size_t p = 0; p < inside.size(); ++p) x.col(static_cast<Eigen::Index>(p)) = inside[p];
  return {x, Eigen::VectorXd::Constant(x.cols(), s * s / (n * n))};
}

Eigen::VectorXd moments_of(const Eigen::Matrix2Xd& x, const Eigen::VectorXd& weight, int order) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(monomials(order));
  for (Eigen::Index p = 0; p < x.cols(); ++p) sum += weight[p] * powers(x.col(p), order);
  return sum;
}

}  // namespace

TEST_CASE("fitted weights reproduce the moments of a cut cell, and none falls below its bound",
          "[boundary][fitted_weights]") {
  const double s = GENERATE(1.0, 1e-3, 1e4);
  const int order = GENERATE(0, 1, 2, 4, 6);
  for (const double cut : {0.36, 0.1, 0.0}) {
    CAPTURE(s, order, cut);
    const Eigen::VectorXd moments = cut_square(s, cut * s, order);
    auto [x, weight] = lattice(s, cut * s, 16);
    const Eigen::VectorXd plain = weight;
    CHECK(fit_weights(x, s, moments, weight) == order);
    const Eigen::VectorXd found = moments_of(x, weight, order);
    for (int degree = 0, k = 0; degree <= order; ++degree)
      for (int b = 0; b <= degree; ++b, ++k)
        CHECK_THAT(found[k], WithinAbs(moments[k], 1e-8 * moments[0] * std::pow(s, degree)));
    CHECK((weight.array() >= 0.049 * plain.array()).all());
  }
}

TEST_CASE("of all weights with these moments the fitted ones differ least from the plain ones",
          "[boundary][fitted_weights]") {
  auto [x, weight] = lattice(1.0, 0.2, 7);
  const Eigen::VectorXd moments = cut_square(1.0, 0.2, 2);
  const double scale = moments[0] / weight.sum();
  const Eigen::VectorXd plain = scale * weight;
  fit_weights(x, 1.0, moments, weight);
  const auto change = [&](const Eigen::VectorXd& w) { return (w - plain).cwiseAbs2().cwiseQuotient(plain).sum(); };
  Eigen::MatrixXd rows(monomials(2), x.cols());
  for (Eigen::Index p = 0; p < x.cols(); ++p) rows.col(p) = powers(x.col(p), 2);
  const Eigen::MatrixXd kernel = rows.fullPivLu().kernel();
  test::Random random(3);
  for (int draw = 0; draw < 50; ++draw) {
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(x.cols());
    for (Eigen::Index k = 0; k < kernel.cols(); ++k) direction += random.uniform(-1.0, 1.0) * kernel.col(k);
    CHECK(change(weight + 1e-3 * weight.minCoeff() / direction.cwiseAbs().maxCoeff() * direction) > change(weight));
  }
}

TEST_CASE("Gauss points keep their weights", "[boundary][fitted_weights]") {
  const QuadratureRule rule = gauss(3);
  Eigen::Matrix2Xd x(2, 9);
  Eigen::VectorXd weight(9);
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j) {
      x.col(3 * i + j) << rule.point[i] - 0.5, rule.point[j] - 0.5;
      weight[3 * i + j] = rule.weight[i] * rule.weight[j];
    }
  const Eigen::VectorXd plain = weight;
  CHECK(fit_weights(x, 1.0, cut_square(1.0, 2.0, 4), weight) == 4);
  CHECK((weight - plain).norm() < 1e-13);
}

TEST_CASE("where no weights above the bound have the moments, those of a lower order are met, the area always",
          "[boundary][fitted_weights]") {
  Eigen::Matrix2Xd x(2, 12);
  for (int p = 0; p < 12; ++p) x.col(p) << -0.4 + 0.01 * p, 0.03 * (p % 3);  // all left of the centroid
  Eigen::VectorXd weight = Eigen::VectorXd::Constant(12, 0.1);
  CHECK(fit_weights(x, 1.0, cut_square(1.0, 2.0, 2), weight) == 0);
  CHECK((weight - Eigen::VectorXd::Constant(12, 1.0 / 12.0)).norm() < 1e-14);

  auto [strip, strip_weight] = lattice(1.0, -0.2, 16);  // too narrow for its points
  const Eigen::VectorXd moments = cut_square(1.0, -0.2, 6);
  const int order = fit_weights(strip, 1.0, moments, strip_weight);
  CHECK(order < 6);
  CHECK(order >= 1);
  const Eigen::VectorXd rest = moments_of(strip, strip_weight, order) - moments.head(monomials(order));
  CHECK(rest.cwiseAbs().maxCoeff() < 1e-8 * moments[0]);
}

TEST_CASE("the order falls to that for which there are 1.5 points a moment, or which the plain weights meet",
          "[boundary][fitted_weights]") {
  const auto order = [](int n) {
    auto [x, weight] = lattice(1.0, 2.0, n);
    return fit_weights(x, 1.0, cut_square(1.0, 2.0, 4), weight);
  };
  CHECK(order(1) == 1);  // at the centroid
  CHECK(order(2) == 1);
  CHECK(order(3) == 2);
  CHECK(order(4) == 3);
  CHECK(order(5) == 4);
}

TEST_CASE("can_meet says whether the fit meets all moments", "[boundary][fitted_weights]") {
  for (const double cut : {2.0, 0.36, 0.1, -0.2, -0.35})
    for (const int order : {1, 2, 4, 6})
      for (const int n : {4, 7, 16}) {
        auto [x, weight] = lattice(1.0, cut, n);
        if (x.cols() == 0) continue;
        CAPTURE(cut, order, n);
        const Eigen::VectorXd moments = cut_square(1.0, cut, order);
        const bool met = can_meet(x, 1.0, moments, weight);
        CHECK(met == (fit_weights(x, 1.0, moments, weight) == order));
      }
}

TEST_CASE("of a sliver no more is asked than its moments know beyond rounding", "[boundary][fitted_weights]") {
  constexpr double noise = 1e-13;  // of the cell, in its moments: rounding where coordinates are some hundred cells
  constexpr int order = 4;
  const QuadratureRule rule = gauss(6);
  test::Random random(5);
  for (const double size : {0.1, 0.03, 0.01, 3e-3, 1e-3}) {  // of the triangle ξ + η < size − 1 in a corner of the cell
    Eigen::VectorXd moments = Eigen::VectorXd::Zero(monomials(order));
    for (Eigen::Index i = 0; i < 6; ++i)
      for (Eigen::Index j = 0; j < 6; ++j) {
        const Vec2 at(size * rule.point[i], size * (1.0 - rule.point[i]) * rule.point[j]);
        const double weight = rule.weight[i] * rule.weight[j] * size * size * (1.0 - rule.point[i]);
        moments += weight * powers(at - Vec2(0.5, 0.5), order);
      }
    for (double& m : moments) m += random.uniform(-noise, noise);
    Eigen::Matrix2Xd x(2, 78);
    for (Eigen::Index i = 0, p = 0; i < 12; ++i)
      for (Eigen::Index j = 0; j < 12 - i; ++j, ++p)
        x.col(p) = size / 12.5 * Vec2(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5) - Vec2(0.5, 0.5);
    Eigen::VectorXd weight = Eigen::VectorXd::Ones(78);
    CAPTURE(size);
    CHECK(fit_weights(x, 1.0, moments, weight) == order);
    CHECK((moments_of(x, weight, order) - moments).cwiseAbs().maxCoeff() < 1e-9 * moments[0] + 1e-12);
  }
}
