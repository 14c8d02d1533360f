#pragma once
// What a run leaves behind, as plain data: one saved step, and the summary.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shoreline/boundary/displacement_fit.hpp"
#include "shoreline/engine/diagnostics.hpp"
#include "shoreline/engine/error_norms.hpp"
#include "shoreline/engine/probes.hpp"
#include "shoreline/engine/solver_choice.hpp"
#include "shoreline/engine/weight_report.hpp"

namespace shoreline {

/// What is saved of the body at the end of one load step beside its material points; step 0 is the start.
struct SavedStep {
  int step = 0;
  double t = 0.0;  ///< step/N of a quasi-static run [1], or [s]
  struct Curve {
    std::string name;
    Eigen::Matrix2Xd points;    ///< (2, tracking points) [m]
    Eigen::Matrix2Xd polyline;  ///< (2, m) the spline, sampled for drawing [m]
  };
  std::vector<Curve> curves;
  std::optional<Eigen::Matrix3Xd> strain{};                ///< (3, points), if the points do not keep it themselves
  std::optional<Eigen::Matrix2Xd> velocity{};              ///< (2, points) [m/s]; dynamics alone
  std::optional<Eigen::VectorXd> stress_error_estimate{};  ///< (points) |σ* − σ| [Pa]; last step, where asked for
};

/// Energies and momentum of the body at one time, per metre of thickness; dynamics alone.
struct HistoryState {
  double t = 0.0;                ///< [s]
  double kinetic = 0.0;          ///< [J/m]
  double strain = 0.0;           ///< [J/m]
  double gravity = 0.0;          ///< potential energy of the body force [J/m]
  Vec2 momentum = Vec2::Zero();  ///< [N s/m]
  [[nodiscard]] double total() const { return kinetic + strain + gravity; }
};

/// A field over the cells, sampled for drawing: triangles with values at their corners.
struct SampledField {
  Eigen::Matrix2Xd position;               ///< (2, n) [m]
  Eigen::VectorXd value;                   ///< (n)
  std::optional<Eigen::VectorXd> error{};  ///< (n) against the function that was projected
  Eigen::Matrix3Xi triangle;               ///< (3, t) numbers of positions
};

/// Norms of the error of a projection, (P.4), over the points with their weights.
struct ProjectionErrors {
  double l2 = 0.0;
  std::optional<double> l2_relative;                   ///< missing where the function vanishes
  std::optional<std::array<double, 2>> derivative_l2;  ///< of ∂/∂x and ∂/∂y; only with the gradient of the function
};

/// The error of the stress as recovery estimates it, (Z.2), (Z.3), over the components xx, yy, xy.
struct ErrorEstimate {
  double stress_l2 = 0.0;                    ///< η, the norm of ErrorNorms::stress_l2 [Pa m]
  std::optional<double> stress_l2_relative;  ///< over the norm of the recovered stress; missing where that vanishes
  Eigen::VectorXd stress_at_point;           ///< (points) |σ* − σ| [Pa]
  Index functions = 0;                       ///< that recovered it; far fewer than points, or the estimate is too small
};

/// Everything in summary.json.
struct Summary {
  std::string title;
  bool completed = false;
  std::string message;
  std::string analysis = "quasi_static";
  std::string basis;
  std::optional<int> degree;  ///< of a tensor-product B-spline
  Index degrees_of_freedom = 0;
  Index material_points = 0;
  int steps = 0;
  int threads = 1;
  std::string blas;                   ///< that the program ran on
  std::optional<SolverUse> solver{};  ///< of the last load step; quasi-static alone
  struct Effect {
    std::string name;
    long calls = 0;
    double seconds = 0.0;
  };
  std::vector<Effect> effects;
  /// How a dynamic run went in time.
  struct Dynamics {
    std::string law;                      ///< of the material
    bool objective = true;                ///< whether the law does not see rotations
    std::string mass;                     ///< form of the mass matrix
    double pic = 0.0;                     ///< share of PIC in the transfer to the points, 0 to 1; the rest is FLIP
    double damping = 0.0;                 ///< local, 0 to 1
    double end_time = 0.0;                ///< [s]
    double smallest_step = 0.0;           ///< [s]
    double largest_step = 0.0;            ///< [s]
    double critical_step_at_start = 0.0;  ///< [s]
    double smallest_critical_step = 0.0;  ///< [s]
    double time_of_smallest = 0.0;        ///< when the critical step was smallest [s]
    double courant = 0.0;                 ///< Δt √((λ+2μ)/ρ)/h at the start, h the smallest cell
    Index dropped_points = 0;             ///< material points that left the grid
  };
  std::optional<Dynamics> dynamics;
  std::vector<HistoryState> history;  ///< from the start on; dynamics alone
  std::optional<ErrorNorms> errors;
  std::optional<ErrorEstimate> error_estimate{};
  std::optional<ProjectionErrors> projection_errors;
  std::vector<std::pair<std::string, double>> timings;  ///< [s], in the order in which the phases first ran
  std::map<std::string, Vec3> reactions;                ///< Fx, Fy, M about the origin, per metre of thickness
  std::map<std::string, Vec3> loads;
  std::map<std::string, FitError> displacement_fit;  ///< per piece with a prescribed displacement
  std::vector<Probe> probes;
  std::optional<WeightReport> fitted_weights{};
  std::optional<double> condition_estimate;
  std::optional<Diagnostics> diagnostics;
  std::optional<double> strain_energy;  ///< (E.6) [J per metre of thickness]
  std::vector<std::string> warnings;
  double extended_share = 0.0;           ///< largest share of a piece that lies in cells without material points
  std::map<std::string, long> counters;  ///< how often things were done, see Work; and what else was counted
};

}  // namespace shoreline
