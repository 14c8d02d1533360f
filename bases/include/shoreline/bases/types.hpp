#pragma once
// Types that every part of Shoreline shares.

#include <Eigen/Core>
#include <cstdint>

namespace shoreline {

using Index = std::int32_t;    ///< counts and numbers of cells, functions, points
using Vec2 = Eigen::Vector2d;  ///< position, displacement, force, … in the plane
using Mat2 = Eigen::Matrix2d;
using Vec3 = Eigen::Vector3d;  ///< Voigt vector (xx, yy, xy), engineering shear strain
using Mat3 = Eigen::Matrix3d;  ///< Voigt matrix, for instance a tangent modulus [Pa]

/// An axis-aligned rectangle [m].
struct Box {
  Vec2 lower = Vec2::Zero();
  Vec2 upper = Vec2::Zero();
};

/// The third component of the cross product a × b.
[[nodiscard]] inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace shoreline
