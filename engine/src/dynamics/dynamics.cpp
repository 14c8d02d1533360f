#include "shoreline/engine/dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../motion_check.hpp"
#include "dynamic_probes.hpp"
#include "errors_over_time.hpp"
#include "shoreline/engine/failures.hpp"
#include "time_step.hpp"

namespace shoreline {
namespace {

constexpr int first_iterations = 60;  ///< of the critical step
constexpr int later_iterations = 4;
constexpr int steps_between = 100;      ///< two measures of it under a fixed time step
constexpr int steps_between_auto = 10;  ///< and under an automatic one

double smallest_cell(const Grid& grid) {
  double least = std::numeric_limits<double>::infinity();
  for (Index cell = 0; cell < grid.cells(); ++cell) least = std::min(least, grid.size(cell));
  return least;
}

/// The run of all steps.
class Stepping {
 public:
  Stepping(DynamicScene& scene, const DynamicOptions& options, DynamicRecord& record)
      : scene_(scene), options_(options), record_(record), step_(scene) {}

  void run() {
    start();
    options_.begins();
    record_history(0.0);
    const double end = scene_.settings.end_time;
    while (record_.t < end * (1.0 - 1e-12)) {
      advance(end);
    }
  }

  /// Finds the critical step and with it the first one.
  void start() {
    dt_ = scene_.settings.time_step.value_or(0.0);
    if (dt_ > 0.0) dt_ = scene_.settings.end_time / std::ceil(scene_.settings.end_time / dt_ * (1.0 - 1e-9));
    step_.begin(0.0, dt_ > 0.0 ? dt_ : scene_.settings.end_time, record_);
    critical_ = step_.critical_step(first_iterations, record_);
    record_.critical_step_at_start = record_.smallest_critical_step = critical_;
    if (dt_ > critical_)
      throw InvalidArgument(fmt::format(
          "found {:.4g} s, expected at most {:.4g} s, the critical step 2/sqrt(lambda_max) of this grid with the {} "
          "mass; take less, or \"auto\"",
          dt_, critical_, name_of(scene_.settings.mass)));
    choose_step();
    const double density = scene_.motion.mass.sum() / scene_.motion.volume.sum();
    record_.courant = dt_ * std::sqrt(scene_.law->wave_modulus() / density) / smallest_cell(scene_.body.basis->grid());
    record_.smallest_step = record_.largest_step = dt_;
  }

 private:
  void choose_step() {
    if (scene_.settings.time_step) return;
    dt_ = std::min(scene_.settings.safety * critical_, scene_.settings.end_time);
  }

  /// Measures the critical step anew from time to time.
  void watch() {
    const bool automatic = !scene_.settings.time_step;
    if (record_.steps % (automatic ? steps_between_auto : steps_between) != 0) return;
    measure_again(later_iterations);
    if (automatic) return choose_step();
    if (dt_ > critical_ && !warned_) {
      warned_ = true;
      record_.warnings.push_back(fmt::format(
          "step {} (t = {:.6g} s): the time step {:.4g} s is above the critical step, which is {:.4g} s now: {}",
          record_.steps + 1, record_.t, dt_, critical_, step_.fastest_motion()));
    }
  }

  void measure_again(int iterations) {
    critical_ = step_.critical_step(iterations, record_);
    if (critical_ >= record_.smallest_critical_step) return;
    record_.smallest_critical_step = critical_;
    record_.time_of_smallest = record_.t;
  }

  void advance(double end) {
    const int number = record_.steps + 1;
    double to = record_.t + dt_;
    try {
      if (number > 1) {
        step_.begin(record_.t, dt_, record_);
        watch();
      }
      to = record_.t + dt_ >= end * (1.0 - 1e-12) ? end : record_.t + dt_;
      const bool wanted = options_.wanted(number, to);
      if (records_energies(number)) record_.phases.time("history", [&] { before_ = energies(scene_, record_.t); });
      step_.finish(record_.t, to - record_.t, wanted, record_);
      if (wanted) record_.phases.time("boundary", [&] { check_motion(scene_.body); });
    } catch (const Error& error) {
      throw ComputationError(
          fmt::format("step {} (t = {:.6g} s): {}{}", number, to, error.what(), cause(to - record_.t)));
    }
    const double dt = to - record_.t;
    record_.steps = number;
    record_.t = to;
    record_.smallest_step = std::min(record_.smallest_step, dt);
    record_.largest_step = std::max(record_.largest_step, dt);
    record_history(dt);
    options_.after_step(number, to);
  }

