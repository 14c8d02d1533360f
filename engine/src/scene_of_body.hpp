#pragma once
// What scenes of every analysis have in common.

#include "conditions_on_piece.hpp"
#include "shoreline/engine/scene.hpp"

namespace shoreline {

/// Basis, points, boundary with its conditions and exact solution of a case; no contributions, material or probes.
/// @throws CaseError as build_scene
[[nodiscard]] Scene scene_of_body(const Case& problem, const LoadFactor& factor);

}  // namespace shoreline
