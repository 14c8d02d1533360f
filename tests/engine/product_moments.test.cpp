#include "../../engine/src/effects/product_moments.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "../random.hpp"
#include "shoreline/bases/bspline.hpp"

using namespace shoreline;

namespace {

struct WeightedPoints {
  std::vector<Vec2> x;
  std::vector<double> weight;
};

WeightedPoints points_in(const ProductCell& cell, int count, test::Random& random) {
  WeightedPoints points;
  for (int p = 0; p < count; ++p) {
    points.x.push_back(random.in({cell.corner, cell.corner + cell.size}));
    points.weight.push_back(random.uniform(0.1, 1.0));
  }
  return points;
}

/// The largest difference to sums point by point, per point.
double difference_of_powers(int powers, const ProductCell& cell, const WeightedPoints& points) {
  std::vector<double> sum(static_cast<std::size_t>(powers * powers), 7.0);
  power_sums(powers, cell, points.x, points.weight, sum.data());
  double largest = 0.0;
  for (int r = 0; r < powers; ++r)
    for (int s = 0; s < powers; ++s) {
      double expected = 0.0;
      for (std::size_t p = 0; p < points.x.size(); ++p) {
        const Vec2 xi = (points.x[p] - cell.corner).cwiseQuotient(cell.size) - Vec2(0.5, 0.5);
        expected += points.weight[p] * std::pow(xi.x(), r) * std::pow(xi.y(), s);
      }
      largest = std::max(largest, std::abs(sum[static_cast<std::size_t>(r * powers + s)] - expected));
    }
  return largest / static_cast<double>(points.x.size());
}

/// The largest difference to Σ V ∂φ_a ∂φ_b over the points, over the largest of these sums.
double difference_of_moments(const BSplineBasis& basis, Index number, const WeightedPoints& points, FactorPairs& x,
                             FactorPairs& y) {
  const int p = basis.degree();
  const ProductCell cell = *basis.product_cell(number);
  std::vector<double> sum(static_cast<std::size_t>((2 * p + 1) * (2 * p + 1)));
  power_sums(2 * p + 1, cell, points.x, points.weight, sum.data());
  x.make(p, cell.x, cell.size.x());
  y.make(p, cell.y, cell.size.y());
  ProductMoments moments;
  multiply(p, x, y, sum.data(), moments);

  const int n = basis.functions_per_cell();
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for (std::size_t q = 0; q < points.x.size(); ++q) {
    const ShortGradients gradient = basis.support(number, points.x[q]).gradient;
    expected += points.weight[q] * gradient.reshaped() * gradient.reshaped().transpose();
  }
  double largest = 0.0;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      const auto at = [&](int first, int second) {
        const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
        return p == 2 ? pair_places<3>()[i][j] : pair_places<4>()[i][j];
      };
      const auto same = static_cast<std::size_t>(at(a, b).same);
      for (const double d : {moments.xx[same] - expected(2 * a, 2 * b),
                             moments.xy[static_cast<std::size_t>(at(a, b).xy)] - expected(2 * a, 2 * b + 1),
                             moments.xy[static_cast<std::size_t>(at(a, b).yx)] - expected(2 * a + 1, 2 * b),
                             moments.yy[same] - expected(2 * a + 1, 2 * b + 1)})
        largest = std::max(largest, std::abs(d));
    }
  return largest / expected.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("sums of powers are those point by point, for every number of points", "[engine][stiffness]") {
  test::Random random(3);
  const BSplineBasis basis(random.grid(), 2);
  const ProductCell cell = *basis.product_cell(0);
  for (const int count : {1, 2, 3, 4, 5, 16, 31, 32, 33, 70}) {
    const WeightedPoints points = points_in(cell, count, random);
    for (const int powers : {3, 4, 5, 7}) CHECK(difference_of_powers(powers, cell, points) <= 1e-14);
  }
}

TEST_CASE("moments of products of B-splines are sums over the points, in every cell", "[engine][stiffness]") {
  test::Random random(4);
  for (const int degree : {2, 3}) {
    const BSplineBasis basis(random.grid(), degree);
    FactorPairs x, y;  // kept from cell to cell
    for (Index cell = 0; cell < basis.grid().cells(); ++cell) {
      const WeightedPoints points = points_in(*basis.product_cell(cell), 6, random);
      CHECK(difference_of_moments(basis, cell, points, x, y) <= 1e-14);
    }
  }
}
