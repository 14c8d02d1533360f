#pragma once
// Quadrature weights at given points that integrate polynomials exactly over the part of a cell inside the outline.

#include "shoreline/bases/types.hpp"

namespace shoreline {

/// Share of its plain weight below which no fitted one falls: no point gets a negative stiffness.
inline constexpr double least_weight = 0.05;

/// How many points of a cell it takes to fit their weights to its moments up to an order: 1.5 a moment.
[[nodiscard]] constexpr Eigen::Index points_for(int order) {
  const Eigen::Index moments = static_cast<Eigen::Index>(order + 1) * (order + 2) / 2;
  return (3 * moments + 1) / 2;
}

/// The weights nearest to plain ones that reproduce the moments of what is covered, (W.1):
///
///     min Σ (w_p − v_p)²/v_p  with  Σ w_p ξ_p^a η_p^b = ∫ ξ^a η^b dA, a + b <= k,  and  w_p >= 0.05 v_p,
///
/// v the plain weights times the ratio of covered area to their sum. Its multipliers are found by Newton's method,
/// (W.2). k is the highest order of the moments given that v meets, or for which there are points_for(k) points and
/// such weights; v has the area, k = 0.
///
/// @param x        (2, n) places of the points about the centre of the moments [m]; n >= 1
/// @param size     of the cell [m]
/// @param moments  ordered (0,0) (1,0) (0,1) (2,0) …; the first, the area, is positive
/// @param weight   (n) in: the plain weights, positive; out: the fitted ones [m²]
/// @return k
int fit_weights(const Eigen::Ref<const Eigen::Matrix2Xd>& x, double size,
                const Eigen::Ref<const Eigen::VectorXd>& moments, Eigen::Ref<Eigen::VectorXd> weight);

/// Whether fit_weights would meet all the moments given.
[[nodiscard]] bool can_meet(const Eigen::Ref<const Eigen::Matrix2Xd>& x, double size,
                            const Eigen::Ref<const Eigen::VectorXd>& moments,
                            const Eigen::Ref<const Eigen::VectorXd>& plain);

}  // namespace shoreline
