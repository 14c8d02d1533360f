#include "shoreline/engine/run.hpp"

#include <omp.h>

#include <chrono>
#include <variant>

#include "dynamics/dynamic_run.hpp"
#include "make_basis.hpp"
#include "projection_run.hpp"
#include "record_in_summary.hpp"
#include "saved_step.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/linear_solver.hpp"
#include "shoreline/engine/pictures.hpp"
#include "shoreline/engine/progress.hpp"
#include "shoreline/engine/quasi_static.hpp"
#include "shoreline/engine/results_writer.hpp"
#include "shoreline/engine/strain_energy.hpp"
#include "shoreline/engine/summary.hpp"
#include "timed_effect.hpp"

namespace shoreline {
namespace {

/// @param radii  whether to measure those of arcs
ErrorNorms errors_of(const Scene& scene, const RunRecord& record, bool radii, double t) {
  ErrorNorms norms = error_norms(scene.samples ? *scene.samples : scene.points, *scene.exact, t);
  norms.at_samples = scene.samples.has_value();
  norms.boundary_l2_displacement = record.resultants.displacement_errors;
  if (!radii) return norms;
  for (const BoundaryPiece& b : scene.boundary)
    if (const auto radius = radius_error(*b.original, fit_spline(b.piece), *scene.exact, t))
      norms.boundary_radius[b.piece.name] = *radius;
  return norms;
}

/// What the record of a run tells, in the form of the summary.
/// @param total  since the start of the run [s]
void take_over(const RunRecord& record, double total, Summary& summary) {
  take_over_common(record, total, summary);
  summary.condition_estimate = record.condition_estimate;
  summary.diagnostics = record.diagnostics;
  summary.solver = record.solver;
  summary.extended_share = record.extended_share;
}

/// What a run puts into its output folder as it goes: saved steps and probes.
class Saving {
 public:
  Saving(const Case& problem, const std::filesystem::path& folder, const Scene& scene, RunRecord& record)
      : every_(problem.output.every), scene_(scene), record_(record), writer_(record.phases.time("output", [&] {
          return ResultsWriter(folder, problem.title, scene.basis->grid());
        })) {
    save(0);
  }

  void after_step(int step) {
    if (step % every_ == 0 || step == scene_.load_steps)
      save(step);
    else
      save_probes();
  }

  /// After a failure: the last step that was computed, if it was not to be saved.
  void rescue() {
    if (record_.steps > last_) save(record_.steps);
  }

 private:
  void save(int step) {
    record_.phases.time("output", [&] {
      SavedStep saved = saved_step(scene_, step, static_cast<double>(step) / scene_.load_steps);
      if (record_.error_estimate) saved.stress_error_estimate = record_.error_estimate->stress_at_point;
      writer_.write(saved, scene_.points);
    });
    last_ = step;
    save_probes();
  }
  void save_probes() {
    record_.phases.time("output", [&] { writer_.append(scene_.probes); });
  }

  int every_;
  const Scene& scene_;
  RunRecord& record_;
  ResultsWriter writer_;
  int last_ = 0;
};

Summary start(const Case& problem, const Scene& scene, int threads) {
  Summary summary;
  summary.title = problem.title;
  name_basis(problem.grid, summary);
  summary.material_points = scene.points.size();
  summary.threads = threads;
  summary.blas = blas_name();
  return summary;
}

int use_threads(int asked) {
  const int threads = asked > 0 ? asked : omp_get_num_procs();
  omp_set_num_threads(threads);
  set_blas_threads(threads);
  return threads;
}

void warn_of_blas(RunRecord& record) {
  if (const Blas blas = blas_at_work(); blas.reference)
    record.warnings.push_back(blas.name + " is many times slower than OpenBLAS: do not preload it");
}

}  // namespace

void require_solver(const Case& problem) {
  if (problem.solver == SolverType::multigrid && !multigrid_available())
    throw CaseError(problem.file.string(), "/solver/type", "found \"multigrid\", but " + multigrid_missing());
}

Summary run(const Case& problem, const RunOptions& options) {
  const auto start_time = std::chrono::steady_clock::now();
  const int threads = use_threads(problem.threads);
  if (std::holds_alternative<Projection>(problem.analysis)) return run_projection(problem, options, threads);
  if (std::holds_alternative<ExplicitDynamics>(problem.analysis)) return run_dynamics(problem, options, threads);
  require_solver(problem);
  const Counts before = counted();
  RunRecord record;
  warn_of_blas(record);
  Scene scene = build_scene(problem, record.phases);
  Summary summary = start(problem, scene, threads);

  Saving saving(problem, options.output, scene, record);
  Progress progress(options.quiet);
  const auto after_step = [&](int step) {
    saving.after_step(step);
    if (step < scene.load_steps) progress.begin(step + 1, scene.load_steps);
  };
  const auto finish = [&](bool completed, const std::string& message) {
    summary.completed = completed;
    summary.message = message;
    if (completed && problem.output.pictures)
      if (const auto warning =
              timed_effect(record, "pictures", "pictures", [&] { return make_pictures(options.output); }))
        record.warnings.push_back(*warning);
    summary.probes = scene.probes;
    take_over(record, std::chrono::duration<double>(std::chrono::steady_clock::now() - start_time).count(), summary);
    summary.counters = counts_since(before);
    write_summary(summary, options.output);
  };
  try {
    progress.begin(1, scene.load_steps);
    run_load_steps(scene,
                   {.condition_estimate = problem.condition_estimate,
                    .cut_fractions = problem.cut_fractions,
                    .error_estimate = problem.error_estimate,
                    .solver = problem.solver,
                    .after_step = after_step},
                   record);
    const bool radii = problem.exact && std::holds_alternative<ThickCylinder>(*problem.exact);
    if (scene.exact)
      summary.errors = timed_effect(record, "errors", "errors", [&] { return errors_of(scene, record, radii, 1.0); });
    if (problem.strain_energy)
      summary.strain_energy =
          timed_effect(record, "diagnostics", "strain_energy", [&] { return strain_energy(scene.points); });
  } catch (const ComputationError& error) {
    saving.rescue();
    finish(false, error.what());
    throw;
  } catch (const std::exception& error) {
    finish(false, error.what());
    throw;
  }
  finish(true, "");
  return summary;
}

}  // namespace shoreline
