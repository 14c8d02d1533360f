#pragma once
// What every analysis does with the boundary of its body.

#include "shoreline/engine/scene.hpp"

namespace shoreline {

/// The outline at the start, one curve a piece.
[[nodiscard]] std::vector<SplineCurve> curves_at_start(const std::vector<BoundaryPiece>& boundary);

/// Moves the tracking points with the material; pieces that were joined stay joined.
/// @param edges      one a piece
/// @param increment  (2, functions) displacement of the step [m]
void move_boundary(Scene& scene, const std::vector<Edge>& edges, const Eigen::Matrix2Xd& increment);

/// Adds the forces of supports on grid lines, (C.6), by piece; a condition of two pieces counts for the first.
/// @param force  (2, functions) with which constraints act on the components that they give [N per metre]
void add_grid_reactions(const Scene& scene, const std::vector<Constraint>& constraints, const Eigen::Matrix2Xd& force,
                        std::map<std::string, Vec3>& reactions);

}  // namespace shoreline
