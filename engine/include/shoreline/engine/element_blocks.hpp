#pragma once
// What contributions give to the assembler: small dense matrices and vectors over a few functions each.

#include <vector>

#include "shoreline/bases/types.hpp"

namespace shoreline {

/// Element blocks in one flat store. Block b couples the functions first[b] … first[b + 1] − 1 of @ref function, two
/// unknowns each, ordered (function, component).
struct ElementBlocks {
  std::vector<Index> first{0};
  std::vector<Index> function;
  std::vector<std::size_t> entry{0};  ///< start of the lower half of the (2n, 2n) matrix of a block
  std::vector<double> matrix;         ///< lower halves, column by column
  std::vector<double> force;          ///< (2 · functions of all blocks), external less internal [N per metre]

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] Eigen::Index functions_in(std::size_t b) const { return first[b + 1] - first[b]; }
  [[nodiscard]] Eigen::Map<Eigen::VectorXd> force_of(std::size_t b) {
    return {force.data() + 2 * first[b], 2 * functions_in(b)};
  }
  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> force_of(std::size_t b) const {
    return {force.data() + 2 * first[b], 2 * functions_in(b)};
  }

  /// Appends a zero block over @p functions and returns its number.
  template <class Functions>
  std::size_t append(const Functions& functions) {
    for (const Index f : functions) function.push_back(f);
    first.push_back(static_cast<Index>(function.size()));
    const auto m = static_cast<std::size_t>(2 * functions_in(size() - 1));
    entry.push_back(entry.back() + m * (m + 1) / 2);
    matrix.resize(entry.back(), 0.0);
    force.resize(2 * function.size(), 0.0);
    return size() - 1;
  }

  /// Appends @p count zero blocks of @p n functions each, to be written to @ref function afterwards.
  /// @return number of the first
  std::size_t append(std::size_t count, Index n);

  /// Adds the lower half of a (2n, 2n) matrix to block @p b.
  template <class Dense>
  void add(std::size_t b, const Eigen::MatrixBase<Dense>& dense) {
    double* to = matrix.data() + entry[b];
    for (Eigen::Index j = 0; j < dense.cols(); ++j)
      for (Eigen::Index i = j; i < dense.rows(); ++i) *to++ += dense(i, j);
  }

  /// Matrix of block @p b times the coefficients of its functions, (2n).
  /// @param coefficient  (2, functions of the basis)
  [[nodiscard]] Eigen::VectorXd times(std::size_t b, const Eigen::Matrix2Xd& coefficient) const;

  /// Forgets the blocks and keeps the memory.
  void clear();
};

}  // namespace shoreline
