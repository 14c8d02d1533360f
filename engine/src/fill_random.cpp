// Random points in the body.
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "grid_under.hpp"
#include "shoreline/boundary/body_moments.hpp"
#include "shoreline/boundary/voronoi.hpp"
#include "shoreline/engine/fill.hpp"

namespace shoreline {
namespace {

constexpr double trifle = 1e-8;  ///< of an element: of what is less, rounding hides the centroid
constexpr double thin = 1e-4;    ///< of a cell: a covered part so small is found by its centroid
constexpr int most_draws = 100000;

/// What the body covers of a cell.
struct CoveredCell {
  Index cell;
  double area;    ///< [m²]
  Vec2 centroid;  ///< of that part [m]
};

std::vector<CoveredCell> covered_cells(std::span<const SplineCurve> curves, const Grid& grid) {
  const BodyMoments covered = body_moments(curves, grid, 1);
  std::vector<CoveredCell> cells;
  for (std::size_t k = 0; k < covered.cell.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const auto moment = covered.moment.col(column);
    cells.push_back({covered.cell[k], moment[0], covered.centre.col(column) + moment.segment<2>(1) / moment[0]});
  }
  return cells;
}

/// Area of a triangle or parallelogram.
double area_of(const std::vector<Vec2>& polygon) {
  const double parallelogram = cross(polygon[1] - polygon[0], polygon.back() - polygon[0]);
  return polygon.size() == 3 ? 0.5 * parallelogram : parallelogram;
}

/// The draws of one element, the same on every machine: the standard fixes the generator, not its distributions.
class Draws {
 public:
  Draws(int seed, Index element) {
    std::seed_seq sequence{seed, element};
    engine_.seed(sequence);
  }

  /// Uniform in [0, 1): the upper 53 of 64 bits.
  [[nodiscard]] double share() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

  /// Uniform in a triangle or parallelogram.
  [[nodiscard]] Vec2 in(const std::vector<Vec2>& polygon) {
    double r = share();
    double s = share();
    if (polygon.size() == 3 && r + s > 1.0) {
      r = 1.0 - r;
      s = 1.0 - s;
    }
    return polygon[0] + r * (polygon[1] - polygon[0]) + s * (polygon.back() - polygon[0]);
  }

 private:
  std::mt19937_64 engine_;
};

/// A cell of an element, each as often as the body covers it.
const CoveredCell& any_of(std::span<const CoveredCell> cells, double area, Draws& draws) {
  double left = draws.share() * area;
  for (const CoveredCell& cell : cells)
    if ((left -= cell.area) < 0.0) return cell;
  return cells.back();
}

/// A place in the covered part of a cell; none if draws do not find it.
std::optional<Vec2> place_in(const CoveredCell& covered, const Grid& grid, const Region& region, Draws& draws) {
  const std::vector<Vec2> polygon = grid.polygon(covered.cell);
  if (covered.area < thin * area_of(polygon) && region.contains(covered.centroid)) return covered.centroid;
  for (int draw = 0; draw < most_draws; ++draw)
    if (const Vec2 x = draws.in(polygon); region.contains(x)) return x;
  return std::nullopt;
}

/// Adds the points of one element.
/// @param cells  of the element, of which the body covers something
void add_points(std::span<const CoveredCell> cells, const Grid& grid, const Region& region, const RandomFill& fill,
                std::vector<Vec2>& points) {
  const Index element = cells.front().cell / grid.parts();
  double whole = 0.0;
  for (Index part = 0; part < grid.parts(); ++part) whole += area_of(grid.polygon(element * grid.parts() + part));
  double area = 0.0;
  for (const CoveredCell& cell : cells) area += cell.area;
  if (area <= trifle * whole) return;
  Draws draws(fill.seed, element);
  const long count = std::max(1L, std::lround(fill.per_element * area / whole));
  for (long k = 0; k < count; ++k)
    if (const auto x = place_in(any_of(cells, area, draws), grid, region, draws)) points.push_back(*x);
}

MaterialPoints fill_elements(std::span<const SplineCurve> curves, const std::vector<CoveredCell>& cells,
                             const Grid& grid, const RandomFill& fill) {
  const Region region(curves);
  std::vector<Vec2> points;
  for (auto first = cells.begin(); first != cells.end();) {
    const Index element = first->cell / grid.parts();
    const auto end = std::find_if(first, cells.end(), [&](const auto& c) { return c.cell / grid.parts() != element; });
    add_points({first, end}, grid, region, fill, points);
    first = end;
  }
  Eigen::Matrix2Xd position(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t p = 0; p < points.size(); ++p) position.col(static_cast<Eigen::Index>(p)) = points[p];
  Eigen::VectorXd volume =
      fill.volumes == RandomFill::Volumes::voronoi
          ? voronoi_areas(curves, position)
          : Eigen::VectorXd::Constant(position.cols(), region.area() / static_cast<double>(position.cols()));
  return points_at(std::move(position), std::move(volume));
}

}  // namespace

MaterialPoints fill_random(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid, const RandomFill& fill) {
  return fill_elements(curves, covered_cells(curves, grid), grid, fill);
}

MaterialPoints fill_random(std::span<const SplineCurve> curves, const TriangleGrid& grid, const RandomFill& fill) {
  const std::vector<CoveredCell> cells = covered_cells(curves, grid);
  double covered = 0.0;
  for (const CoveredCell& cell : cells) covered += cell.area;
  require_grid_under(Region(curves), covered);
  return fill_elements(curves, cells, grid, fill);
}

}  // namespace shoreline
