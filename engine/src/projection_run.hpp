#pragma once
// The L2 projection as an analysis.

#include "shoreline/engine/run.hpp"

namespace shoreline {

/// Projects what the case's analysis names, and writes its results.
/// @throws CaseError if points do not determine the field; ComputationError if a formula has no value somewhere; as run
Summary run_projection(const Case& problem, const RunOptions& options, int threads);

/// The basis of a projection and what it would cost, as text.
[[nodiscard]] std::string plan_projection(const Case& problem);

}  // namespace shoreline
