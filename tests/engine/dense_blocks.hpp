#pragma once
// Random element blocks, and the dense matrices that they stand for.

#include <algorithm>
#include <numeric>

#include "../random.hpp"
#include "shoreline/engine/element_blocks.hpp"

namespace shoreline::test {

/// Blocks over random functions (of which some may be in none), with random symmetric matrices and forces.
inline ElementBlocks random_blocks(Random& random, Index functions, int count) {
  ElementBlocks blocks;
  std::vector<Index> all(static_cast<std::size_t>(functions));
  std::iota(all.begin(), all.end(), 0);
  for (int b = 0; b < count; ++b) {
    for (std::size_t k = all.size() - 1; k > 0; --k)
      std::swap(all[k], all[static_cast<std::size_t>(random.whole(0, static_cast<Index>(k)))]);
    const auto n = random.whole(1, std::min<Index>(5, functions));
    const std::size_t number = blocks.append(std::vector<Index>(all.begin(), all.begin() + n));
    const Eigen::MatrixXd half = Eigen::MatrixXd::NullaryExpr(2 * n, 2 * n, [&] { return random.uniform(-1.0, 1.0); });
    blocks.add(number, half + half.transpose());
    blocks.force_of(number) = Eigen::VectorXd::NullaryExpr(2 * n, [&] { return random.uniform(-1.0, 1.0); });
  }
  return blocks;
}

/// The full matrix of a block.
inline Eigen::MatrixXd block_matrix(const ElementBlocks& blocks, std::size_t b) {
  const Eigen::Index m = 2 * blocks.functions_in(b);
  Eigen::MatrixXd matrix(m, m);
  const double* k = blocks.matrix.data() + blocks.entry[b];
  for (Eigen::Index j = 0; j < m; ++j)
    for (Eigen::Index i = j; i < m; ++i) matrix(i, j) = matrix(j, i) = *k++;
  return matrix;
}

/// Matrix and force over all components of all functions.
struct DenseSystem {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd force;
};

inline DenseSystem dense(const ElementBlocks& blocks, Index functions) {
  DenseSystem system{Eigen::MatrixXd::Zero(2 * functions, 2 * functions), Eigen::VectorXd::Zero(2 * functions)};
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Eigen::MatrixXd matrix = block_matrix(blocks, b);
    const auto place = [&](Eigen::Index i) {
      return 2 * blocks.function[static_cast<std::size_t>(blocks.first[b] + i / 2)] + i % 2;
    };
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      system.force[place(i)] += blocks.force_of(b)[i];
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) system.matrix(place(i), place(j)) += matrix(i, j);
    }
  }
  return system;
}

/// Σ forces of the blocks, by function.
inline Eigen::Matrix2Xd nodal_forces(const ElementBlocks& blocks, Index functions) {
  return dense(blocks, functions).force.reshaped(2, functions);
}

/// Σ matrices of the blocks times a field, by function.
inline Eigen::Matrix2Xd times(const ElementBlocks& blocks, const Eigen::Matrix2Xd& field) {
  return (dense(blocks, static_cast<Index>(field.cols())).matrix * field.reshaped()).reshaped(2, field.cols());
}

}  // namespace shoreline::test
