#include "shoreline/boundary/cut_fractions.hpp"

#include <map>

#include "shoreline/boundary/body_moments.hpp"

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

}  // namespace

std::vector<CutFraction> cut_fractions(std::span<const SplineCurve> curves, const Grid& grid) {
  const BodyMoments covered = body_moments(curves, grid, 0);
  std::map<Index, double> area;  // of an element [m²]
  for (std::size_t k = 0; k < covered.cell.size(); ++k)
    area[covered.cell[k] / grid.parts()] += covered.moment(0, static_cast<Eigen::Index>(k));
  std::vector<CutFraction> cuts;
  for (const auto& [element, part] : area) cuts.push_back({element, part / moments_of(grid, element)[0]});
  return cuts;
}

Vec2 element_centre(const Grid& grid, Index element) {
  const Vec3 moments = moments_of(grid, element);
  return moments.tail<2>() / moments[0];
}

}  // namespace shoreline
