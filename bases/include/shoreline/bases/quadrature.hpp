#pragma once
// Gauss-Legendre quadrature on the unit interval.

#include <Eigen/Core>

namespace shoreline {

/// Points and weights on [0, 1]; the weights sum to 1.
struct QuadratureRule {
  Eigen::VectorXd point;
  Eigen::VectorXd weight;
};

/// The Gauss-Legendre rule with @p points points, exact for polynomials of degree 2·points − 1.
///
/// Points are the eigenvalues of the Jacobi matrix of the Legendre polynomials (Golub & Welsch 1969), (Q.1).
///
/// @throws InvalidArgument unless 1 <= points <= 64
[[nodiscard]] QuadratureRule gauss(int points);

}  // namespace shoreline
