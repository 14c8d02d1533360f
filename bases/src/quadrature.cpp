#include "shoreline/bases/quadrature.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <string>

#include "shoreline/bases/error.hpp"

namespace shoreline {

QuadratureRule gauss(int points) {
  if (points < 1 || points > 64) throw InvalidArgument("gauss: need 1 to 64 points, got " + std::to_string(points));
  Eigen::VectorXd subdiagonal(points - 1);
  for (int k = 1; k < points; ++k) subdiagonal[k - 1] = k / std::sqrt(4.0 * k * k - 1.0);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> jacobi;
  jacobi.computeFromTridiagonal(Eigen::VectorXd::Zero(points), subdiagonal);

  QuadratureRule rule{0.5 * (jacobi.eigenvalues().array() + 1.0), jacobi.eigenvectors().row(0).array().square()};
  for (int k = 0; k < points / 2; ++k) {  // the rule is symmetric about the middle: to the last digit, too
    const double distance = 0.5 * (rule.point[points - 1 - k] - rule.point[k]);
    rule.point[k] = 0.5 - distance;
    rule.point[points - 1 - k] = 0.5 + distance;
    rule.weight[k] = rule.weight[points - 1 - k] = 0.5 * (rule.weight[k] + rule.weight[points - 1 - k]);
  }
  if (points % 2 == 1) rule.point[points / 2] = 0.5;
  rule.weight /= rule.weight.sum();
  return rule;
}

}  // namespace shoreline
