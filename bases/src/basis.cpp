#include "shoreline/bases/basis.hpp"

#include <array>

#include "shoreline/bases/counters.hpp"

namespace shoreline {

Vec2 Support::interpolate(const Eigen::Matrix2Xd& coefficient) const {
  Vec2 sum = Vec2::Zero();
  for (Eigen::Index a = 0; a < function.size(); ++a) sum += value[a] * coefficient.col(function[a]);
  return sum;
}

Mat2 Support::gradient_of(const Eigen::Matrix2Xd& coefficient) const {
  Mat2 sum = Mat2::Zero();
  for (Eigen::Index a = 0; a < function.size(); ++a) sum += coefficient.col(function[a]) * gradient.col(a).transpose();
  return sum;
}

Support Basis::support(Index cell, const Vec2& x) const {
  count(Work::evaluations);
  Support support{functions_of(cell), ShortVector(functions_per_cell()), ShortGradients(2, functions_per_cell())};
  evaluate(cell, std::span(&x, 1), support.value.data(), support.gradient.data());
  return support;
}

}  // namespace shoreline
