#pragma once
// Errors against an exact solution.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "shoreline/boundary/spline.hpp"
#include "shoreline/engine/exact_solutions.hpp"
#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// The deformed radius of a piece that was an arc about the origin, (N.6).
struct RadiusError {
  double mean = 0.0;           ///< along the deformed piece [m]
  double exact = 0.0;          ///< [m]
  double mean_relative = 0.0;  ///< mean of |r_h − r|/r
};

/// Norms of the error against the exact solution, (N.1)–(N.4). A relative error whose exact value vanishes is missing.
struct ErrorNorms {
  struct Component {
    std::optional<double> mean_relative;
    double mean_absolute = 0.0;
    double max_absolute = 0.0;
  };
  /// Errors over the steps of a dynamic run; h is computed, a exact.
  struct OverTime {
    std::string of;         ///< "displacement" [m], "velocity" [m/s] or "stress" [Pa]
    double rms = 0.0;       ///< root of the mean over points and times of |h − a|²: de Koster et al. 2020, (47)
    double mean_rms = 0.0;  ///< mean over the times of the root of the volume-weighted mean over points of |h − a|²
  };
  bool at_samples = false;  ///< measured at sample points, (N.9); else at the material points
  Index places = 0;         ///< how many of them
  std::optional<double> displacement_l2_relative;
  double displacement_l2 = 0.0;           ///< (Σ V |h − a|²)^½ [m²]
  std::array<Component, 2> displacement;  ///< u, v [m]
  std::optional<double> stress_l2_relative;
  double stress_l2 = 0.0;                                  ///< (Σ V |h − a|²)^½ [Pa m]
  std::array<Component, 3> stress;                         ///< xx, yy, xy [Pa]
  std::map<std::string, double> boundary_l2_displacement;  ///< per essential piece [m^1.5]
  std::map<std::string, RadiusError> boundary_radius;      ///< per arc of a thick cylinder
  std::vector<OverTime> over_time;                         ///< dynamics alone
};

/// Norms over material points or samples, weighted with their volumes, (N.1)–(N.4) (Bing et al. 2019, eqs 37–40).
///
/// Relative norms whose exact value vanishes at a point are missing.
[[nodiscard]] ErrorNorms error_norms(const MaterialPoints& points, const ExactSolution& exact, double t);

/// Radii of a tracked piece, sampled at 1000 points along its curve (Bing et al. 2019, §4.3), against those of the
/// exact solution, (N.6); nothing if the piece was no arc about the origin (radii equal to 1e-3).
///
/// @param original  the curve at the start; it has the spans of the curve now
[[nodiscard]] std::optional<RadiusError> radius_error(const SplineCurve& original, const SplineCurve& now,
                                                      const ExactSolution& exact, double t);

}  // namespace shoreline
