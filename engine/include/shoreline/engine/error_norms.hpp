#pragma once
// Errors against an exact solution.

#include <functional>
#include <utility>

#include "shoreline/engine/contribution.hpp"
#include "shoreline/engine/results.hpp"

namespace shoreline {

/// An exact solution as a function of the original position and time.
struct ExactSolution {
  std::function<Vec2(const Vec2&, double)> displacement;  ///< [m]
  std::function<Vec3(const Vec2&, double)> stress;        ///< xx, yy, xy [Pa]
};

/// Norms over the material points, weighted with their volumes, (N.1)–(N.4) (Bing et al. 2019, eqs 37–40).
///
/// Relative norms whose exact value vanishes at a point are missing.
[[nodiscard]] ErrorNorms error_norms(const MaterialPoints& points, const ExactSolution& exact, double t);

/// √(∫ |P(u_h − u)|² dS) along a tracked piece [m], (N.5), where u_h is how far its curve has moved.
///
/// @param original     the curve at the start; it has the spans of the curve now
/// @param normal_only  P = n nᵀ (roller), else I
[[nodiscard]] double boundary_error(const SplineCurve& original, const SplineCurve& now, bool normal_only,
                                    const ExactSolution& exact, double t);

}  // namespace shoreline
