#include "shoreline/engine/linear_elastic.hpp"

#include <cmath>

#include "shoreline/bases/error.hpp"

namespace shoreline {

LinearElastic::LinearElastic(double youngs_modulus, double poissons_ratio, Plane plane)
    : youngs_modulus_(youngs_modulus) {
  if (!(youngs_modulus > 0.0) || !std::isfinite(youngs_modulus))
    throw InvalidArgument("LinearElastic: Young's modulus must be positive, got " + std::to_string(youngs_modulus));
  if (!(poissons_ratio > -1.0 && poissons_ratio < 0.5))
    throw InvalidArgument("LinearElastic: Poisson's ratio must lie in (-1, 0.5), got " +
                          std::to_string(poissons_ratio));
  const double mu = youngs_modulus / (2.0 * (1.0 + poissons_ratio));
  const double lambda = youngs_modulus * poissons_ratio / ((1.0 + poissons_ratio) * (1.0 - 2.0 * poissons_ratio));
  const double in_plane = plane == Plane::strain ? lambda : 2.0 * lambda * mu / (lambda + 2.0 * mu);
  out_of_plane_ = plane == Plane::strain ? lambda : 0.0;
  tangent_ << in_plane + 2.0 * mu, in_plane, 0.0, in_plane, in_plane + 2.0 * mu, 0.0, 0.0, 0.0, mu;
}

Stress LinearElastic::updated(const Stress& stress, const Vec3& strain_increment) const {
  Stress after = stress;
  after.head<3>() += tangent_ * strain_increment;
  after[3] += out_of_plane_ * (strain_increment[0] + strain_increment[1]);
  return after;
}

Mat3 LinearElastic::tangent(const Stress& /*stress*/) const { return tangent_; }

}  // namespace shoreline
