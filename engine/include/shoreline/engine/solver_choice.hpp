#pragma once
// Which method solves a linear system: named by the case, or by measured rules (docs/solvers.md).

#include <optional>
#include <string>

#include "shoreline/bases/types.hpp"

namespace shoreline {

enum class SolverType {
  automatic,  ///< one of the others, by choose_solver
  band,       ///< Cholesky of the band in grid order (LAPACK)
  cholmod,    ///< supernodal Cholesky in a fill-reducing order (SuiteSparse)
  multigrid   ///< conjugate gradients with algebraic multigrid (PETSc), where its component is installed
};

/// As in case files: "auto", "band", "cholmod", "multigrid".
[[nodiscard]] std::string name_of(SolverType type);

/// What a case asks of the solver.
struct SolverRequest {
  SolverType type = SolverType::automatic;
  bool needs_factors = false;  ///< pivots or a condition estimate are asked for, which multigrid has not
};

/// What is known of a system before it is solved.
struct SystemSize {
  Index unknowns = 0;
  Index width = 0;             ///< half width of its band in grid order: max |i − j| over its entries
  int functions_per_cell = 4;  ///< of the basis: how many of them are coupled at a point
};

/// A method and why it was taken.
struct SolverChoice {
  SolverType type;
  std::string reason;  ///< for people: "the band of 203 is narrow (at most 260)"
};

/// Resolves `automatic`; what the case names is taken as it is.
[[nodiscard]] SolverChoice choose_solver(const SolverRequest& request, const SystemSize& size);

/// Bytes of a band of that size in LAPACK's lower storage: 8 n (width + 1).
[[nodiscard]] double band_bytes(const SystemSize& size);

/// Whether the optional component of multigrid can be loaded; loads it.
[[nodiscard]] bool multigrid_available();

/// What is missing for multigrid and how to get it, for people.
[[nodiscard]] std::string multigrid_missing();

/// What solved the last system.
struct SolverUse {
  SolverType type = SolverType::automatic;
  Index unknowns = 0;
  double bytes = 0.0;                ///< of the factor or the hierarchy of grids
  std::optional<long> iterations{};  ///< of all solutions since the matrix came; multigrid alone
};

}  // namespace shoreline
