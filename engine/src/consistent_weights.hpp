#pragma once
// Weights of material points that are consistent with the outline of the body.

#include "shoreline/engine/linear_solver.hpp"
#include "shoreline/engine/weight_report.hpp"
#include "weight_constraints.hpp"

namespace shoreline {

/// Finds weights by the smallest relative change of the plain ones under the constraints A w = r and a lower bound,
/// (W.9):
///     w = max(β V, V (1 + Aᵀ λ)),   A w − r + ε λ = 0.
/// The left side is the gradient of a convex function of λ. Newton's method starts from the multipliers of the fit
/// before, and keeps the factors of its matrix as long as they halve the residual in every iteration.
class ConsistentWeights {
 public:
  explicit ConsistentWeights(Consistency consistency) : consistency_(consistency) {}

  /// The weights, in the order of the points [m³ per metre of thickness].
  /// @param points    with their plain weights in volume
  /// @param supports  of the points, with values and gradients
  /// @param edges     of all pieces of the outline
  /// @throws ComputationError where the iteration does not come to an end
  [[nodiscard]] Eigen::VectorXd fit(const Basis& basis, const MaterialPoints& points, const PointSupports& supports,
                                    const std::vector<Edge>& edges);

  [[nodiscard]] const WeightReport& report() const { return report_; }

 private:
  struct State;
  void start(const WeightConstraints& constraints, const Eigen::VectorXd& plain);
  void find_softness(const WeightConstraints& constraints, const Eigen::VectorXd& plain);
  void assemble(const WeightConstraints& constraints, const Eigen::VectorXd& weight);
  void evaluate(const WeightConstraints& constraints, const Eigen::VectorXd& plain, State& state) const;
  [[nodiscard]] State search(const WeightConstraints& constraints, const Eigen::VectorXd& plain, const State& from,
                             const Eigen::VectorXd& step) const;
  void advance(const WeightConstraints& constraints, const Eigen::VectorXd& plain, State& state);
  void factorise(const WeightConstraints& constraints, const Eigen::VectorXd& plain, const State& state);
  [[nodiscard]] Eigen::VectorXd newton_step(const Eigen::VectorXd& residual) const;

  Consistency consistency_;
  Eigen::VectorXd multiplier_;  ///< λ [1/m]
  Eigen::VectorXd trend_;       ///< its change in the fit before, with which the next one starts
  Eigen::VectorXd right_side_;
  Eigen::VectorXd softness_;  ///< ε of every row; found at the first fit, as ∫ |∇φ|² knows no length in the plane
  Assembler assembler_;
  LinearSolver solver_;
  ElementBlocks blocks_;
  SparseMatrix matrix_;
  std::vector<char> seen_;    ///< functions for which there are multipliers
  bool has_factors_ = false;  ///< that serve
  bool analysed_ = false;     ///< whether the pattern of the matrix is known to the solver
  WeightReport report_;
};

}  // namespace shoreline
