#pragma once
// The weights of material points, fitted at every load step to what the outline covers of their cells.

#include "shoreline/engine/quasi_static.hpp"

namespace shoreline {

/// Keeps the volumes that the points had at the start, from which each step's weights differ as little as can be.
class FittedVolumes {
 public:
  /// Sets the volumes of the points to weights that reproduce the moments of every cell up to order 2p, (W.1). The part
  /// of the body in cells without points is shared out in proportion, so that the volumes sum to its area.
  ///
  /// @param edges   of this step
  /// @param points  volumes in and out
  /// @return what the fit came to
  WeightFit fit(const Basis& basis, const PointSupports& supports, const std::vector<Edge>& edges,
                MaterialPoints& points);

 private:
  Eigen::VectorXd start_;  ///< volumes before the first fit [m²]
};

}  // namespace shoreline
