#pragma once
// One time step of explicit dynamics.

#include "../grid_constraints.hpp"
#include "critical_step.hpp"
#include "fitted_quadrature.hpp"

namespace shoreline {

/// What outlives a step: memory, patterns, guesses.
class TimeStep {
 public:
  explicit TimeStep(DynamicScene& scene);

  /// What acts on the grid at the start of a step: boundary, supports, forces, mass, (Y.1)–(Y.7).
  /// @param dt  that is planned
  void begin(double t, double dt, DynamicRecord& record);

  /// Finds accelerations and velocities and moves the body, (Y.4), (Y.8)–(Y.11).
  /// @param wanted  whether reactions and loads are to be found
  /// @pre begin was called for the same time and step
  /// @throws ComputationError with point and place where the motion cannot go on
  void finish(double t, double dt, bool wanted, DynamicRecord& record);

  /// Critical step of the state that begin found; at most @p most iterations.
  double critical_step(int most, DynamicRecord& record);

  /// Which function moves fastest in the mode of the critical step, and how much material it sees.
  [[nodiscard]] std::string fastest_motion() const;

 private:
  void find_cells();
  void trace_boundary();
  void prescribe(double t, double dt);
  [[nodiscard]] Eigen::Matrix2Xd velocity_before(double t) const;
  void find_forces(double t, DynamicRecord& record);
  void add_load(std::size_t block);
  void damp();
  void hold(const Eigen::Matrix2Xd& prescribed, double dt);
  void report(double t, double dt, DynamicRecord& record);
  void drop_outside(double t, DynamicRecord& record);
  void require_sound(const MotionReport& motion) const;
  [[nodiscard]] StepState state(double t) const;
  [[nodiscard]] Index free_components() const;

  DynamicScene& scene_;
  std::unique_ptr<GhostMass> ghost_;          ///< none without
  std::unique_ptr<FittedQuadrature> fitted_;  ///< none where the weights are the volumes
  ElementTable table_;
  MovingPoints points_;
  PointPasses passes_;
  MassMatrix mass_;
  CriticalStep critical_;
  PointCells cells_;
  GridSums sums_;
  std::vector<Index> cell_;      ///< of every point
  bool occupied_others_ = true;  ///< than at the trace before
  std::vector<Edge> edges_;
  std::vector<Piece> traced_;             ///< of which they are the edges
  bool retraced_ = false;                 ///< whether an edge is new since conditions were looked at
  std::vector<HeldCellEdge> held_edges_;  ///< for which the constraints below hold
  Eigen::Matrix2Xd point_load_;           ///< (2, points) [N per metre], or no columns
  ElementBlocks blocks_;
  HeldComponents held_velocity_;
  HeldComponents held_acceleration_;
  HeldComponents held_mode_;
  double start_before_ = 0.0;    ///< of the step before [s]
  double planned_ = 0.0;         ///< step for which displacements are prescribed
  Eigen::Matrix2Xd prescribed_;  ///< increments of this step, or no columns
  std::map<std::string, FitError> fit_errors_;
  Eigen::Matrix2Xd prescribed_before_;  ///< velocity of the step before, or no columns
  Eigen::Matrix2Xd acceleration_, velocity_, momentum_, increment_;
};

}  // namespace shoreline
