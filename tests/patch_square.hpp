#pragma once
// A patch test on any grid: a turned square with a linear displacement.

#include "every_grid.hpp"
#include "scenes.hpp"
#include "shoreline/engine/defaults.hpp"

namespace shoreline::test {

inline RunRecord run(Scene& scene) {
  RunRecord record;
  run_load_steps(scene, {}, record);
  return record;
}

struct PatchSquare {
  Case problem;
  ExactSolution exact;
};

/// A square across the lines of a grid, under a pressure that makes its displacement linear; strains of 1e-12.
/// @param grid  over (−1, 1)²
inline PatchSquare patch_square(const Case::Grid& grid, int steps, Loading loading, bool projected) {
  const CompressionSquare square{.angle = 0.4,
                                 .shift = Vec2(0.03, -0.02),
                                 .side = 1.0,
                                 .band = nitsche_band(grid.basis),
                                 .method = EssentialMethod::nitsche,
                                 .ghost = ghost_for_nitsche(grid.basis, grid.degree),
                                 .load = 1e-6,
                                 .steps = steps,
                                 .loading = loading};
  PatchSquare patch{compression_case(square), *compression_square(square).exact};
  std::vector<Vec2> corners;
  for (const Case::Boundary& side : patch.problem.boundaries) corners.push_back(side.piece.points.front());
  patch.problem.grid = grid;
  patch.problem.material.projected_dilatation = projected;
  patch.problem.material_points = patch_points(grid, corners);
  return patch;
}

}  // namespace shoreline::test