  /// What made a motion fail, as far as can be told.
  std::string cause(double dt) {
    try {
      measure_again(first_iterations);
    } catch (const ComputationError&) {
      return "";  // the mass is what failed, as the message says
    }
    if (!std::isfinite(critical_)) return "";  // nothing is stiff, or nothing is left to measure
    if (dt <= critical_)
      return fmt::format("; the time step {:.4g} s is below the critical step, {:.4g} s: look at loads and law", dt,
                         critical_);
    const bool partly = scene_.settings.mass == MassForm::consistent;
    return fmt::format(
        "; the time step {:.4g} s is above the critical step, which has fallen from {:.4g} s to {:.2g} "
        "s: {}. Take {}a smaller time_step, or \"auto\"",
        dt, record_.critical_step_at_start, critical_, step_.fastest_motion(),
        partly ? "\"mass\": \"partly_lumped\", " : "");
  }

  [[nodiscard]] bool records_energies(int step) const { return scene_.history && step % *scene_.history == 0; }

  /// Energies at the middle of a step, where velocities live: those of position are the means of its ends.
  static void bring_to_middle(const HistoryState& before, HistoryState& after) {
    after.t = 0.5 * (before.t + after.t);
    after.strain = 0.5 * (before.strain + after.strain);
    after.gravity = 0.5 * (before.gravity + after.gravity);
  }

  /// @param dt  of the step before, 0 at the start
  void record_history(double dt) {
    const int every = scene_.history.value_or(1);
    if (record_.steps % every != 0) return;
    if (record_.steps > 0 && !scene_.body.probes.empty())
      record_.effects.time("probes", [&] { record_probes(scene_, record_.t, dt); });
    if (!records_energies(record_.steps)) return;
    record_.phases.time("history", [&] {
      record_.history.push_back(energies(scene_, record_.t));
      if (dt > 0.0) bring_to_middle(before_, record_.history.back());
      if (scene_.body.exact && dt > 0.0) {
        errors_.add(scene_, record_.t, dt);
        record_.errors_over_time = errors_.norms();
      }
    });
  }

  DynamicScene& scene_;
  const DynamicOptions& options_;
  DynamicRecord& record_;
  TimeStep step_;
  ErrorsOverTime errors_;
  HistoryState before_;  ///< the step whose end is recorded
  double dt_ = 0.0;
  double critical_ = 0.0;
  bool warned_ = false;
};

}  // namespace

PointMotion motion_at_rest(const MaterialPoints& points, double density) {
  PointMotion motion{.velocity = Eigen::Matrix2Xd::Zero(2, points.size()),
                     .deformation = Eigen::Matrix4Xd::Zero(4, points.size()),
                     .mass = density * points.volume,
                     .volume = points.volume};
  motion.deformation.row(0).setOnes();
  motion.deformation.row(3).setOnes();
  return motion;
}

void run_time_steps(DynamicScene& scene, const DynamicOptions& options, DynamicRecord& record) {
  Stepping(scene, options, record).run();
}

FirstStep first_step(DynamicScene& scene) {
  DynamicRecord record;
  const DynamicOptions options;
  Stepping(scene, options, record).start();
  return {record.critical_step_at_start, record.smallest_step, record.courant};
}

HistoryState energies(const DynamicScene& scene, double t) {
  HistoryState sum{.t = t};
  const MaterialPoints& points = scene.body.points;
  for (Index p = 0; p < points.size(); ++p) {
    const double m = scene.motion.mass[p];
    const Vec2 v = scene.motion.velocity.col(p);
    sum.kinetic += 0.5 * m * v.squaredNorm();
    sum.strain +=
        scene.motion.volume[p] *
        scene.law->energy(points.stress.col(p), Eigen::Map<const Mat2>(scene.motion.deformation.col(p).data()));
    sum.gravity -= m * scene.gravity.dot(Vec2(points.position.col(p)));
    sum.momentum += m * v;
  }
  return sum;
}

}  // namespace shoreline
