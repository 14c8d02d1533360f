#pragma once
// Weights of the stress in the forces that are fitted to the outline at every step.

#include "../consistent_weights.hpp"
#include "../point_cells.hpp"

namespace shoreline {

/// The fit of one step after the other.
class FittedQuadrature {
 public:
  /// Fits the weights to where points and edges are now, (W.7)–(W.9).
  /// @param supports  with the cells of the points; their places are noted here
  void fit(const Basis& basis, const MaterialPoints& points, PointSupports& supports, const std::vector<Edge>& edges) {
    supports.functions = basis.functions_per_cell();
    note_places(points, supports);
    weight_ = weights_.fit(basis, points, supports, edges);
  }

  [[nodiscard]] const Eigen::VectorXd& weight() const { return weight_; }  ///< (points) [m³ per metre]
  [[nodiscard]] const WeightReport& report() const { return weights_.report(); }

  /// Points that are gone take their weights with them.
  void keep(const std::vector<Index>& kept) { reorder_entries(kept, weight_); }

 private:
  ConsistentWeights weights_{Consistency::linear};
  Eigen::VectorXd weight_;
};

}  // namespace shoreline
