#pragma once
// The constitutive law: the one interface that downstream codes extend.

#include <string>

#include "shoreline/bases/types.hpp"

namespace shoreline {

using Stress = Eigen::Vector4d;  ///< xx, yy, xy, zz [Pa], tension positive

/// A small-strain law. Called from several threads at once; it keeps no state of its own.
class Material {
 public:
  virtual ~Material() = default;

  [[nodiscard]] virtual std::string name() const = 0;

  /// Stress after a strain increment, from the stress before it.
  /// @param strain_increment  Voigt, engineering shear
  [[nodiscard]] virtual Stress updated(const Stress& stress, const Vec3& strain_increment) const = 0;

  /// ∂(xx, yy, xy)/∂(strain increment) at a stress, (3, 3), symmetric [Pa].
  [[nodiscard]] virtual Mat3 tangent(const Stress& stress) const = 0;

  /// Whether the tangent is the same for every stress: then stiffness is summed once a cell, not once a point.
  [[nodiscard]] virtual bool constant_tangent() const { return false; }

  /// Young's modulus E [Pa] that scales penalties.
  [[nodiscard]] virtual double stiffness() const = 0;
};

}  // namespace shoreline
