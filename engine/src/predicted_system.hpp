#pragma once
// The size of a linear system before anything is assembled.

#include "shoreline/engine/scene.hpp"
#include "shoreline/engine/solver_choice.hpp"

namespace shoreline {

/// Unknowns and band of the first load step, without what conditions of method `grid` take away.
/// @param ghost  whether a ghost penalty couples the functions of neighbouring cells, too
[[nodiscard]] SystemSize predicted_size(const Scene& scene, const PointSupports& supports, bool ghost);

}  // namespace shoreline
