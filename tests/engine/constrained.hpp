#pragma once
// What constraints say of the coefficients of a field.

#include <Eigen/Dense>

#include "shoreline/engine/assembler.hpp"

namespace shoreline::test {

/// Coefficients with the constrained components as the others give them.
inline Eigen::Matrix2Xd constrained(Eigen::Matrix2Xd coefficient, const std::vector<Constraint>& constraints) {
  for (const Constraint& c : constraints) {
    double value = c.value;
    for (const ComponentTerm& m : c.masters) value += m.coefficient * coefficient(m.component, m.function);
    coefficient(c.component, c.function) = value;
  }
  return coefficient;
}

inline Eigen::Index rank(const Eigen::MatrixXd& matrix) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(matrix);
  factors.setThreshold(1e-9);
  return factors.rank();
}

inline Eigen::Index count(const std::vector<Constraint>& constraints) {
  return static_cast<Eigen::Index>(constraints.size());
}

}  // namespace shoreline::test
