#pragma once
// Laws at large strain, in plane strain: what explicit dynamics integrates along the motion of each material point.

#include <memory>
#include <span>
#include <string>

#include "shoreline/bases/lanes.hpp"
#include "shoreline/engine/material.hpp"

namespace shoreline {

/// A law for the Cauchy stress. Called from several threads at once; it keeps no state of its own.
class LargeStrainMaterial {
 public:
  virtual ~LargeStrainMaterial() = default;

  [[nodiscard]] virtual std::string name() const = 0;

  /// Stress at the end of a step.
  /// @param stress       at its start
  /// @param increment    Δt ∇v, (∇v)_ij = ∂v_i/∂x_j with x at the start of the step
  /// @param deformation  deformation gradient D at the end of the step, its part out of plane being 1
  [[nodiscard]] virtual Stress updated(const Stress& stress, const Mat2& increment, const Mat2& deformation) const = 0;

  /// Updates the stresses of many points, side by side; a law that overrides it saves a call for each.
  /// @param stress       (m), each as (xx, yy, xy, zz); in: at the start of the step; out: at its end
  /// @param increment    (m), each as (xx, yx, xy, yy)
  /// @param deformation  (m), likewise
  virtual void update(std::span<LaneTensor> stress, std::span<const LaneTensor> increment,
                      std::span<const LaneTensor> deformation) const;

  /// Energy stored per original volume, (M.6), (M.8), (M.11) [J/m³].
  [[nodiscard]] virtual double energy(const Stress& stress, const Mat2& deformation) const = 0;

  /// Whether a rotation of the body rotates its stress and changes nothing else.
  [[nodiscard]] virtual bool objective() const = 0;

  /// Modulus of p-waves at rest, λ + 2μ [Pa].
  [[nodiscard]] virtual double wave_modulus() const = 0;
};

/// σ = λ tr(E) I + 2μ E with E = sym(D) − I, (M.5) (de Koster et al. 2020, eq. 26). Linear in the displacement; not
/// objective: a rotation by θ alone gives E = (cos θ − 1) I.
/// @param youngs_modulus  E > 0 [Pa]
/// @param poissons_ratio  ν in (−1, ½)
/// @throws InvalidArgument with the value
[[nodiscard]] std::unique_ptr<LargeStrainMaterial> linear_large(double youngs_modulus, double poissons_ratio);

/// σ = (λ ln J / J) I + (μ / J)(D Dᵀ − I), (M.7) (de Koster et al. 2020, eq. 27).
/// @throws as linear_large
[[nodiscard]] std::unique_ptr<LargeStrainMaterial> neo_hookean(double youngs_modulus, double poissons_ratio);

/// Jaumann's rate of stress with the volume term, (M.9) (de Koster 2018, eq. 2.41), integrated about the middle of a
/// step, (M.10): a finite rotation turns the stress exactly.
/// @throws as linear_large
[[nodiscard]] std::unique_ptr<LargeStrainMaterial> hypoelastic(double youngs_modulus, double poissons_ratio);

}  // namespace shoreline
