#include "shoreline/engine/element_blocks.hpp"

namespace shoreline {

std::size_t ElementBlocks::append(std::size_t count, Index n) {
  const std::size_t before = size();
  const auto m = static_cast<std::size_t>(2 * n);
  first.reserve(first.size() + count);
  entry.reserve(entry.size() + count);
  for (std::size_t b = 0; b < count; ++b) {
    first.push_back(first.back() + n);
    entry.push_back(entry.back() + m * (m + 1) / 2);
  }
  function.resize(static_cast<std::size_t>(first.back()));
  matrix.reserve(entry.back() + entry.back() / 8);  // a few blocks more shall not move all of these
  matrix.resize(entry.back(), 0.0);
  force.resize(2 * function.size(), 0.0);
  return before;
}

Eigen::VectorXd ElementBlocks::times(std::size_t b, const Eigen::Matrix2Xd& coefficient) const {
  const Eigen::Index m = 2 * functions_in(b);
  Eigen::VectorXd local(m);
  for (Eigen::Index a = 0; a < m / 2; ++a)
    local.segment<2>(2 * a) = coefficient.col(function[static_cast<std::size_t>(first[b] + a)]);
  Eigen::VectorXd product = Eigen::VectorXd::Zero(m);
  const double* k = matrix.data() + entry[b];
  for (Eigen::Index j = 0; j < m; ++j) {
    product[j] += *k++ * local[j];
    for (Eigen::Index i = j + 1; i < m; ++i, ++k) {
      product[i] += *k * local[j];
      product[j] += *k * local[i];
    }
  }
  return product;
}

void ElementBlocks::clear() {
  first.assign(1, 0);
  entry.assign(1, 0);
  function.clear();
  matrix.clear();
  force.clear();
}

}  // namespace shoreline
