#pragma once
// A body that lies off the grid lines, and what its two load steps cost.

#include <map>
#include <string>

#include "shoreline/engine/case.hpp"
#include "shoreline/engine/solver_choice.hpp"

namespace shoreline::bench {

/// Rollers by the implicit boundary on three sides, a traction on the fourth; two load steps, so that the second shows
/// what is reused.
struct Rectangle {
  int degree = 1;    ///< of the basis: 1 bilinear, else B-splines with a ghost penalty
  int slender = 1;   ///< length over width
  int cells = 1;     ///< over the width
  int per_cell = 4;  ///< points in a cell and direction
};

struct TwoSteps {
  Index points = 0;
  Index unknowns = 0;
  SolverUse solver;
  double setup = 0.0;                                 ///< [s]
  std::array<std::map<std::string, double>, 2> step;  ///< seconds by phase
};

/// Builds and runs it. Blocks of memory are new in the first step, and used again in the second.
[[nodiscard]] TwoSteps run_two_steps(const Rectangle& body, SolverType solver, int threads);

}  // namespace shoreline::bench
