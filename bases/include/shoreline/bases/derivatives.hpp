#pragma once
// Derivatives of one order of the functions that see a point.

#include "shoreline/bases/basis.hpp"

namespace shoreline {

using ShortDerivatives = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, max_support>;

/// The derivatives of order k at one point by the polynomials of one cell, (G.3).
///
/// Rows are scaled so that the scalar product of two columns is that of the tensors ∇ᵏφ: for k = 1 (∂x, ∂y), for k = 2
/// (∂xx, ∂yy, √2 ∂xy), for k = 3 (∂xxx, ∂yyy, √3 ∂xxy, √3 ∂xyy).
///
/// @param order  k, 1 to 3
/// @return       (k + 1, n) [1/mᵏ]
/// @throws InvalidArgument with the order if it is out of range
[[nodiscard]] ShortDerivatives derivatives(const Basis& basis, Index cell, const Vec2& x, int order);

/// The derivative of order k along a direction, (G.3): ∇ᵏφ times k copies of the direction.
/// @param direction  unit vector
/// @return           (n) [1/mᵏ]
/// @throws as derivatives
[[nodiscard]] ShortVector directional_derivative(const Basis& basis, Index cell, const Vec2& x, const Vec2& direction,
                                                 int order);

}  // namespace shoreline
