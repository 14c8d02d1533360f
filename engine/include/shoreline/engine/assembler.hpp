#pragma once
// From element blocks to one sparse symmetric system: numbering, elimination, pattern, scatter.

#include <utility>
#include <vector>

#include "shoreline/engine/element_blocks.hpp"

namespace shoreline {

/// A displacement component of a function that is prescribed on a grid line.
struct Constraint {
  Index function;
  int component;       ///< 0 or 1
  int piece;           ///< boundary piece that asks for it
  double value = 0.0;  ///< increment [m]
};

/// Lower half of a symmetric matrix, compressed by columns, rows ascending.
struct SparseMatrix {
  Index size = 0;
  std::vector<Index> column;  ///< (size + 1)
  std::vector<Index> row;
  std::vector<double> value;
};

/// Assembles element blocks. Pattern and places are found once and kept while the blocks couple the same functions.
class Assembler {
 public:
  /// Numbers the unknowns (two a function that occurs in a block, less constrained ones) and finds the pattern.
  ///
  /// @return whether the pattern of the call before still holds (then nothing was done)
  bool prepare(const ElementBlocks& blocks, const std::vector<Constraint>& constraints, Index functions);

  /// Sums the blocks; prescribed values go to the right-hand side, (C.2). The sums do not depend on the number of
  /// threads.
  void assemble(const ElementBlocks& blocks, SparseMatrix& matrix, Eigen::VectorXd& force) const;

  /// Increment of all functions, (2, functions), from a solution; prescribed values where constrained, else zero where
  /// there is no unknown.
  [[nodiscard]] Eigen::Matrix2Xd expand(const Eigen::VectorXd& solution) const;

  /// Σ blocks (K d − f) of every function that has a constrained component, (2, functions): there it is the force of
  /// the support on the body [N per metre], (C.1). Other functions' columns mean nothing.
  [[nodiscard]] Eigen::Matrix2Xd reactions(const ElementBlocks& blocks, const Eigen::Matrix2Xd& increment) const;

  [[nodiscard]] Index equations() const { return static_cast<Index>(unknown_.size()); }

  /// Which component of which function an equation stands for: 2·function + component.
  [[nodiscard]] Index unknown(Index equation) const { return unknown_[static_cast<std::size_t>(equation)]; }

 private:
  void number_unknowns(Index functions);
  void build_pattern(const ElementBlocks& blocks);
  void add_prescribed(const ElementBlocks& blocks, Eigen::VectorXd& force) const;

  std::vector<Index> first_, function_;  ///< blocks for which the pattern holds
  std::vector<Constraint> constraints_;
  std::vector<Index> equation_;  ///< (2 · functions) or −1
  std::vector<Index> unknown_;   ///< (equations)
  std::vector<Index> column_;    ///< (equations + 1)
  std::vector<Index> row_;
  std::vector<std::pair<Index, Index>> places_;  ///< smallest and largest place of each block
  std::vector<Index> place_;                     ///< of every entry of every block matrix in the values, or −1
};

}  // namespace shoreline
