#pragma once
// Isotropic linear elasticity in plane strain or plane stress.

#include "shoreline/engine/material.hpp"

namespace shoreline {

enum class Plane { strain, stress };

/// Δσ = D Δε with λ, μ of (M.1); plane stress replaces λ by λ̄ = 2λμ/(λ + 2μ), (M.2); σ_zz = λ(ε_xx + ε_yy) in plane
/// strain, 0 in plane stress.
class LinearElastic final : public Material {
 public:
  /// @param youngs_modulus  E > 0 [Pa]
  /// @param poissons_ratio  ν in (−1, ½)
  /// @throws InvalidArgument with the value
  LinearElastic(double youngs_modulus, double poissons_ratio, Plane plane);

  [[nodiscard]] std::string name() const override { return "linear_elastic"; }
  [[nodiscard]] Stress updated(const Stress& stress, const Vec3& strain_increment) const override;
  [[nodiscard]] Mat3 tangent(const Stress& stress) const override;
  [[nodiscard]] bool constant_tangent() const override { return true; }
  [[nodiscard]] double stiffness() const override { return youngs_modulus_; }

 private:
  double youngs_modulus_;
  double out_of_plane_;  ///< dσ_zz/d(ε_xx + ε_yy) [Pa]
  Mat3 tangent_;
};

}  // namespace shoreline
