#include "dynamic_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "../estimate_at_end.hpp"
#include "../make_basis.hpp"
#include "../record_in_summary.hpp"
#include "../saved_step.hpp"
#include "shoreline/engine/dynamics.hpp"
#include "shoreline/engine/error_norms.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/linear_solver.hpp"
#include "shoreline/engine/pictures.hpp"
#include "shoreline/engine/progress.hpp"
#include "shoreline/engine/results_writer.hpp"
#include "shoreline/engine/summary.hpp"

namespace shoreline {
namespace {

constexpr int saved_by_default = 50;

/// What a run puts into its output folder as it goes.
class DynamicSaving {
 public:
  DynamicSaving(const Case& problem, const std::filesystem::path& folder, DynamicScene& scene, DynamicRecord& record)
      : every_(problem.output.every), scene_(scene), record_(record), writer_(record.phases.time("output", [&] {
          return ResultsWriter(folder, problem.title, scene.body.basis->grid(), "explicit_dynamics");
        })) {
    save();
  }

  /// Whether the state after a step is to be saved.
  [[nodiscard]] bool wanted(int step, double t) const {
    const double end = scene_.settings.end_time;
    if (t >= end * (1.0 - 1e-12)) return true;
    if (every_ > 0) return step % every_ == 0;
    const auto part = [&](double time) { return std::floor(time / end * saved_by_default * (1.0 + 1e-12)); };
    return part(t) > part(record_.t);
  }

  void save() {
    record_.phases.time("output", [&] {
      const Eigen::Matrix4Xd& d = scene_.motion.deformation;
      SavedStep saved = saved_step(scene_.body, record_.steps, record_.t);
      saved.strain.row(0) = d.row(0).array() - 1.0;
      saved.strain.row(1) = d.row(3).array() - 1.0;
      saved.strain.row(2) = d.row(1) + d.row(2);
      saved.velocity = scene_.motion.velocity;
      if (record_.error_estimate) saved.stress_error_estimate = record_.error_estimate->stress_at_point;
      writer_.write(saved);
      writer_.append(scene_.body.probes);
      writer_.append(record_.history);
    });
    last_ = record_.steps;
  }

  /// After a failure: what was computed since the last saved step.
  void rescue() {
    if (record_.steps > last_) save();
  }

