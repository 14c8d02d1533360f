#pragma once
// Time steps of a case.

#include "boundary_reader.hpp"

namespace shoreline {

/// What time steps need beside grid, outline and points.
/// @throws CaseError for keys that contradict each other or lack another
void read_dynamics(const Node& root, const Constants& constants, Case& problem);

}  // namespace shoreline
