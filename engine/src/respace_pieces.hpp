#pragma once
// Re-spacing of tracking points between two load steps.

#include "shoreline/engine/scene.hpp"
#include "step_warnings.hpp"

namespace shoreline {

/// Re-spaces pieces whose chords differ by more than scene.respacing, if that is set. What refers to places on them
/// follows: the curve of the start, and what contributions remember.
/// @param warnings  gets one line a piece, with the number of steps
/// @throws as fit_spline
void respace_pieces(Scene& scene, int step, StepWarnings& said, std::vector<std::string>& warnings);

}  // namespace shoreline
