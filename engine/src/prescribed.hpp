#pragma once
// The displacement that boundary pieces prescribe at one load step.

#include <map>

#include "shoreline/boundary/displacement_fit.hpp"
#include "shoreline/engine/scene.hpp"

namespace shoreline {

/// What the pieces' displacements gain in a step, fitted in the basis over all essential pieces together, (D.8).
/// @param errors  of the fit, by piece that prescribes a displacement; those of this step are added
/// @return (2, functions) coefficients [m]; no columns, and no work, where no piece prescribes a displacement
[[nodiscard]] Eigen::Matrix2Xd prescribed_increment(const Scene& scene, const std::vector<Edge>& edges, double t,
                                                    double t_before, std::map<std::string, FitError>& errors);

}  // namespace shoreline
