#pragma once
// The Powell-Sabin refinement: each triangle of a mesh in six.

#include "shoreline/bases/triangle_mesh.hpp"

namespace shoreline {

/// Sub-triangles of each triangle of the main mesh.
inline constexpr Index powell_sabin_parts = 6;

/// Cuts each triangle at its incentre Z and at one point R on each edge, (S.4) and (S.5): on an inner edge R lies on
/// the line between the incentres on both sides, on the border it is the middle of the edge.
///
/// With n vertices and m triangles in the main mesh, vertices are 0 … n − 1 those of the main mesh, n + t the incentre
/// of triangle t, from n + m on the points on edges. Triangle t with vertices V has the sub-triangles
/// 6t + 2k = (V_k, R_{k,k+1}, Z) and 6t + 2k + 1 = (V_k, Z, R_{k−1,k}), k = 0, 1, 2.
///
/// @pre check(main) holds
[[nodiscard]] TriangleMesh powell_sabin_refinement(const TriangleMesh& main);

}  // namespace shoreline
