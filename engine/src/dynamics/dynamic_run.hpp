#pragma once
// Explicit dynamics as an analysis.

#include "shoreline/engine/run.hpp"

namespace shoreline {

/// Computes the time steps of a case and writes its results.
/// @throws as run
Summary run_dynamics(const Case& problem, const RunOptions& options, int threads);

/// What a run would build, its sizes and its time step, as text.
[[nodiscard]] std::string plan_dynamics(const Case& problem);

}  // namespace shoreline
