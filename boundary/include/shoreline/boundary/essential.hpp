#pragma once
// Essential conditions in the band of a D-function: the integrals across the band, and the terms along the curve.
//
// One family: implicit boundary method (Bing et al. 2019 §3.5) and symmetric Nitsche differ in one number.

#include "shoreline/bases/basis.hpp"
#include "shoreline/boundary/conditions.hpp"

namespace shoreline {

/// D(φ) = 1 − (1 − φ/δ)² in the band 0 <= φ <= δ, 0 outside the body, 1 beyond the band, (D.1).
/// @param distance  φ into the body [m]
/// @param width     δ > 0 [m]
[[nodiscard]] double d_function(double distance, double width);

/// dD/dφ, (D.2) [1/m].
[[nodiscard]] double d_function_slope(double distance, double width);

/// The two numbers of the family, (D.3): share c of the boundary traction, and penalty β [1/m].
struct BandIntegrals {
  double share;    ///< c = ∫ D D' dφ = ½ for the implicit boundary; 1 for Nitsche
  double penalty;  ///< β = ∫ D'² dφ = 4/(3δ)
};

/// @param width  δ > 0 [m]
[[nodiscard]] BandIntegrals band_integrals(EssentialMethod method, double width);

using ShortOperator = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, 2 * max_support>;

/// What an essential condition sees of a field d at one boundary point; P = I (fixed) or n nᵀ (roller), (D.4).
struct EdgeOperators {
  ShortOperator displacement;  ///< P M, (2, 2n): slip P u = (P M) d
  ShortOperator traction;      ///< P N C B, (2, 2n): P σ(u) n [Pa], n inward
  Mat2 stiffness;              ///< P (N C Nᵀ) P [Pa]: C_nn n nᵀ + G t tᵀ for an isotropic law
};

/// @param normal   n, unit and inward
/// @param tangent  C, (3, 3) Voigt [Pa]
[[nodiscard]] EdgeOperators edge_operators(const Support& support, const Vec2& normal, const Mat3& tangent,
                                           bool normal_only);

/// Voigt strain of d at one point: B, (3, 2n) [1/m], (S.2).
[[nodiscard]] Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2 * max_support> strain_operator(
    const ShortGradients& gradient);

}  // namespace shoreline
