#pragma once
// Systems of equations for tests of their solvers.

#include "random.hpp"
#include "shoreline/engine/linear_solver.hpp"

namespace shoreline::test {

/// Lower half of a dense matrix as a sparse one; entries that are zero are left out.
inline SparseMatrix sparse(const Eigen::MatrixXd& dense) {
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

inline Eigen::VectorXd random_vector(Random& random, Eigen::Index n) {
  return Eigen::VectorXd::NullaryExpr(n, [&] { return random.uniform(-1.0, 1.0); });
}

/// |x − exact| over |exact|.
inline double relative(const Eigen::VectorXd& x, const Eigen::VectorXd& exact) {
  return (x - exact).norm() / exact.norm();
}

}  // namespace shoreline::test
