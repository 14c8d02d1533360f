#pragma once
// Which parts of a discretisation can be refined by themselves.

#include "case_file/json_text.hpp"

namespace shoreline {

/// One part, and the changes to the case that refine it and nothing else.
struct Refinement {
  std::string part;                   ///< "grid", "points", "boundary points", "band", "time step"
  std::vector<std::string> settings;  ///< "path=value"
};

/// The grid at half the cell size; twice as many points in each direction; twice as many tracking points on arcs and
/// circles; bands a tenth as wide; half the step in load or time. Only parts that the case has: listed points and
/// tracking points are what they are.
///
/// @param json  a case that runs
[[nodiscard]] std::vector<Refinement> refinements_of(const Json& json);

/// Changes that move the grid by (0.37, 0.21) cells, which no alignment survives; none on a mesh, or where a piece is
/// held on grid lines.
[[nodiscard]] std::vector<std::string> shifted_grid(const Json& json);

}  // namespace shoreline
