#include "shoreline/bases/linear_triangle.hpp"

#include <algorithm>

namespace shoreline {

ShortIndices LinearTriangleBasis::functions_of(Index cell) const {
  return Eigen::Map<const Eigen::Matrix<Index, 3, 1>>(grid_.mesh().triangle[static_cast<std::size_t>(cell)].data());
}

Vec2 LinearTriangleBasis::control_point(Index function) const {
  return grid_.mesh().vertex[static_cast<std::size_t>(function)];
}

void LinearTriangleBasis::evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const {
  const auto [a, b, c] = corners(grid_.mesh(), cell);
  const double inverse = 1.0 / twice_area(a, b, c);
  const double gradients[6] = {inverse * (b.y() - c.y()), inverse * (c.x() - b.x()), inverse * (c.y() - a.y()),
                               inverse * (a.x() - c.x()), inverse * (a.y() - b.y()), inverse * (b.x() - a.x())};
  for (const Vec2& point : x) {
    const double r = gradients[2] * (point.x() - a.x()) + gradients[3] * (point.y() - a.y());
    const double s = gradients[4] * (point.x() - a.x()) + gradients[5] * (point.y() - a.y());
    const double values[3] = {1.0 - r - s, r, s};
    value = std::copy_n(values, 3, value);
    gradient = std::copy_n(gradients, 6, gradient);
  }
}

ShortCurvatures LinearTriangleBasis::curvatures(Index /*cell*/, const Vec2& /*x*/) const {
  return ShortCurvatures::Zero(3, 3);
}

}  // namespace shoreline
