#include "shoreline/bases/quadrature.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "shoreline/bases/error.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double integral_of_power(const QuadratureRule& rule, int power) {
  return (rule.weight.array() * rule.point.array().pow(power)).sum();
}

/// What the rule with n points misses of ∫ x²ⁿ dx: (n!)⁴ / ((2n + 1) ((2n)!)²).
double first_miss(int n) {
  const double ratio = std::exp(2.0 * std::lgamma(n + 1.0) - std::lgamma(2.0 * n + 1.0));
  return ratio * ratio / (2.0 * n + 1.0);
}

}  // namespace

TEST_CASE("n Gauss points integrate polynomials of degree 2n - 1", "[bases][quadrature]") {
  for (const int n : {1, 2, 3, 4, 5, 8, 16, 33, 64}) {
    CAPTURE(n);
    const QuadratureRule rule = gauss(n);
    for (int power = 0; power < 2 * n; ++power)
      CHECK_THAT(integral_of_power(rule, power), WithinAbs(1.0 / (power + 1), 1e-14));
  }
}

TEST_CASE("n Gauss points miss degree 2n by the remainder of Gauss", "[bases][quadrature]") {
  for (const int n : {1, 2, 3, 4, 5, 6}) {
    CAPTURE(n);
    const double miss = 1.0 / (2 * n + 1) - integral_of_power(gauss(n), 2 * n);
    CHECK_THAT(miss, WithinRel(first_miss(n), 1e-6));
  }
}

TEST_CASE("Gauss points lie inside and symmetric about the middle, with positive weights that sum to 1",
          "[bases][quadrature]") {
  for (int n = 1; n <= 64; ++n) {
    CAPTURE(n);
    const QuadratureRule rule = gauss(n);
    REQUIRE(rule.point.size() == n);
    CHECK(rule.point.minCoeff() > 0.0);
    CHECK(rule.point.maxCoeff() < 1.0);
    CHECK(rule.weight.minCoeff() > 0.0);
    CHECK_THAT(rule.weight.sum(), WithinAbs(1.0, 1e-15));
    CHECK((rule.point + rule.point.reverse()).isOnes(1e-15));
    CHECK(rule.weight == Eigen::VectorXd(rule.weight.reverse()));
  }
}

TEST_CASE("a number of points that there is no rule for is named", "[bases][quadrature]") {
  for (const int n : {-1, 0, 65})
    CHECK_THROWS_WITH(gauss(n), Contains("1 to 64") && Contains("got " + std::to_string(n)));
}
