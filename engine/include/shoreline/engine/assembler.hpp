#pragma once
// From element blocks to one sparse symmetric system: numbering, elimination, pattern, scatter.

#include <utility>
#include <vector>

#include "shoreline/engine/element_blocks.hpp"

namespace shoreline {

/// A displacement component of a function, times a coefficient.
struct ComponentTerm {
  Index function;
  int component;  ///< 0 or 1
  double coefficient;

  bool operator==(const ComponentTerm&) const = default;
};

/// A term of a condition that a boundary piece asks for.
struct PieceTerm {
  int piece;
  ComponentTerm term;
};

/// A displacement component of a function that others give, (C.4): d = value + Σ T d_master.
struct Constraint {
  Index function;
  int component;                         ///< 0 or 1
  int piece;                             ///< boundary piece that asks for it
  double value = 0.0;                    ///< increment [m]
  std::vector<ComponentTerm> masters{};  ///< none of them constrained
  std::vector<PieceTerm> others{};       ///< part of other pieces' conditions in it, (C.6)
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
  /// Numbers the unknowns (two a function that occurs in a block or in a constraint of one that does, less constrained
  /// ones) and finds the pattern.
  ///
  /// @return whether the pattern of the call before still holds (then nothing was done)
  bool prepare(const ElementBlocks& blocks, const std::vector<Constraint>& constraints, Index functions);

  /// Sums the blocks as (C.5): what falls to constrained components goes to their masters, prescribed values go to the
  /// right-hand side. The sums do not depend on the number of threads.
  void assemble(const ElementBlocks& blocks, SparseMatrix& matrix, Eigen::VectorXd& force) const;

  /// Increment of all functions, (2, functions), from a solution; as (C.4) says where constrained, else zero where
  /// there is no unknown.
  [[nodiscard]] Eigen::Matrix2Xd expand(const Eigen::VectorXd& solution) const;

  /// Σ blocks (K d − f) of every function that has a constrained component, (2, functions): there it is the force with
  /// which the constraint acts [N per metre], (C.1). Other functions' columns mean nothing.
  [[nodiscard]] Eigen::Matrix2Xd reactions(const ElementBlocks& blocks, const Eigen::Matrix2Xd& increment) const;

  [[nodiscard]] Index equations() const { return static_cast<Index>(unknown_.size()); }

  /// Which component of which function an equation stands for: 2·function + component.
  [[nodiscard]] Index unknown(Index equation) const { return unknown_[static_cast<std::size_t>(equation)]; }

 private:
  /// Part of an entry of a block matrix that constraints bring to another place.
  struct Share {
    std::size_t entry;
    Index place;
    double factor;
  };
  struct Term {
    Index equation;
    double coefficient;
  };

  void number_unknowns(Index functions);
  void build_pattern(const ElementBlocks& blocks);
  void find_places(const ElementBlocks& blocks);
  void find_shares(const ElementBlocks& blocks);
  [[nodiscard]] Index place(Index row, Index column) const;
  [[nodiscard]] std::vector<Term> terms(Index unknown) const;
  void add_force(Index unknown, double value, Eigen::VectorXd& force) const;
  void add_prescribed(const ElementBlocks& blocks, Eigen::VectorXd& force) const;

  std::vector<Index> first_, function_;  ///< blocks for which the pattern holds
  std::vector<Constraint> constraints_;
  /// (2 · functions) number of the equation, −1 without any, −2 − k where constraint k has masters
  std::vector<Index> equation_;
  std::vector<Index> unknown_;  ///< (equations)
  std::vector<Index> column_;   ///< (equations + 1)
  std::vector<Index> row_;
  std::vector<std::pair<Index, Index>> places_;  ///< smallest and largest place of each block
  std::vector<Index> place_;                     ///< of every entry of every block matrix in the values, or −1
  std::vector<Share> shares_;                    ///< of entries without a place
};

}  // namespace shoreline
