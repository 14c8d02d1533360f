#pragma once
// Explicit dynamics: time steps of the material point method.

#include <functional>

#include "shoreline/engine/clock.hpp"
#include "shoreline/engine/large_strain_material.hpp"
#include "shoreline/engine/results.hpp"
#include "shoreline/engine/scene.hpp"

namespace shoreline {

/// What dynamics carries at the material points beside MaterialPoints; column p belongs to point p.
struct PointMotion {
  Eigen::Matrix2Xd velocity;     ///< at t − Δt/2 [m/s]
  Eigen::Matrix4Xd deformation;  ///< D as (D_xx, D_yx, D_xy, D_yy)
  Eigen::VectorXd mass;          ///< constant [kg per metre of thickness]
  Eigen::VectorXd volume;        ///< at the start [m³ per metre of thickness]
};

/// A field over the body as a function of place and time.
using FieldOnPoints = std::function<Vec2(const PlaceTime&)>;

/// A body in motion: what its case names, and nothing of any other effect.
struct DynamicScene {
  Scene body;  ///< its contributions are loads on the boundary; without a small-strain material
  std::shared_ptr<const LargeStrainMaterial> law;
  PointMotion motion;
  ExplicitDynamics settings;
  Vec2 gravity = Vec2::Zero();   ///< [m/s²]
  FieldOnPoints gravity_field;   ///< beside it, as a function of place and time [m/s²]; empty: none
  FieldOnPoints body_force;      ///< per current volume [N/m³]; empty: none
  std::optional<int> history{};  ///< steps between two records of energies and momentum
};

/// Points at rest with density ρ.
[[nodiscard]] PointMotion motion_at_rest(const MaterialPoints& points, double density);

/// Turns a case into a scene.
/// @throws CaseError as build_scene, and for conditions that explicit steps cannot carry
[[nodiscard]] DynamicScene build_dynamic_scene(const Case& problem);

/// What the time steps did and cost; filled as they go.
struct DynamicRecord {
  int steps = 0;                 ///< completed
  double t = 0.0;                ///< at the end of the last one [s]
  Index degrees_of_freedom = 0;  ///< components with mass that are not held, of the last step
  Clock phases;
  Clock effects;
  Resultants resultants;                       ///< at the last step that was reported, see DynamicOptions
  std::map<std::string, FitError> fit_errors;  ///< by piece that prescribes a displacement, summed over the steps
  std::vector<std::string> warnings;
  std::vector<HistoryState> history;  ///< at the start, then at the middle of steps, where velocities live
  std::vector<ErrorNorms::OverTime> errors_over_time;  ///< with an exact solution and a history
  double smallest_step = 0.0;                          ///< Δt [s]
  double largest_step = 0.0;
  double critical_step_at_start = 0.0;    ///< 2/√λ_max(M⁻¹K), (Y.13) [s]
  double smallest_critical_step = 0.0;    ///< of those that were measured
  double time_of_smallest = 0.0;          ///< [s]
  double courant = 0.0;                   ///< Δt √((λ+2μ)/ρ)/h at the start, h the smallest cell
  Index dropped = 0;                      ///< points that left the grid and were dropped
  std::optional<WeightReport> weights{};  ///< of all fits; with fitted weights alone
  long critical_step_iterations = 0;      ///< products K w
  long mass_iterations = 0;               ///< of conjugate gradients
  /// Of the stress at the end, where asked for.
  std::optional<ErrorEstimate> error_estimate{};
};

struct DynamicOptions {
  /// Called once the time step is known to be stable, before the first step.
  std::function<void()> begins = [] {};
  /// Whether results are wanted after a step: then resultants are found. Called before the step ends with its number
  /// and time.
  std::function<bool(int, double)> wanted = [](int, double) { return false; };
  /// Called after every completed step.
  std::function<void(int, double)> after_step = [](int, double) {};
};

/// Runs the time steps of a scene to its end time, (Y.1)–(Y.12).
///
/// Velocities live at t − Δt/2 (Euler-Cromer). A case without a boundary condition moves freely.
///
/// @throws InvalidArgument    before the first step, if that of the settings is above the critical one
/// @throws ComputationError   with step, time, point and likely cause where the motion cannot go on; the state is then
///                            that at the end of the step record.steps
void run_time_steps(DynamicScene& scene, const DynamicOptions& options, DynamicRecord& record);

/// The time step at the start.
struct FirstStep {
  double critical;  ///< [s]
  double dt;        ///< that the settings of the scene choose [s]
  double courant;
};

/// What a run would begin with.
/// @throws as run_time_steps before its first step
[[nodiscard]] FirstStep first_step(DynamicScene& scene);

/// Energies and momentum of the body now, (Y.15), (Y.16); gravity_field and body_force have no energy here.
[[nodiscard]] HistoryState energies(const DynamicScene& scene, double t);

}  // namespace shoreline
