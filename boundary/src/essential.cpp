#include "shoreline/boundary/essential.hpp"

#include <algorithm>

namespace shoreline {

double d_function(double distance, double width) {
  const double rest = 1.0 - std::clamp(distance / width, 0.0, 1.0);
  return 1.0 - rest * rest;
}

double d_function_slope(double distance, double width) {
  if (distance < 0.0 || distance > width) return 0.0;
  return 2.0 / width * (1.0 - distance / width);
}

BandIntegrals band_integrals(EssentialMethod method, double width) {
  return {.share = method == EssentialMethod::nitsche ? 1.0 : 0.5, .penalty = 4.0 / (3.0 * width)};
}

Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2 * max_support> strain_operator(const ShortGradients& gradient) {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2 * max_support> b(3, 2 * gradient.cols());
  for (Eigen::Index a = 0; a < gradient.cols(); ++a) {
    const double gx = gradient(0, a);
    const double gy = gradient(1, a);
    b.middleCols<2>(2 * a) << gx, 0.0, 0.0, gy, gy, gx;
  }
  return b;
}

EdgeOperators edge_operators(const Support& support, const Vec2& normal, const Mat3& tangent, bool normal_only) {
  Eigen::Matrix<double, 2, 3> n;  // σ n = N · (xx, yy, xy)
  n << normal.x(), 0.0, normal.y(), 0.0, normal.y(), normal.x();
  const Mat2 p = normal_only ? Mat2(normal * normal.transpose()) : Mat2(Mat2::Identity());

  EdgeOperators operators{ShortOperator(2, 2 * support.value.size()),
                          p * n * tangent * strain_operator(support.gradient), p * n * tangent * n.transpose() * p};
  for (Eigen::Index a = 0; a < support.value.size(); ++a)
    operators.displacement.middleCols<2>(2 * a) = support.value[a] * p;
  return operators;
}

}  // namespace shoreline
