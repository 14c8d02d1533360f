#pragma once
// The three passes of a time step over the material points, in the order of their cells.

#include <optional>

#include "element_table.hpp"
#include "shoreline/engine/dynamics.hpp"

namespace shoreline {

/// Sums over the points on the grid.
struct GridSums {
  Eigen::VectorXd mass;       ///< (functions) Σ m φ_i, the row sums [kg per metre]
  Eigen::Matrix2Xd force;     ///< (2, functions) Σ f_p φ_i − V σ ∇φ_i [N per metre]
  std::vector<double> block;  ///< (occupied elements · n · n) Σ m φ_i φ_j, where asked for
};

/// Why a point cannot go on.
enum class Fault { none, not_finite, inverted, too_fast };

/// What the motion of the points brought up.
struct MotionReport {
  bool crossed = false;  ///< whether a point has come to another cell
  Index outside = 0;     ///< points that left the grid
  Fault fault = Fault::none;
  Index point = -1;  ///< the first with that fault
};

/// A motion by the fields of a step.
struct StepMotion {
  const Eigen::Matrix2Xd& velocity;  ///< (2, functions) [m/s]
  double dt;                         ///< [s]
  double pic;                        ///< share of the field in the velocity of a point, (Y.9)
};

/// The points of a scene with what dynamics adds to them.
struct MovingPoints {
  MaterialPoints& state;
  PointMotion& motion;
  const Eigen::VectorXd& weight;  ///< of the stress in the forces [m³ per metre]: the volumes, or fitted weights
};

/// Where they sit.
struct PointCells {
  PointSupports supports;  ///< without values and gradients: passes evaluate the basis as they go
  OccupiedElements occupied;
};

/// Works on the points of a scene, grouped by cells; results do not depend on the number of threads.
class PointPasses {
 public:
  PointPasses(const Basis& basis, const ElementTable& table) : basis_(basis), table_(table) {}

  /// Mass and force on the grid, (Y.2), (Y.3).
  /// @param load  (2, points) force on each point [N per metre], or no columns
  void mass_and_force(const MovingPoints& points, const PointCells& cells, const Eigen::Matrix2Xd& load,
                      bool with_blocks, GridSums& sums);

  /// Adds Δt a to the velocities of the points and gives their momentum on the grid, (Y.8).
  /// @param acceleration  (2, functions) [m/s²]
  /// @param momentum      (2, functions) [N s per metre]
  void accelerate(const MovingPoints& points, const PointCells& cells, const Eigen::Matrix2Xd& acceleration, double dt,
                  Eigen::Matrix2Xd& momentum);

  /// Moves the points by the velocity field, with deformation, volume and stress, (Y.10), (Y.11), and finds the cells
  /// where they come to be.
  /// @param cell  (points) of each point after the motion, −1 outside the grid
  MotionReport move(const MovingPoints& points, const PointCells& cells, const LargeStrainMaterial& law,
                    const StepMotion& motion, std::vector<Index>& cell);

  /// K w, the force that a small displacement field w brings about at the present stress, (Y.14).
  /// @param field  (2, functions)
  /// @param force  (2, functions)
  void stiffness_times(const MovingPoints& points, const PointCells& cells, const LargeStrainMaterial& law,
                       const Eigen::Matrix2Xd& field, Eigen::Matrix2Xd& force);

 private:
  const Basis& basis_;
  const ElementTable& table_;
  std::vector<double> blocks_;
  std::vector<double> sums_;
};

}  // namespace shoreline
