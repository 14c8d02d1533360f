#include "passive_points.hpp"

#include <fmt/format.h>

#include "point_cells.hpp"
#include "shoreline/boundary/edge.hpp"
#include "shoreline/engine/failures.hpp"

namespace shoreline {

PointSupports locate_passive(const Basis& basis, const std::vector<char>& active, const MaterialPoints& points,
                             const NameOfPoint& name) {
  std::vector<Index> cell = cells_of(basis, points);
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const Vec2 x = points.position.col(static_cast<Eigen::Index>(k));
    if (cell[k] < 0)
      throw ComputationError(fmt::format(
          "{} at ({:.6g}, {:.6g}) lies outside the grid; enlarge the grid or reduce the load", name(k), x.x(), x.y()));
    cell[k] = nearest_active_cell(basis.grid(), active, cell[k], x);
  }
  PointSupports supports;
  supports.functions = basis.functions_per_cell();
  group_points(cell, basis.grid(), supports);
  note_places(points, supports);
  return supports;
}

}  // namespace shoreline
