#pragma once
// The energy that a body stores.

#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// Σ_p V_p ½ σ_p : ε_p, (E.6) [J per metre of thickness], of a linear elastic law.
///
/// σ : ε has the three components in the plane: ε_zz is zero in plane strain, σ_zz in plane stress.
///
/// @param points  with strains, and the volumes, or fitted weights, that the sums of the last load step had
[[nodiscard]] double strain_energy(const MaterialPoints& points);

}  // namespace shoreline
