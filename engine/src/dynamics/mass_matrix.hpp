#pragma once
// The mass matrix of a step, and the fields that it gives to forces and momenta.

#include <vector>

#include "element_table.hpp"
#include "ghost_mass.hpp"
#include "held_components.hpp"
#include "shoreline/engine/case.hpp"

namespace shoreline {

/// M_ij = Σ m φ_i φ_j, (Y.2), in one of the forms of (Y.5)–(Y.7). Its pattern is that of the grid and found once.
class MassMatrix {
 public:
  MassMatrix(const ElementTable& table, MassForm form);

  /// Whether blocks of element masses are needed besides the row sums.
  [[nodiscard]] bool has_blocks() const { return form_ != MassForm::lumped; }

  /// Takes the mass of a step.
  /// @param row_sum  (functions) Σ m φ_i [kg per metre]
  /// @param blocks   (occupied elements · n · n) element masses, if has_blocks()
  void assemble(const OccupiedElements& occupied, const Eigen::VectorXd& row_sum, const std::vector<double>& blocks);

  /// Adds a ghost mass to what was assembled, (G.4).
  /// @param ghost  to live until the next call of assemble
  /// @pre has_blocks()
  void add(const GhostMass::Matrix& ghost);

  /// The field x with M x = f on components that are not held, (Y.4); those that are held get their values and what
  /// their masters give. Components without mass stay zero. By division where that solves it, else by conjugate
  /// gradients preconditioned with the diagonal.
  ///
  /// @param f  (2, functions)
  /// @param x  (2, functions) in: a guess; out: the field
  /// @throws ComputationError where conjugate gradients do not come to the tolerance
  void solve(const HeldComponents& held, const Eigen::Matrix2Xd& f, Eigen::Matrix2Xd& x, double tolerance);

  /// M x, (2, functions).
  [[nodiscard]] const Eigen::Matrix2Xd& times(const Eigen::Matrix2Xd& x);

  /// Whether the mass of a function was moved to the diagonal.
  [[nodiscard]] bool lumped(Index function) const;

  [[nodiscard]] const Eigen::VectorXd& row_sum() const { return row_sum_; }
  [[nodiscard]] long iterations() const { return iterations_; }  ///< of conjugate gradients, so far

 private:
  void build_pattern();
  void sum_blocks(const OccupiedElements& occupied, const std::vector<double>& blocks);
  void find_lumped(const OccupiedElements& occupied);
  void move_to_diagonal();
  void divide(const HeldComponents& held, const Eigen::Matrix2Xd& f, Eigen::Matrix2Xd& x) const;
  void iterate(const HeldComponents& held, const Eigen::Matrix2Xd& f, Eigen::Matrix2Xd& x, double tolerance);

  const ElementTable& table_;
  MassForm form_;
  std::vector<Index> row_;             ///< (functions + 1) range of each row
  std::vector<Index> column_;          ///< both halves, ascending
  std::vector<Index> place_;           ///< (slots · n) of a slot's entries in a row's range
  std::vector<Index> diagonal_place_;  ///< (functions)
  std::vector<double> value_;
  Eigen::VectorXd diagonal_;
  Eigen::VectorXd row_sum_;
  std::vector<char> is_lumped_;
  const GhostMass::Matrix* ghost_ = nullptr;
  Eigen::Matrix2Xd product_, residual_, direction_, preconditioned_, inverse_;
  long iterations_ = 0;
};

}  // namespace shoreline
