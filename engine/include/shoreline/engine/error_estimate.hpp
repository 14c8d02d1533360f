#pragma once
// What the stress of a run is in error by, estimated from that run alone.

#include "shoreline/engine/material_points.hpp"
#include "shoreline/engine/results.hpp"

namespace shoreline {

/// Estimates the error of the points' stress by recovery (Zienkiewicz & Zhu 1987): σ* is the L2 projection of the
/// stress at the points onto the basis, (Z.1), and stands for the exact one, (Z.2), (Z.3):
///
///     Σ_j (Σ_p V_p φ_i(x_p) φ_j(x_p)) s_j = Σ_p V_p φ_i(x_p) σ_p        η² = Σ_p V_p |σ*(x_p) − σ_p|²
///
/// Weights are the points' volumes, components xx, yy, xy.
///
/// @param points    at least one, with stresses and volumes of the end of a step
/// @param supports  of the points where the step found its strains: at the start of a load step
[[nodiscard]] ErrorEstimate error_estimate(const Basis& basis, const MaterialPoints& points,
                                           const PointSupports& supports);

}  // namespace shoreline
