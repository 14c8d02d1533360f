#include "shoreline/boundary/body_moments.hpp"

#include <string>

#include "shoreline/bases/error.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/triangle_moments.hpp"

namespace shoreline {
namespace {

constexpr int highest_on_triangles = 2;

BodyMoments of_rectangles(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid, int order) {
  CellMoments found = cell_moments(curves, grid, order);
  BodyMoments moments{.cell = std::move(found.cell),
                      .centre = Eigen::Matrix2Xd(2, found.moment.cols()),
                      .whole = Eigen::VectorXd::Constant(found.moment.cols(), grid.spacing().prod()),
                      .moment = std::move(found.moment)};
  for (Eigen::Index k = 0; k < moments.centre.cols(); ++k)
    moments.centre.col(k) = grid.corner(moments.cell[static_cast<std::size_t>(k)]) + 0.5 * grid.spacing();
  return moments;
}

BodyMoments of_triangles(std::span<const SplineCurve> curves, const TriangleGrid& grid, int order) {
  if (order < 0 || order > highest_on_triangles)
    throw InvalidArgument("body_moments: the order on triangles must be 0 to 2, got " + std::to_string(order));
  TriangleMoments found = triangle_moments(curves, grid, 1);
  BodyMoments moments{.cell = std::move(found.sub_cell),
                      .centre = Eigen::Matrix2Xd(2, found.moment.cols()),
                      .whole = Eigen::VectorXd(found.moment.cols()),
                      .moment = found.moment.topRows(monomials(order))};
  for (Eigen::Index k = 0; k < moments.centre.cols(); ++k) {
    const auto [a, b, c] = corners(grid.mesh(), moments.cell[static_cast<std::size_t>(k)]);
    moments.centre.col(k) = (a + b + c) / 3.0;
    moments.whole[k] = 0.5 * twice_area(a, b, c);
  }
  return moments;
}

}  // namespace

int highest_order(const Grid& grid) {
  return dynamic_cast<const TriangleGrid*>(&grid) != nullptr ? highest_on_triangles : max_moment_order;
}

BodyMoments body_moments(std::span<const SplineCurve> curves, const Grid& grid, int order) {
  if (const auto* triangles = dynamic_cast<const TriangleGrid*>(&grid)) return of_triangles(curves, *triangles, order);
  return of_rectangles(curves, dynamic_cast<const QuadrilateralGrid&>(grid), order);
}

}  // namespace shoreline
