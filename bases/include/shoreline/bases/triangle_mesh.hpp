#pragma once
// A mesh of triangles as plain data, what must hold for it, and who neighbours whom.

#include <array>
#include <numbers>
#include <vector>

#include "shoreline/bases/error.hpp"
#include "shoreline/bases/types.hpp"

namespace shoreline {

/// Triangles over common vertices.
struct TriangleMesh {
  std::vector<Vec2> vertex;                    ///< positions [m]
  std::vector<std::array<Index, 3>> triangle;  ///< numbers of vertices, counter-clockwise
};

/// A mesh breaks a rule. The message names triangles or vertices by number and position, the rule and a remedy.
class MeshError : public InvalidArgument {
 public:
  using InvalidArgument::InvalidArgument;
};

/// Angles below 1° are refused: functions on such a triangle lose two digits, and its condition four.
inline constexpr double smallest_allowed_angle = std::numbers::pi / 180.0;  ///< [rad]

/// Checks what every function of a mesh relies on.
///
/// Positions are finite and apart (by 1e-10 of the mesh's extent); every vertex belongs to a triangle; triangles are
/// counter-clockwise and have no angle below @p angle_limit; an edge belongs to one triangle or to two, one on each
/// side, and has no vertex in its interior (no hanging nodes); all triangles hang together by edges.
///
/// @param angle_limit  [rad]
/// @throws MeshError with the first breach and the number of its kind
void check(const TriangleMesh& mesh, double angle_limit = smallest_allowed_angle);

/// For each triangle the one on the other side of the edge from its vertex k to its vertex k + 1; −1 on the border.
/// @pre check(mesh) holds, but for the angles
[[nodiscard]] std::vector<std::array<Index, 3>> neighbours(const TriangleMesh& mesh);

/// The smallest box that holds all vertices [m].
[[nodiscard]] Box bounds(const TriangleMesh& mesh);

/// Twice the area of triangle abc, positive if counter-clockwise [m²].
[[nodiscard]] inline double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

/// The smallest angle of a counter-clockwise triangle; not positive if it is flat or clockwise [rad].
[[nodiscard]] double smallest_angle(const std::array<Vec2, 3>& triangle);

/// Corners of a triangle [m].
[[nodiscard]] inline std::array<Vec2, 3> corners(const TriangleMesh& mesh, Index triangle) {
  const auto& [a, b, c] = mesh.triangle[static_cast<std::size_t>(triangle)];
  const auto at = [&](Index v) -> const Vec2& { return mesh.vertex[static_cast<std::size_t>(v)]; };
  return {at(a), at(b), at(c)};
}

}  // namespace shoreline
