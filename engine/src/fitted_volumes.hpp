#pragma once
// The weights of material points, fitted at every load step to what the outline covers of their cells.

#include <optional>

#include "consistent_weights.hpp"
#include "shoreline/boundary/body_moments.hpp"

namespace shoreline {

/// Keeps the volumes that the points had at the start, from which each step's weights differ as little as can be.
class FittedVolumes {
 public:
  /// Sets the volumes of the points to weights that reproduce the moments of their cells, (W.1). Where cells have too
  /// few points for that, weights of all points that integrate gradients exactly follow from these, (W.7), (W.8).
  ///
  /// @param edges   of this step
  /// @param points  volumes in and out
  /// @return what the fit came to
  /// @throws ComputationError as ConsistentWeights::fit
  WeightReport fit(const Basis& basis, const PointSupports& supports, const std::vector<Edge>& edges,
                   MaterialPoints& points);

 private:
  /// (W.1), and how many cells cannot integrate gradients; then those that do not meet all moments keep their volumes.
  [[nodiscard]] Index fit_cells(const Basis& basis, const PointSupports& supports, const BodyMoments& moments,
                                MaterialPoints& points) const;

  Eigen::VectorXd start_;  ///< volumes before the first fit [m²]
  /// Made where it is needed: linear for points that never met the moments, divergence for those that lost them as they
  /// moved.
  std::optional<ConsistentWeights> consistent_;
};

}  // namespace shoreline
