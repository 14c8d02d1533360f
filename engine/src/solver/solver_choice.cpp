#include "shoreline/engine/solver_choice.hpp"

#include <fmt/format.h>

namespace shoreline {
namespace {

/// Measured; docs/solvers.md has the tables.
constexpr Index widest_band = 260;
constexpr double fewest_for_multigrid = 4e5;
constexpr double fewest_for_multigrid_smooth = 3e4;  ///< where functions reach over more than one cell
constexpr double smooth = 12.0;                      ///< entries a row of the lower half: 9 of Q4, 25 of degree 2

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
  if (size.width <= widest_band)
    return {SolverType::band, fmt::format("a band of half width {} is narrow, at most {}", size.width, widest_band)};
  const double fewest = size.entries_per_row > smooth ? fewest_for_multigrid_smooth : fewest_for_multigrid;
  const std::string wide = fmt::format("a band of half width {} is wide, above {}", size.width, widest_band);
  if (size.unknowns < fewest) return {SolverType::cholmod, wide};
  if (request.needs_factors) return {SolverType::cholmod, wide + ", and diagnostics ask for pivots"};
  if (!multigrid_available()) return {SolverType::cholmod, wide + ", and multigrid is not installed"};
  return {SolverType::multigrid, fmt::format("{} unknowns are many, at least {:.0f}", size.unknowns, fewest)};
}

}  // namespace shoreline
