#pragma once
// Where a load step's system is weak: small cuts, small pivots, stray points.

#include <vector>

#include "shoreline/boundary/cut_fractions.hpp"
#include "shoreline/engine/diagnostics.hpp"
#include "step_system.hpp"

namespace shoreline {

/// Share that the body covers of each element, on the outline at the start of the step.
[[nodiscard]] std::vector<CutFraction> cut_fractions(const StepState& step);

/// All of them, for a system that was factorised.
[[nodiscard]] Diagnostics weak_spots(const StepState& step, const StepSystem& system);

}  // namespace shoreline
