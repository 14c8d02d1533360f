#include "dynamic_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "../effect_list.hpp"
#include "../estimate_at_end.hpp"
#include "../make_basis.hpp"
#include "../record_in_summary.hpp"
#include "../saved_step.hpp"
#include "../timed_effect.hpp"
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

/// Of the deformation gradient, (4, points) row by row: xx, yy, xy (engineering).
Eigen::Matrix3Xd strain_of(const Eigen::Matrix4Xd& deformation) {
  Eigen::Matrix3Xd strain(3, deformation.cols());
  strain.row(0) = deformation.row(0).array() - 1.0;
  strain.row(1) = deformation.row(3).array() - 1.0;
  strain.row(2) = deformation.row(1) + deformation.row(2);
  return strain;
}

/// What a run puts into its output folder as it goes.
class DynamicSaving {
 public:
  DynamicSaving(const Case& problem, const std::filesystem::path& folder, DynamicScene& scene, DynamicRecord& record)
      : every_(problem.output.every),
        strain_(problem.output.strain),
        scene_(scene),
        record_(record),
        writer_(record.phases.time("output", [&] {
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
      SavedStep saved = saved_step(scene_.body, record_.steps, record_.t);
      if (strain_) saved.strain = strain_of(scene_.motion.deformation);
      saved.velocity = scene_.motion.velocity;
      if (record_.error_estimate) saved.stress_error_estimate = record_.error_estimate->stress_at_point;
      writer_.write(saved, scene_.body.points);
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
  bool strain_;
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
  summary.counters["mass_iterations"] = record.mass_iterations;
  summary.counters["critical_step_iterations"] = record.critical_step_iterations;
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
  const Counts before = counted();
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
      if (const auto warning =
              timed_effect(record, "pictures", "pictures", [&] { return make_pictures(options.output); }))
        record.warnings.push_back(*warning);
    summary.probes = scene.body.probes;
    summary.counters = counts_since(before);
    take_over(record, std::chrono::duration<double>(std::chrono::steady_clock::now() - start_time).count(), summary);
    write_summary(summary, options.output);
  };
  try {
    with_place(problem, [&] { run_time_steps(scene, steps, record); });
    if (scene.body.exact)
      summary.errors = timed_effect(record, "errors", "errors", [&] {
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
  EffectList list;
  list.add(true, scene.law->name(), "gradients at the material points, and their stress", "");
  list.add(true, fmt::format("mass: {}", name_of(scene.settings.mass)), "values at the material points", "");
  const bool weight = problem.gravity || problem.gravity_field;
  list.add(weight, "gravity", "the mass of each function", "no key gravity");
  list.add(problem.body_force.has_value(), "body_force", "values at the material points", "no key body_force");
  list.add(scene.settings.damping > 0.0, "damping", "the force on each function", "analysis.damping is 0");
  list.add(problem.history.has_value(), "history", "sums over the material points", "no key history");
  add_common_effects(problem, scene.body, list);
  const PointSupports cells = locate_points(*scene.body.basis, scene.body.points);
  const Grid& grid = scene.body.basis->grid();
  return fmt::format(
      "{}\n\n{}\nsizes\n  basis               {}\n"
      "  grid                {} elements of {} {}, {} cells with material\n  material points     {}\n"
      "  time step           {:.4g} s{}, critical {:.4g} s, Courant number {:.2g}\n  steps               {}{:.0f}\n"
      "  predicted memory    {:.0f} MB\n",
      problem.title, text_of(list), name_of(problem.grid.basis), grid.cells() / grid.parts(), grid.parts(),
      grid.parts() == 1 ? "cell" : "cells", cells.cells(), scene.body.points.size(), first.dt,
      scene.settings.time_step ? "" : " at the start", first.critical, first.courant,
      scene.settings.time_step ? "" : "about ", std::ceil(scene.settings.end_time / first.dt - 1e-9),
      bytes_of(scene, cells) / 1e6);
}

}  // namespace shoreline
