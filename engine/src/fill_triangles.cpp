#include <fmt/format.h>

#include <cmath>

#include "grid_under.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/triangle_moments.hpp"
#include "shoreline/engine/fill.hpp"

namespace shoreline {
namespace {

/// Points at the centroids of those sub-cells in which these lie inside, with the whole sub-cell.
MaterialPoints whole_sub_cells(const std::vector<Index>& covered, const TriangleGrid& grid, int divisions,
                               const Region& region) {
  Eigen::Matrix2Xd position(2, static_cast<Eigen::Index>(covered.size()));
  Eigen::VectorXd volume(position.cols());
  Eigen::Index n = 0;
  for (const Index number : covered) {
    const auto [a, b, c] = sub_cell(grid, divisions, number);
    const Vec2 centroid = (a + b + c) / 3.0;
    if (!region.contains(centroid)) continue;
    position.col(n) = centroid;
    volume[n++] = 0.5 * twice_area(a, b, c);
  }
  return points_at(position.leftCols(n), volume.head(n));
}

}  // namespace

int divisions_of(const std::array<int, 2>& per_cell, const TriangleGrid& grid) {
  if (per_cell[0] != per_cell[1])
    throw InvalidArgument(fmt::format("per_cell is {} x {}; a triangle is cut alike in all directions: give one number",
                                      per_cell[0], per_cell[1]));
  return grid.parts() == 1 ? per_cell[0] : (per_cell[0] + 1) / 2;
}

MaterialPoints fill_lattice(std::span<const SplineCurve> curves, const TriangleGrid& grid, const LatticeFill& fill) {
  const int divisions = divisions_of(fill.per_cell, grid);
  const TriangleMoments covered = triangle_moments(curves, grid, divisions);
  const Region region(curves);
  require_grid_under(region, covered.moment.row(0).sum());
  if (fill.volumes == VolumeRule::clipped) {
    Eigen::Matrix2Xd position(2, covered.moment.cols());
    for (Eigen::Index k = 0; k < position.cols(); ++k) {
      const auto [a, b, c] = sub_cell(grid, divisions, covered.sub_cell[static_cast<std::size_t>(k)]);
      const auto moment = covered.moment.col(k);
      position.col(k) = (a + b + c) / 3.0 + moment.segment<2>(1) / moment[0];
    }
    return points_at(std::move(position), covered.moment.row(0));
  }
  MaterialPoints points = whole_sub_cells(covered.sub_cell, grid, divisions, region);
  if (fill.volumes == VolumeRule::equal) points.volume.setConstant(region.area() / points.size());
  return points;
}

}  // namespace shoreline