 private:
  int every_;
  DynamicScene& scene_;
  DynamicRecord& record_;
  ResultsWriter writer_;
  int last_ = 0;
};

Summary start(const Case& problem, const DynamicScene& scene, int threads) {
  Summary summary;
  summary.title = problem.title;
  summary.analysis = "explicit_dynamics";
  name_basis(problem.grid, summary);
  summary.material_points = scene.body.points.size();
  summary.threads = threads;
  summary.blas = blas_name();
  const ExplicitDynamics& settings = scene.settings;
  summary.dynamics = Summary::Dynamics{.law = scene.law->name(),
                                       .objective = scene.law->objective(),
                                       .mass = name_of(settings.mass),
                                       .pic = settings.pic,
                                       .damping = settings.damping,
                                       .end_time = settings.end_time};
  return summary;
}

void take_over(const DynamicRecord& record, double total, Summary& summary) {
  take_over_common(record, total, summary);
  summary.history = record.history;
  summary.counters = {{"mass_iterations", record.mass_iterations},
                      {"critical_step_iterations", record.critical_step_iterations}};
  Summary::Dynamics& dynamics = *summary.dynamics;
  dynamics.smallest_step = record.smallest_step;
  dynamics.largest_step = record.largest_step;
  dynamics.critical_step_at_start = record.critical_step_at_start;
  dynamics.smallest_critical_step = record.smallest_critical_step;
  dynamics.time_of_smallest = record.time_of_smallest;
  dynamics.courant = record.courant;
  dynamics.dropped_points = record.dropped;
}

/// Of the stress at the end; a time step moves the points so little that it does not matter where they were before it.
void estimate(const Scene& body, DynamicRecord& record) {
  const PointSupports supports =
      record.phases.time("estimate", [&] { return locate_points(*body.basis, body.points); });
  estimate_at_end(body, supports, record);
}

/// What the library calls an invalid time step is that of the case.
template <class Steps>
auto with_place(const Case& problem, Steps&& steps) {
  try {
    return steps();
  } catch (const InvalidArgument& error) {
    throw CaseError(problem.file.string(), "/analysis/time_step", error.what());
  }
}

double bytes_of(const DynamicScene& scene, const PointSupports& cells) {
  const double n = scene.body.basis->functions_per_cell();
  const double points = scene.body.points.size();
  const double per_point = 8.0 * (12.0 + 8.0) + 12.0;  // state and motion; cell and order
  const double functions = scene.body.basis->functions();
  const double elements = static_cast<double>(scene.body.basis->grid().cells()) / scene.body.basis->grid().parts();
  const bool matrix = scene.settings.mass != MassForm::lumped;
  const double block = 8.0 * n * (3.0 + (matrix ? n : 0.0));
  const double table = elements * n * (12.0 + (matrix ? 4.0 * n : 0.0)) + scene.body.basis->grid().cells() * (n + 5.0);
  const double row = matrix ? 12.0 * 3.0 * n : 0.0;
  constexpr double program = 2.2e7;
  // fitted: values and gradients at the points, blocks of 6 n rows and their places, matrix, its copy and factors
  const double occupied = static_cast<double>(cells.cells()) / scene.body.basis->grid().parts();
  const double fitted = scene.body.fitted ? points * 8.0 * (3.0 * n + 6.0) + occupied * 18.0 * n * n * 12.0 +
                                                functions * 6.0 * 18.0 * n * 60.0
                                          : 0.0;
  return fitted + program + points * per_point + cells.cells() * block + table + functions * (row + 8.0 * 16.0);
}

}  // namespace

Summary run_dynamics(const Case& problem, const RunOptions& options, int threads) {
  const auto start_time = std::chrono::steady_clock::now();
  DynamicRecord record;
  DynamicScene scene = record.phases.time("setup", [&] { return build_dynamic_scene(problem); });
  Summary summary = start(problem, scene, threads);
  std::optional<DynamicSaving> saving;
  Progress progress(options.quiet);
  bool saves = false;
  const DynamicOptions steps{.begins = [&] { saving.emplace(problem, options.output, scene, record); },
                             .wanted = [&](int step, double t) { return saves = saving->wanted(step, t); },
                             .after_step =
                                 [&](int, double t) {
                                   if (problem.error_estimate && t >= scene.settings.end_time)
                                     estimate(scene.body, record);
                                   if (saves) saving->save();
                                   progress.reach(t, scene.settings.end_time);
                                 }};
  const auto finish = [&](bool completed, const std::string& message) {
    summary.completed = completed;
    summary.message = message;
    if (problem.output.pictures)
      if (const auto warning = record.phases.time("pictures", [&] { return make_pictures(options.output); }))
        record.warnings.push_back(*warning);
    summary.probes = scene.body.probes;
    take_over(record, std::chrono::duration<double>(std::chrono::steady_clock::now() - start_time).count(), summary);
    write_summary(summary, options.output);
  };
  try {
    with_place(problem, [&] { run_time_steps(scene, steps, record); });
    if (scene.body.exact)
      summary.errors = record.phases.time("errors", [&] {
        ErrorNorms norms = error_norms(scene.body.points, *scene.body.exact, record.t);
        norms.over_time = record.errors_over_time;
        return norms;
      });
  } catch (const ComputationError& error) {
    saving->rescue();
    finish(false, error.what());
    throw;
  }
  finish(true, "");
  return summary;
}

std::string plan_dynamics(const Case& problem) {
  DynamicScene scene = build_dynamic_scene(problem);
  const FirstStep first = with_place(problem, [&] { return first_step(scene); });
  std::string effects = fmt::format("  {}\n  mass: {}\n", scene.law->name(), name_of(scene.settings.mass));
  std::string left_out;
  const auto effect = [&](bool named, const char* name, const char* why) {
    if (named)
      effects += fmt::format("  {}\n", name);
    else
      left_out += fmt::format("  {:<20}{}\n", name, why);
  };
  effect(problem.gravity || problem.gravity_field, "gravity", "no key gravity");
  effect(problem.body_force.has_value(), "body_force", "no key body_force");
  effect(scene.settings.damping > 0.0, "damping", "analysis.damping is 0");
  effect(problem.history.has_value(), "history", "no key history");
  effect(problem.exact.has_value(), "errors", "no key exact");
  effect(problem.error_estimate, "error estimate", "diagnostics.error_estimate is false");
  for (const auto& load : scene.body.contributions) effects += "  " + load->name() + "\n";
  for (const BoundaryPiece& b : scene.body.boundary)
    if (std::holds_alternative<Essential>(b.condition)) effects += "  grid:" + b.piece.name + "\n";
  for (const Probe& probe : scene.body.probes) effects += "  probe:" + probe.name + "\n";
  const PointSupports cells = locate_points(*scene.body.basis, scene.body.points);
  const Grid& grid = scene.body.basis->grid();
  return fmt::format(
      "{}\n\nwill run\n{}\nwill not run\n{}\nsizes\n  basis               {}\n"
      "  grid                {} elements of {} {}, {} cells with material\n  material points     {}\n"
      "  time step           {:.4g} s{}, critical {:.4g} s, Courant number {:.2g}\n  steps               {}{:.0f}\n"
      "  predicted memory    {:.0f} MB\n",
      problem.title, effects, left_out.empty() ? "  nothing\n" : left_out, name_of(problem.grid.basis),
      grid.cells() / grid.parts(), grid.parts(), grid.parts() == 1 ? "cell" : "cells", cells.cells(),
      scene.body.points.size(), first.dt, scene.settings.time_step ? "" : " at the start", first.critical,
      first.courant, scene.settings.time_step ? "" : "about ", std::ceil(scene.settings.end_time / first.dt - 1e-9),
      bytes_of(scene, cells) / 1e6);
}

}  // namespace shoreline
