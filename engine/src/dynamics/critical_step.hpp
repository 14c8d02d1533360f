#pragma once
// The largest stable time step.

#include "mass_matrix.hpp"
#include "point_passes.hpp"

namespace shoreline {

/// What the highest frequency of a step depends on.
struct VibratingBody {
  MovingPoints points;
  const PointCells& cells;
  const LargeStrainMaterial& law;
  MassMatrix& mass;
  const HeldComponents& held;  ///< with values zero
};

/// Δt = 2/√λ_max(M⁻¹ K) by power iteration, (Y.13). Keeps the mode that it found, from which the next call starts.
class CriticalStep {
 public:
  /// @param most       iterations; it ends before them where λ changes by less than 1e-3
  /// @return [s]; infinite where nothing is stiff
  double measure(PointPasses& passes, const VibratingBody& body, int most);

  /// The function that moves most in the mode of the last call.
  [[nodiscard]] Index most_moved() const;

  [[nodiscard]] long iterations() const { return iterations_; }

 private:
  Eigen::Matrix2Xd mode_;
  Eigen::Matrix2Xd force_;
  long iterations_ = 0;
};

}  // namespace shoreline
