#include "sample_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "point_cells.hpp"
#include "shoreline/boundary/edge.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/fill.hpp"

namespace shoreline {

MaterialPoints place_samples(std::span<const SplineCurve> curves, int across) {
  constexpr double rounding = 1e-9;  // of a sub-cell: sides in a whole ratio have whole numbers of them
  const Box body = Region(curves).bounds();
  const Vec2 sides = body.upper - body.lower;
  const auto along = [&](double side) {
    return static_cast<int>(std::ceil(across * side / sides.maxCoeff() - rounding));
  };
  return fill_lattice(curves, AcrossFill{.across = {along(sides.x()), along(sides.y())}});
}

PointSupports locate_samples(const Basis& basis, const std::vector<char>& active, const MaterialPoints& samples) {
  std::vector<Index> cell = cells_of(basis, samples);
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const Vec2 x = samples.position.col(static_cast<Eigen::Index>(k));
    if (cell[k] < 0)
      throw ComputationError(
          fmt::format("sample point {} at ({:.6g}, {:.6g}) lies outside the grid; enlarge the grid or reduce the load",
                      k, x.x(), x.y()));
    cell[k] = nearest_active_cell(basis.grid(), active, cell[k], x);
  }
  PointSupports supports;
  supports.functions = basis.functions_per_cell();
  group_points(cell, basis.grid(), supports);
  evaluate_supports(basis, samples, supports);
  return supports;
}

void move_samples(const StepMotion& motion, const std::vector<char>& active, MaterialPoints& samples) {
  move_points(motion, locate_samples(motion.basis, active, samples), samples);
}

}  // namespace shoreline
