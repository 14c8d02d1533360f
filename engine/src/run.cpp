#include "shoreline/engine/run.hpp"

#include <omp.h>

#include <chrono>
#include <variant>

#include "shoreline/engine/linear_solver.hpp"
#include "shoreline/engine/pictures.hpp"
#include "shoreline/engine/progress.hpp"
#include "shoreline/engine/quasi_static.hpp"
#include "shoreline/engine/results_writer.hpp"
#include "shoreline/engine/summary.hpp"

namespace shoreline {
namespace {

constexpr int samples_per_span = 16;  ///< of a curve that is drawn

Eigen::Matrix2Xd sampled(const SplineCurve& curve) {
  Eigen::Matrix2Xd line(2, static_cast<Eigen::Index>(curve.spans.size()) * samples_per_span + 1);
  Eigen::Index n = 0;
  line.col(n++) = curve.spans.front().position(0.0);
  for (const CubicSpan& span : curve.spans)
    for (int k = 1; k <= samples_per_span; ++k)
      line.col(n++) = span.position(static_cast<double>(k) / samples_per_span);
  return line;
}

SavedStep saved_step(const Scene& scene, int step) {
  SavedStep saved{.step = step,
                  .t = static_cast<double>(step) / scene.load_steps,
                  .position = scene.points.position,
                  .displacement = scene.points.displacement,
                  .stress = scene.points.stress,
                  .strain = scene.points.strain,
                  .volume = scene.points.volume,
                  .curves = {}};
  for (const BoundaryPiece& b : scene.boundary) {
    Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(b.piece.points.size()));
    for (Eigen::Index k = 0; k < points.cols(); ++k) points.col(k) = b.piece.points[static_cast<std::size_t>(k)];
    saved.curves.push_back({b.piece.name, std::move(points), sampled(fit_spline(b.piece))});
  }
  return saved;
}

std::vector<SplineCurve> curves_of(const Scene& scene) {
  std::vector<SplineCurve> curves;
  for (const BoundaryPiece& b : scene.boundary) curves.push_back(fit_spline(b.piece));
  return curves;
}

ErrorNorms errors_of(const Scene& scene, const std::vector<SplineCurve>& original, double t) {
  ErrorNorms norms = error_norms(scene.points, *scene.exact, t);
  const std::vector<SplineCurve> now = curves_of(scene);
  for (std::size_t k = 0; k < now.size(); ++k)
    if (const auto* condition = std::get_if<Essential>(&scene.boundary[k].condition))
      norms.boundary_l2_displacement[scene.boundary[k].piece.name] =
          boundary_error(original[k], now[k], condition->normal_only, *scene.exact, t);
  return norms;
}

/// What the record of a run tells, in the form of the summary.
/// @param total  since the start of the run [s]
void take_over(const RunRecord& record, double total, Summary& summary) {
  summary.steps = record.steps;
  summary.degrees_of_freedom = record.degrees_of_freedom;
  summary.effects.clear();
  for (const Clock::Entry& e : record.effects.entries()) summary.effects.push_back({e.name, e.calls, e.seconds});
  summary.timings = {{"total", total}};
  for (const Clock::Entry& e : record.phases.entries()) summary.timings.emplace_back(e.name, e.seconds);
  summary.loads = record.resultants.loads;
  summary.reactions = record.resultants.reactions;
  summary.condition_estimate = record.condition_estimate;
  summary.extended_share = record.extended_share;
  summary.counters = {{"factorisations", record.factorisations}, {"analyses", record.analyses}};
}

Summary start(const Case& problem, const Scene& scene, int threads) {
  Summary summary;
  summary.title = problem.title;
  summary.basis = "bilinear";
  summary.material_points = scene.points.size();
  summary.threads = threads;
  return summary;
}

int use_threads(int asked) {
  const int threads = asked > 0 ? asked : omp_get_num_procs();
  omp_set_num_threads(threads);
  set_blas_threads(threads);
  return threads;
}

}  // namespace

Summary run(const Case& problem, const RunOptions& options) {
  const auto start_time = std::chrono::steady_clock::now();
  const int threads = use_threads(problem.threads);
  RunRecord record;
  Scene scene = record.phases.time("setup", [&] { return build_scene(problem); });
  Summary summary = start(problem, scene, threads);

  ResultsWriter writer(options.output, problem.title, scene.basis->grid());
  const auto save = [&](int step) { record.phases.time("output", [&] { writer.write(saved_step(scene, step)); }); };
  save(0);
  Progress progress(problem.load_steps, options.quiet);
  const std::vector<SplineCurve> original = curves_of(scene);
  const auto after_step = [&](int step) {
    if (step % problem.output.every == 0 || step == problem.load_steps) save(step);
    if (step < problem.load_steps) progress.begin(step + 1);
  };
  const auto finish = [&](bool completed, const std::string& message) {
    summary.completed = completed;
    summary.message = message;
    if (completed && problem.output.pictures)
      if (const auto warning = record.phases.time("pictures", [&] { return make_pictures(options.output); }))
        record.warnings.push_back(*warning);
    take_over(record, std::chrono::duration<double>(std::chrono::steady_clock::now() - start_time).count(), summary);
    summary.warnings = record.warnings;
    write_summary(summary, options.output);
  };
  try {
    progress.begin(1);
    run_load_steps(scene, {.condition_estimate = problem.condition_estimate, .after_step = after_step}, record);
    if (scene.exact) summary.errors = record.phases.time("errors", [&] { return errors_of(scene, original, 1.0); });
  } catch (const std::exception& error) {
    finish(false, error.what());
    throw;
  }
  finish(true, "");
  return summary;
}

}  // namespace shoreline
