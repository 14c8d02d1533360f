#pragma once
// The state of a body as it is saved.

#include "shoreline/engine/results.hpp"
#include "shoreline/engine/scene.hpp"

namespace shoreline {

/// @param t  that the step is saved under
[[nodiscard]] SavedStep saved_step(const Scene& scene, int step, double t);

}  // namespace shoreline
