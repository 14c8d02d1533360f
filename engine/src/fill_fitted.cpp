// Points for weights that are fitted to the outline.
#include <algorithm>
#include <vector>

#include "shoreline/bases/quadrature.hpp"
#include "shoreline/boundary/body_moments.hpp"
#include "shoreline/boundary/triangle_moments.hpp"
#include "shoreline/engine/fill.hpp"

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

/// Which cells the body covers whole, and which in part.
struct Coverage {
  std::vector<Index> whole;
  std::vector<Index> cut;
};

Coverage coverage(std::span<const SplineCurve> curves, const Grid& grid) {
  constexpr double tolerance = 1e-9;  // of the area
  const BodyMoments covered = body_moments(curves, grid, 0);
  Coverage found;
  for (std::size_t k = 0; k < covered.cell.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const bool whole = covered.moment(0, column) >= (1.0 - tolerance) * covered.whole[column];
    (whole ? found.whole : found.cut).push_back(covered.cell[k]);
  }
  return found;
}

/// Adds those of some points that sit in cut cells.
void add_in(const std::vector<Index>& cut, const Grid& grid, const MaterialPoints& points, Collected& all) {
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
  const Coverage cells = coverage(curves, grid);
  const QuadratureRule along_x = gauss(per_cell[0]);
  const QuadratureRule along_y = gauss(per_cell[1]);
  Collected all;
  for (const Index cell : cells.whole)
    for (Eigen::Index j = 0; j < along_y.point.size(); ++j)
      for (Eigen::Index i = 0; i < along_x.point.size(); ++i)
        all.add(grid.corner(cell) + Vec2(along_x.point[i], along_y.point[j]).cwiseProduct(grid.spacing()),
                along_x.weight[i] * along_y.weight[j] * grid.spacing().prod());
  const int least = 2 * (degree + 2);
  const LatticeFill lattice{{more(per_cell[0], least), more(per_cell[1], least)}, VolumeRule::clipped};
  add_in(cells.cut, grid, fill_lattice(curves, grid, lattice), all);
  return all.points();
}

MaterialPoints fill_fitted(std::span<const SplineCurve> curves, const TriangleGrid& grid,
                           const std::array<int, 2>& per_cell, int /*degree*/) {
  constexpr int least = 3;  // of the sub-cells along a side of a cut triangle
  const Coverage cells = coverage(curves, grid);
  const int divisions = divisions_of(per_cell, grid);
  Collected all;
  for (const Index cell : cells.whole) {
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
  add_in(cells.cut, grid, fill_lattice(curves, grid, {{fine, fine}, VolumeRule::clipped}), all);
  return all.points();
}

}  // namespace shoreline
