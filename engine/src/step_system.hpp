#pragma once
// The linear system of one load step: assembled and solved, or refused with the reason.

#include "shoreline/engine/linear_solver.hpp"
#include "shoreline/engine/quasi_static.hpp"
#include "step_warnings.hpp"

namespace shoreline {

/// What outlives a step: memory, pattern, analysis, and what was said already.
struct StepSystem {
  ElementBlocks blocks;
  Assembler assembler;
  SparseMatrix matrix;
  Eigen::VectorXd force;
  LinearSolver solver;
  StepWarnings warnings;
  bool same_matrix = false;  ///< as in the step before, whose factors serve again
  std::string singular{};    ///< what the message says of a singular matrix, whose factors are those of a shifted one
  bool iteration_failed = false;  ///< multigrid, which is then not tried again
};

/// Assembles the contributions of a scene and solves for Δd, (2, functions) [m].
///
/// A matrix that is singular because cells are nearly empty is solved where nothing loads the motions without
/// stiffness, (L.5), and the record is warned.
///
/// @throws ComputationError naming the motion or the cell at fault, and what to do: where a part of the body moves
///         freely, where the loads do not determine the solution, where it moves a point by more than the body's size
[[nodiscard]] Eigen::Matrix2Xd solve_step(const Scene& scene, const StepState& state,
                                          const std::vector<Constraint>& constraints, const QuasiStaticOptions& options,
                                          StepSystem& system, RunRecord& record);

}  // namespace shoreline
