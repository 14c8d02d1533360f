#pragma once
// Quasi-static load steps: the loop of the implicit material point method.

#include <functional>
#include <optional>

#include "shoreline/boundary/displacement_fit.hpp"
#include "shoreline/engine/clock.hpp"
#include "shoreline/engine/diagnostics.hpp"
#include "shoreline/engine/results.hpp"
#include "shoreline/engine/scene.hpp"
#include "shoreline/engine/solver_choice.hpp"
#include "shoreline/engine/weight_report.hpp"

namespace shoreline {

/// What the load steps did and cost; filled as they go, so it tells of the steps before a failure, too.
struct RunRecord {
  int steps = 0;                 ///< completed
  Index degrees_of_freedom = 0;  ///< of the last step
  Clock phases;
  Clock effects;          ///< assembly, by contribution
  Resultants resultants;  ///< at the end of the last step
  std::vector<std::string> warnings;
  std::optional<double> condition_estimate;  ///< of the last step's scaled matrix, where asked for
  std::optional<WeightReport> weights;       ///< of the last step, where weights are fitted
  std::optional<Diagnostics> diagnostics;    ///< of the last step, where cut_fractions asked for them
  double extended_share = 0.0;               ///< largest share of a piece served by a neighbour's polynomials
  std::map<std::string, FitError>
      fit_errors;                  ///< by piece that prescribes a displacement, summed over the steps: a bound
  double largest_increment = 0.0;  ///< max |Δd| of the last step [m]
  long factorisations = 0;
  long analyses = 0;
  /// Of the stress at the end, where asked for.
  std::optional<ErrorEstimate> error_estimate{};
  std::optional<SolverUse> solver{};  ///< of the last step
};

struct QuasiStaticOptions {
  bool condition_estimate = false;
  bool cut_fractions = false;   ///< and what else tells where the system is weak
  bool error_estimate = false;  ///< of the stress at the end
  SolverType solver = SolverType::automatic;
  /// Called with the number of a completed step, when points and curves have moved and can go on.
  std::function<void(int)> after_step = [](int) {};
};

/// Whether the options ask for what only factors tell: pivots, a condition estimate.
[[nodiscard]] inline bool needs_factors(const QuasiStaticOptions& options) {
  return options.condition_estimate || options.cut_fractions;
}

/// Runs all load steps of a scene: K Δd = f, one linear solution a step, (E.3); points, stresses and curves move after
/// it.
///
/// Step k of N brings the loads to t = k/N. Residual loading balances the whole load against the stresses and the
/// supports' reactions carried so far; incremental loading adds increments and never looks back.
///
/// @throws ComputationError with step, place and remedy: no unique solution, a value that is not finite; and, after the
///         motion of a step that record.steps then counts, a point or curve outside the grid, a curve that crosses
///         itself or another
void run_load_steps(Scene& scene, const QuasiStaticOptions& options, RunRecord& record);

}  // namespace shoreline
