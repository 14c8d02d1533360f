// Points for weights that are fitted to the outline.
#include <algorithm>
#include <cmath>
#include <vector>

#include "shoreline/bases/quadrature.hpp"
#include "shoreline/boundary/body_moments.hpp"
#include "shoreline/boundary/cut_points.hpp"
#include "shoreline/boundary/fitted_weights.hpp"
#include "shoreline/boundary/triangle_moments.hpp"
#include "shoreline/engine/fill.hpp"
#include "threads.hpp"

namespace shoreline {
namespace {

/// Points with their volumes as they are found.
class Collected {
 public:
  void add(const Vec2& x, double volume) {
    position_.push_back(x);
    volume_.push_back(volume);
  }
  [[nodiscard]] MaterialPoints points() const {
    const auto n = static_cast<Eigen::Index>(volume_.size());
    Eigen::Matrix2Xd position(2, n);
    for (Eigen::Index p = 0; p < n; ++p) position.col(p) = position_[static_cast<std::size_t>(p)];
    return points_at(std::move(position), Eigen::Map<const Eigen::VectorXd>(volume_.data(), n));
  }

 private:
  std::vector<Vec2> position_;
  std::vector<double> volume_;
};

/// Which cells the body covers whole, and which in part; their columns in the moments.
struct Coverage {
  BodyMoments moments;
  std::vector<std::size_t> whole;
  std::vector<std::size_t> cut;
};

Coverage coverage(std::span<const SplineCurve> curves, const Grid& grid, int order) {
  constexpr double tolerance = 1e-9;  // of the area
  Coverage found{body_moments(curves, grid, order), {}, {}};
  for (std::size_t k = 0; k < found.moments.cell.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const bool whole = found.moments.moment(0, column) >= (1.0 - tolerance) * found.moments.whole[column];
    (whole ? found.whole : found.cut).push_back(k);
  }
  return found;
}

/// Points in the covered part of a rectangle, of as many sub-rectangles as their weights take to meet the moments.
AreaPoints points_in_cut(const CutPoints& cut, const Box& cell, std::array<int, 2> divisions, const Vec2& centre,
                         const Eigen::Ref<const Eigen::VectorXd>& moments) {
  constexpr int rounds = 4;
  const double size = std::sqrt((cell.upper - cell.lower).prod());
  for (int k = 1;; ++k) {
    AreaPoints points = cut.in(cell, divisions);
    if (k == rounds || points.area.size() == 0) return points;
    if (can_meet(points.position.colwise() - centre, size, moments, points.area)) return points;
    for (int& n : divisions) n += (n + 1) / 2;
  }
}

/// The points of all cut rectangles.
std::vector<AreaPoints> points_in_cuts(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid,
                                       const Coverage& cells, const std::array<int, 2>& divisions) {
  const CutPoints cut(curves);
  std::vector<AreaPoints> found(cells.cut.size());
  const std::size_t visits = found.size() * static_cast<std::size_t>(divisions[0] * divisions[1]);
#pragma omp parallel for schedule(dynamic, 8) if (worth_threads(visits))
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(cells.cut[k]);
    const Vec2 corner = grid.corner(cells.moments.cell[cells.cut[k]]);
    found[k] = points_in_cut(cut, {corner, corner + grid.spacing()}, divisions, cells.moments.centre.col(column),
                             cells.moments.moment.col(column));
  }
  return found;
}

/// Adds those of some points that sit in cut cells.
void add_in_cut(const Coverage& cells, const Grid& grid, const MaterialPoints& points, Collected& all) {
  std::vector<Index> cut;
  for (const std::size_t k : cells.cut) cut.push_back(cells.moments.cell[k]);
  Index cell = 0;
  for (Index p = 0; p < points.size(); ++p) {
    cell = grid.locate(points.position.col(p), cell).value_or(-1);
    if (std::ranges::binary_search(cut, cell)) all.add(points.position.col(p), points.volume[p]);
    cell = std::max(cell, 0);
  }
}

int more(int per_cell, int least) { return std::max(per_cell, least); }

}  // namespace

MaterialPoints fill_fitted(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid,
                           const std::array<int, 2>& per_cell, int degree) {
  const int order = 2 * degree;
  const Coverage cells = coverage(curves, grid, order);
  const QuadratureRule along_x = gauss(per_cell[0]);
  const QuadratureRule along_y = gauss(per_cell[1]);
  Collected all;
  for (const std::size_t k : cells.whole)
    for (Eigen::Index j = 0; j < along_y.point.size(); ++j)
      for (Eigen::Index i = 0; i < along_x.point.size(); ++i)
        all.add(
            grid.corner(cells.moments.cell[k]) + Vec2(along_x.point[i], along_y.point[j]).cwiseProduct(grid.spacing()),
            along_x.weight[i] * along_y.weight[j] * grid.spacing().prod());
  const int least = 2 * degree + 2;
  const std::array<int, 2> divisions{more(per_cell[0], least), more(per_cell[1], least)};
  for (const AreaPoints& found : points_in_cuts(curves, grid, cells, divisions))
    for (Eigen::Index p = 0; p < found.area.size(); ++p) all.add(found.position.col(p), found.area[p]);
  return all.points();
}

MaterialPoints fill_fitted(std::span<const SplineCurve> curves, const TriangleGrid& grid,
                           const std::array<int, 2>& per_cell, int /*degree*/) {
  constexpr int least = 3;  // of the sub-cells along a side of a cut triangle
  const Coverage cells = coverage(curves, grid, 0);
  const int divisions = divisions_of(per_cell, grid);
  Collected all;
  for (const std::size_t whole : cells.whole) {
    const Index cell = cells.moments.cell[whole];
    const auto [a, b, c] = corners(grid.mesh(), cell);
    const double area = 0.5 * twice_area(a, b, c);
    if (divisions > 2) {
      for (Index k = 0; k < divisions * divisions; ++k) {
        const auto [p, q, r] = sub_cell(grid, divisions, cell * divisions * divisions + k);
        all.add((p + q + r) / 3.0, area / (divisions * divisions));
      }
      continue;
    }
    for (const Vec2& x : {a, b, c}) all.add(0.5 * x + (a + b + c) / 6.0, area / 3.0);  // exact to degree 2
  }
  const int fine = more(divisions, least) * (grid.parts() == 1 ? 1 : 2);
  add_in_cut(cells, grid, fill_lattice(curves, grid, {{fine, fine}, VolumeRule::clipped}), all);
  return all.points();
}

}  // namespace shoreline
