#pragma once
// The optional component of multigrid: a shared library that is loaded when a system is first solved by it, so that
// programs that do not use it neither link nor load PETSc and MPI.

#include <memory>

#include "factors.hpp"

namespace shoreline {

/// Conjugate gradients, preconditioned by algebraic multigrid.
/// @param unknowns  from which the rigid-body motions follow that the grids keep
/// @throws InvalidArgument if the component is not installed
[[nodiscard]] std::unique_ptr<Factors> make_multigrid_factors(const Unknowns& unknowns);

/// Name of the component's only function, of this type; the caller owns what it returns.
inline constexpr const char* multigrid_entry = "shoreline_make_multigrid";
using MakeMultigrid = Factors*(const Unknowns&);

}  // namespace shoreline
