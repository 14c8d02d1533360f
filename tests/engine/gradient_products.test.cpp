#include "../../engine/src/effects/gradient_products.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace shoreline;

namespace {

/// The largest difference to sums entry by entry over random points, per point.
template <int n>
double difference(int points, std::mt19937& draw) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<double> gradient(static_cast<std::size_t>(2 * n * points + 2));
  std::vector<double> volume(static_cast<std::size_t>(points));
  std::vector<double> factor(static_cast<std::size_t>(4 * points));
  for (std::vector<double>* list : {&gradient, &volume, &factor})
    for (double& entry : *list) entry = number(draw);
  const Eigen::Map<const Eigen::Matrix<double, 2 * n, Eigen::Dynamic>> g(gradient.data(), 2 * n, points);
  const Eigen::Map<const Eigen::VectorXd> v(volume.data(), points);
  const Eigen::Map<const Eigen::Matrix4Xd> s(factor.data(), 4, points);

  GradientMoments<n> moments = GradientMoments<n>::Constant(0.5);
  add_products(n, volume, gradient.data(), moments.data());
  const Eigen::MatrixXd expected = (g * v.asDiagonal() * g.transpose()).array() + 0.5;
  GradientSums<n> sums = GradientSums<n>::Constant(0.25);
  add_sums(n, factor, gradient.data(), sums.data());
  const Eigen::MatrixXd expected_sums = (g * s.transpose()).array() + 0.25;
  double largest = 0.0;
  for (Eigen::Index row = 0; row < 2 * n; ++row) {
    for (Eigen::Index column = 0; column <= row; ++column)
      largest = std::max(largest, std::abs(moments(row, column) - expected(row, column)));
    for (Eigen::Index k = 0; k < 4; ++k) largest = std::max(largest, std::abs(sums(row, k) - expected_sums(row, k)));
  }
  return largest / points;
}

}  // namespace

TEST_CASE("sums of products of gradients are those entry by entry, for every number of points", "[engine][stiffness]") {
  std::mt19937 draw(3);
  for (const int points : {1, 2, 3, 4, 5, 16, 33}) {
    CHECK(difference<3>(points, draw) <= 1e-14);
    CHECK(difference<4>(points, draw) <= 1e-14);
    CHECK(difference<9>(points, draw) <= 1e-14);
    CHECK(difference<16>(points, draw) <= 1e-14);
  }
}
