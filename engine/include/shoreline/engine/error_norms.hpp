#pragma once
// Errors against an exact solution.

#include "shoreline/boundary/spline.hpp"
#include "shoreline/engine/exact_solutions.hpp"
#include "shoreline/engine/material_points.hpp"
#include "shoreline/engine/results.hpp"

namespace shoreline {

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
