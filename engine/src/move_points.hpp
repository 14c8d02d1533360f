#pragma once
// The motion of points with the material at the end of a load step.

#include "shoreline/engine/dilatation.hpp"
#include "shoreline/engine/material.hpp"

namespace shoreline {

/// What a load step found: every kind of point moves by it.
struct StepMotion {
  const Basis& basis;
  const Material& material;
  const Eigen::Matrix2Xd& increment;  ///< (2, functions) Δd [m]
  const Dilatation* dilatation;       ///< none where it is not projected, (I.3)
};

/// Moves points, and updates their displacements, strains and stresses, (E.4) and (I.6).
/// @param supports  of these points, where they were at the start of the step
void move_points(const StepMotion& motion, const PointSupports& supports, MaterialPoints& points);

}  // namespace shoreline
