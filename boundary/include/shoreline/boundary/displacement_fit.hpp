#pragma once
// Coefficients that reproduce a prescribed displacement along curves.

#include <span>

#include "shoreline/bases/basis.hpp"
#include "shoreline/boundary/edge.hpp"

namespace shoreline {

/// A curve along which the displacement, or its component across the curve, is prescribed.
struct HeldEdge {
  const Edge& edge;
  bool normal_only;        ///< P = n nᵀ, else I
  Eigen::Matrix2Xd value;  ///< u_a at every boundary point of the edge [m]
};

/// How far a fit is from what was prescribed, P(M d − u_a), on one curve.
struct FitError {
  double l2 = 0.0;    ///< √∫ |·|² dS [m^1.5]
  double mean = 0.0;  ///< ∫ |·| dS over the length [m]
};

struct DisplacementFit {
  Eigen::Matrix2Xd coefficient;  ///< (2, functions) d_a [m]; zero away from the curves
  std::vector<FitError> error;   ///< of every edge
};

/// Least-squares fit of all curves together, (D.8) (Bing et al. 2019, eqs 34–36):
///
///     (∫ Mᵀ P M dS + ε Σ h^(2p+1) [∇ᵖM]ᵀ[∇ᵖM] + η ∫ h² ∇Mᵀ ∇M dS + κ I) d_a = ∫ Mᵀ P u_a dS.
///
/// Jumps [·] are taken where a curve passes from one cell to the next. They decide what a trace leaves open where a
/// cell is barely touched, without a say in polynomials of degree p; η and κ, far smaller, decide what then is still
/// open (the slope across a straight line, the tangential component on a roller).
[[nodiscard]] DisplacementFit fit_displacement(const Basis& basis, std::span<const HeldEdge> edges);

}  // namespace shoreline
