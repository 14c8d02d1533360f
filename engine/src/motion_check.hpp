#pragma once
// Whether a body that has moved is still a body inside the grid.

#include "shoreline/engine/scene.hpp"

namespace shoreline {

/// Checks what a load step has left behind, be it the last: all material points in the grid; a curve through the
/// tracking points of each piece, in the grid; no curve that crosses or touches itself or another.
///
/// @throws ComputationError with the piece (or how many points), the place, and what to do
void check_motion(const Scene& scene);

}  // namespace shoreline
