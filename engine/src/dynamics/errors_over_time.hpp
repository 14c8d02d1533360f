#pragma once
// Errors of a motion, averaged over its steps.

#include <cmath>

#include "shoreline/bases/counters.hpp"
#include "shoreline/engine/dynamics.hpp"

namespace shoreline {

/// Gathers |h − a|² of displacement, velocity and stress, (N.7), (N.8).
class ErrorsOverTime {
 public:
  /// Takes the state at time @p t, after a step of length @p dt: velocities are compared with the mean over the step.
  void add(const DynamicScene& scene, double t, double dt) {
    const MaterialPoints& points = scene.body.points;
    const ExactSolution& exact = *scene.body.exact;
    count(Work::exact_values, points.size());
    Eigen::Array3d plain = Eigen::Array3d::Zero();
    Eigen::Array3d weighted = Eigen::Array3d::Zero();
    for (Index p = 0; p < points.size(); ++p) {
      const Vec2 origin = points.position.col(p) - points.displacement.col(p);
      const Vec2 u = exact.displacement(origin, t);
      const Vec2 v = (u - exact.displacement(origin, t - dt)) / dt;
      const Eigen::Array3d square((points.displacement.col(p) - u).squaredNorm(),
                                  (scene.motion.velocity.col(p) - v).squaredNorm(),
                                  (points.stress.col(p).head<3>() - exact.stress(origin, t)).squaredNorm());
      plain += square;
      weighted += points.volume[p] * square;
    }
    squares_ += plain / points.size();
    roots_ += (weighted / points.volume.sum()).sqrt();
    ++times_;
  }

  [[nodiscard]] std::vector<ErrorNorms::OverTime> norms() const {
    std::vector<ErrorNorms::OverTime> norms;
    const char* const of[] = {"displacement", "velocity", "stress"};
    for (int k = 0; k < 3 && times_ > 0; ++k)
      norms.push_back({of[k], std::sqrt(squares_[k] / times_), roots_[k] / times_});
    return norms;
  }

 private:
  Eigen::Array3d squares_ = Eigen::Array3d::Zero();
  Eigen::Array3d roots_ = Eigen::Array3d::Zero();
  int times_ = 0;
};

}  // namespace shoreline
