#include "step_system.hpp"

#include <fmt/format.h>

#include "diagnosis.hpp"
#include "shoreline/bases/counters.hpp"
#include "shoreline/engine/failures.hpp"
#include "timed_effect.hpp"

namespace shoreline {
namespace {

constexpr double suspicious_pivot = 1e-10;
constexpr const char* remedy =
    "add a ghost penalty (\"ghost\": 0.001), use more points per cell, another place of the grid or larger cells";

constexpr double determined = 1e-6;  ///< of the largest displacement: what a refinement may still change

/// A solution, and by how much of its largest entry the last refinement changed it.
struct Solution {
  Eigen::VectorXd value;
  double change = 0.0;
};

std::string singular_at(const StepState& state, const StepSystem& system, const SingularMatrix& error) {
  return fmt::format("the stiffness is singular (pivot {:.1e} of the scaled matrix) at {}", error.pivot(),
                     weak_unknown(state, system.assembler.unknown(error.equation())));
}

void require_held(const StepState& state, const std::vector<Constraint>& constraints, const StepSystem& system) {
  if (const auto free = free_motion(state, system.blocks, constraints))
    throw ComputationError(*free + "; add a boundary condition \"fixed\" or \"roller\"");
}

/// Factorises A + s I instead of the singular A. The shift s stands between rounding, which a refinement amplifies by
/// ε_machine/s in motions without stiffness, and the smallest eigenvalue λ of the rest, where it converges like s/λ.
void factorize_shifted(const std::string& singular, StepSystem& system) {
  constexpr double shift = 1e-9;
  try {
    system.solver.factorize(system.matrix, shift);
  } catch (const SingularMatrix&) {
    throw ComputationError(singular + "; " + remedy);
  }
}

/// Refines until nothing changes: never, where the loads move what has no stiffness.
Solution solve_shifted(const StepSystem& system) {
  constexpr int most = 20;
  Solution solution{system.solver.solve(system.force), 0.0};
  for (int k = 0; k < most; ++k) {
    const Eigen::VectorXd next = system.solver.refined(system.force, solution.value);
    const double largest = next.cwiseAbs().maxCoeff();
    solution.change = largest > 0.0 ? (next - solution.value).cwiseAbs().maxCoeff() / largest : 0.0;
    if (solution.change <= determined) break;
    solution.value = next;
  }
  return solution;
}

Unknowns unknowns_of(const Basis& basis, const Assembler& assembler) {
  Unknowns unknowns{Eigen::Matrix2Xd(2, assembler.equations()), Eigen::VectorXi(assembler.equations()),
                    basis.functions_per_cell()};
  for (Index e = 0; e < assembler.equations(); ++e) {
    unknowns.place.col(e) = basis.control_point(assembler.unknown(e) / 2);
    unknowns.component[e] = assembler.unknown(e) % 2;
  }
  return unknowns;
}

void analyse(const Basis& basis, const SolverRequest& request, StepSystem& system, RunRecord& record) {
  record.phases.time("analyse", [&] {
    if (system.iteration_failed)
      system.solver.analyse(system.matrix);
    else
      system.solver.analyse(system.matrix, unknowns_of(basis, system.assembler), request);
  });
  ++record.analyses;
}

std::string not_converged(const NotConverged& error) {
  return fmt::format("multigrid stopped after {} iterations at {:.1e} of the residual", error.iterations(),
                     error.residual());
}

/// Where the matrix is singular or nearly so, finds out why.
void factorize(const StepState& state, const std::vector<Constraint>& constraints, StepSystem& system) {
  system.singular.clear();
  try {
    system.solver.factorize(system.matrix);
  } catch (const SingularMatrix& error) {
    system.singular = singular_at(state, system, error);
  }
  if (system.singular.empty() && system.solver.smallest_pivot() > suspicious_pivot) return;
  require_held(state, constraints, system);
  if (!system.singular.empty()) factorize_shifted(system.singular, system);
}

/// Factorises and solves; where the matrix is singular or nearly so, says why in the user's words.
Eigen::VectorXd factorize_and_solve(const StepState& state, const std::vector<Constraint>& constraints,
                                    StepSystem& system, RunRecord& record) {
  Clock& clock = record.phases;
  if (!system.same_matrix) {
    clock.time("factorise", [&] { factorize(state, constraints, system); });
    ++record.factorisations;
  }
  if (system.singular.empty()) return clock.time("solve", [&] { return system.solver.solve(system.force); });

  Solution solution = clock.time("solve", [&] { return solve_shifted(system); });
  if (!(solution.change <= determined))
    throw ComputationError(fmt::format(
        "{}. The loads do not determine it (each refinement changes it by {:.1e} of the largest displacement); {}",
        system.singular, solution.change, remedy));
  system.warnings.add(
      "singular", record.steps + 1,
      fmt::format("{}. No load moves it, so it was left at rest. To hold it, {}", system.singular, remedy),
      record.warnings);
  return std::move(solution.value);
}

/// Where the case leaves the choice, CHOLMOD goes on from where multigrid does not converge.
Eigen::VectorXd solve(const StepState& state, const std::vector<Constraint>& constraints,
                      const QuasiStaticOptions& options, StepSystem& system, RunRecord& record) {
  try {
    return factorize_and_solve(state, constraints, system, record);
  } catch (const NotConverged& error) {
    if (options.solver == SolverType::multigrid)
      throw ComputationError(
          fmt::format("{}: the stiffness is badly conditioned or not positive definite; set "
                      "solver.type to \"cholmod\", or {}",
                      not_converged(error), remedy));
    system.warnings.add("iteration", record.steps + 1, not_converged(error) + "; CHOLMOD goes on", record.warnings);
  }
  system.iteration_failed = true;
  system.same_matrix = false;
  analyse(state.basis, {}, system, record);
  return factorize_and_solve(state, constraints, system, record);
}

void warn_indefinite(const StepState& state, StepSystem& system, RunRecord& record) {
  system.warnings.add(
      "indefinite", record.steps + 1,
      fmt::format("the stiffness is not positive definite at {}; solved by a pivoted LU factorisation. A smaller band "
                  "or a ghost penalty restores definiteness",
                  weak_unknown(state, system.assembler.unknown(system.solver.smallest_pivot_equation()))),
      record.warnings);
}

/// Above this many the solution has lost most of its sixteen digits, (L.3).
constexpr double suspicious_condition = 1e14;

void estimate_condition(const StepState& state, StepSystem& system, RunRecord& record) {
  record.condition_estimate = timed_effect(record, "condition_estimate", "condition_estimate",
                                           [&] { return system.solver.condition_estimate(); });
  if (*record.condition_estimate <= suspicious_condition) return;
  system.warnings.add(
      "condition", record.steps + 1,
      fmt::format("the condition estimate is {:.1e}, above {:.0e}: few digits of the solution are "
                  "certain. Weakest is {}; {}",
                  *record.condition_estimate, suspicious_condition,
                  weak_unknown(state, system.assembler.unknown(system.solver.smallest_pivot_equation())), remedy),
      record.warnings);
}

}  // namespace

Eigen::Matrix2Xd solve_step(const Scene& scene, const StepState& state, const std::vector<Constraint>& constraints,
                            const QuasiStaticOptions& options, StepSystem& system, RunRecord& record) {
  Clock& clock = record.phases;
  clock.time("assembly", [&] {
    const CountedAllocations counted;
    system.blocks.clear();
    for (const auto& effect : scene.contributions)
      record.effects.time(effect->name(), [&] { effect->add(state, system.blocks); });
  });
  const bool same_pattern = clock.time(
      "pattern", [&] { return system.assembler.prepare(system.blocks, constraints, scene.basis->functions()); });
  record.degrees_of_freedom = system.assembler.equations();
  clock.time("assembly", [&] { system.assembler.assemble(system.blocks, system.matrix, system.force); });
  if (system.assembler.equations() == 0) return system.assembler.expand(system.force);  // every function is held
  system.same_matrix &= same_pattern;
  if (!same_pattern) analyse(*scene.basis, {options.solver, needs_factors(options)}, system, record);
  const Eigen::VectorXd solution = solve(state, constraints, options, system, record);
  record.solver = system.solver.use();
  if (!system.solver.positive_definite()) warn_indefinite(state, system, record);
  if (options.condition_estimate) estimate_condition(state, system, record);
  if (!solution.allFinite()) throw ComputationError("the solution is not finite; check loads and stiffness");
  const Eigen::Matrix2Xd increment = system.assembler.expand(solution);
  if (system.solver.smallest_pivot() <= suspicious_pivot)
    if (const auto stray = stray_point(state, increment)) throw ComputationError(*stray + "; " + remedy);
  return increment;
}

}  // namespace shoreline
