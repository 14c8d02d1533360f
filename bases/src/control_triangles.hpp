#pragma once
// The control triangles of a Powell-Sabin refinement.

#include "shoreline/bases/triangle_mesh.hpp"

namespace shoreline {

/// The control triangle of each vertex of the main mesh, as seen from the vertex [m]: it holds the vertex and the
/// midpoints of all edges of the refinement that start there, (S.6), and has sides on the border.
[[nodiscard]] std::vector<std::array<Vec2, 3>> control_triangles(const TriangleMesh& main, const TriangleMesh& refined);

}  // namespace shoreline
