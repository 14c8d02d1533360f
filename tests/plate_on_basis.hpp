#pragma once
// The plate with a hole on any basis, integrated exactly but for the chords that stand for its outline.

#include "every_grid.hpp"
#include "polygon_points.hpp"
#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/defaults.hpp"
#include "shoreline/engine/quasi_static.hpp"

namespace shoreline::test {

/// The outline of a case as a polygon.
/// @param chord  [m]; the longest that stands for a piece of more than two points
inline std::vector<Vec2> outline(const Case& problem, double chord) {
  std::vector<Vec2> polygon;
  for (const Case::Boundary& side : problem.boundaries)
    for (const CubicSpan& span : fit_spline(side.piece).spans) {
      const double length = (span.position(1.0) - span.position(0.0)).norm();
      const int parts = side.piece.points.size() == 2 ? 1 : static_cast<int>(length / chord) + 1;
      for (int k = 0; k < parts; ++k) polygon.push_back(span.position(static_cast<double>(k) / parts));
    }
  return polygon;
}

/// An example of the plate on another grid, its supports by Nitsche's method, with band and penalty of the basis.
/// @param file   "plate_with_hole/neumann.json"
/// @param shift  of the grid to the left and down, in cells
inline Case plate_on(const std::string& file, Case::Grid grid, double h, double chord,
                     const Vec2& shift = Vec2::Zero()) {
  Case problem = read_case(std::string(SHORELINE_EXAMPLES) + "/" + file, {});
  grid.lower = problem.grid.lower - h * shift;
  grid.upper = problem.grid.upper;
  grid.cell_size = Vec2(h, h);
  problem.grid = grid;
  problem.ghost = ghost_for_nitsche(grid.basis, grid.degree);
  for (Case::Boundary& side : problem.boundaries) {
    auto* support = std::get_if<Essential>(&side.condition);
    if (auto* moved = std::get_if<Case::Displacement>(&side.condition)) support = &moved->support;
    if (support == nullptr) continue;
    support->method = EssentialMethod::nitsche;
    support->band = nitsche_band(grid.basis);
    support->narrows = true;
  }
  const int order = grid.basis == Case::BasisType::bspline ? 2 * grid.degree : 2;
  problem.material_points = polygon_points(basis_of(grid)->grid(), outline(problem, chord), order);
  return problem;
}

struct PlateResult {
  double displacement;  ///< relative L2
  double stress;        ///< relative L2
  RunRecord record;
};

inline PlateResult compute(Scene& scene, bool condition_estimate = false) {
  PlateResult result{};
  run_load_steps(scene, {.condition_estimate = condition_estimate}, result.record);
  const ErrorNorms norms = error_norms(scene.points, *scene.exact, 1.0);
  result.displacement = norms.displacement_l2_relative.value();
  result.stress = norms.stress_l2_relative.value();
  return result;
}

}  // namespace shoreline::test
