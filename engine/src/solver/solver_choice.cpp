#include "shoreline/engine/solver_choice.hpp"

#include <fmt/format.h>

namespace shoreline {
namespace {

/// Measured; docs/solvers.md has the tables.
constexpr Index width_per_function = 52;  ///< widest band, over the functions of a cell
constexpr Index fewest_for_multigrid = 2000000;
constexpr Index fewest_for_multigrid_smooth = 200000;  ///< where functions reach over more than one cell
constexpr int smooth = 5;                              ///< functions of a cell

}  // namespace

std::string name_of(SolverType type) {
  switch (type) {
    case SolverType::automatic:
      return "auto";
    case SolverType::band:
      return "band";
    case SolverType::cholmod:
      return "cholmod";
    case SolverType::multigrid:
      break;
  }
  return "multigrid";
}

double band_bytes(const SystemSize& size) { return 8.0 * size.unknowns * (size.width + 1.0); }

SolverChoice choose_solver(const SolverRequest& request, const SystemSize& size) {
  if (request.type != SolverType::automatic) return {request.type, "the case names it"};
  const Index widest_band = width_per_function * size.functions_per_cell;
  if (size.width <= widest_band)
    return {SolverType::band, fmt::format("a band of half width {} is narrow, at most {}", size.width, widest_band)};
  const Index fewest = size.functions_per_cell >= smooth ? fewest_for_multigrid_smooth : fewest_for_multigrid;
  const std::string wide = fmt::format("a band of half width {} is wide, above {}", size.width, widest_band);
  if (size.unknowns < fewest) return {SolverType::cholmod, wide};
  if (request.needs_factors) return {SolverType::cholmod, wide + ", and diagnostics ask for pivots"};
  if (!multigrid_available()) return {SolverType::cholmod, wide + ", and multigrid is not installed"};
  return {SolverType::multigrid, fmt::format("{} unknowns are many, at least {}", size.unknowns, fewest)};
}

}  // namespace shoreline
