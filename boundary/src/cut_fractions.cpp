#include "shoreline/boundary/cut_fractions.hpp"

#include <algorithm>
#include <map>

#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/triangle_moments.hpp"

namespace shoreline {
namespace {

/// Area and first moments of a polygon, counter-clockwise.
Vec3 moments_of(const std::vector<Vec2>& polygon) {
  Vec3 sum = Vec3::Zero();
  const Vec2& origin = polygon[0];
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const double area = 0.5 * cross(polygon[k] - origin, polygon[k + 1] - origin);
    const Vec2 centroid = (origin + polygon[k] + polygon[k + 1]) / 3.0;
    sum += area * Vec3(1.0, centroid.x(), centroid.y());
  }
  return sum;
}

Vec3 moments_of(const Grid& grid, Index element) {
  Vec3 sum = Vec3::Zero();
  for (int part = 0; part < grid.parts(); ++part) sum += moments_of(grid.polygon(element * grid.parts() + part));
  return sum;
}

/// Covered area of each cell [m²]; a frame of cells around the grid takes what bulges out.
std::map<Index, double> covered(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid) {
  const QuadrilateralGrid framed(grid.bounds().lower - grid.spacing(), grid.spacing(),
                                 {grid.columns() + 2, grid.rows() + 2});
  const CellMoments moments = cell_moments(curves, framed, 0);
  std::map<Index, double> area;
  for (std::size_t k = 0; k < moments.cell.size(); ++k) {
    const Index i = std::clamp(moments.cell[k] % framed.columns() - 1, 0, grid.columns() - 1);
    const Index j = std::clamp(moments.cell[k] / framed.columns() - 1, 0, grid.rows() - 1);
    area[i + j * grid.columns()] += moments.moment(0, static_cast<Eigen::Index>(k));
  }
  return area;
}

std::map<Index, double> covered(std::span<const SplineCurve> curves, const TriangleGrid& grid) {
  const TriangleMoments moments = triangle_moments(curves, grid, 1);
  std::map<Index, double> area;
  for (std::size_t k = 0; k < moments.sub_cell.size(); ++k)
    area[moments.sub_cell[k] / grid.parts()] += moments.moment(0, static_cast<Eigen::Index>(k));
  return area;
}

}  // namespace

std::vector<CutFraction> cut_fractions(std::span<const SplineCurve> curves, const Grid& grid) {
  const auto* triangles = dynamic_cast<const TriangleGrid*>(&grid);
  const std::map<Index, double> area = triangles != nullptr
                                           ? covered(curves, *triangles)
                                           : covered(curves, dynamic_cast<const QuadrilateralGrid&>(grid));
  std::vector<CutFraction> cuts;
  for (const auto& [element, part] : area) cuts.push_back({element, part / moments_of(grid, element)[0]});
  return cuts;
}

Vec2 element_centre(const Grid& grid, Index element) {
  const Vec3 moments = moments_of(grid, element);
  return moments.tail<2>() / moments[0];
}

}  // namespace shoreline
