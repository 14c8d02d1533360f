#include "shoreline/bases/linear_triangle.hpp"

namespace shoreline {

ShortIndices LinearTriangleBasis::functions_of(Index cell) const {
  return Eigen::Map<const Eigen::Matrix<Index, 3, 1>>(grid_.mesh().triangle[static_cast<std::size_t>(cell)].data());
}

Vec2 LinearTriangleBasis::control_point(Index function) const {
  return grid_.mesh().vertex[static_cast<std::size_t>(function)];
}

template <class Point, class Number>
SHORELINE_INLINE void LinearTriangleBasis::evaluate_all(Index cell, std::span<const Point> x, Number* value,
                                                        Number* gradient) const {
  const auto [a, b, c] = corners(grid_.mesh(), cell);
  const double inverse = 1.0 / twice_area(a, b, c);
  const double gradients[6] = {inverse * (b.y() - c.y()), inverse * (c.x() - b.x()), inverse * (c.y() - a.y()),
                               inverse * (a.x() - c.x()), inverse * (a.y() - b.y()), inverse * (b.x() - a.x())};
  for (const Point& point : x) {
    const Number dx = point[0] - a.x();
    const Number dy = point[1] - a.y();
    const Number r = gradients[2] * dx + gradients[3] * dy;
    const Number s = gradients[4] * dx + gradients[5] * dy;
    *value++ = 1.0 - r - s;
    *value++ = r;
    *value++ = s;
    if (gradient == nullptr) continue;
    for (const double g : gradients) *gradient++ = Number(g);
  }
}

void LinearTriangleBasis::evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const {
  evaluate_all(cell, x, value, gradient);
}

SHORELINE_CLONES void LinearTriangleBasis::evaluate_lanes(Index cell, std::span<const LanePoint> x, Lanes* value,
                                                          Lanes* gradient) const {
  evaluate_all(cell, x, value, gradient);
}

void LinearTriangleBasis::evaluate(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const {
  evaluate_lanes(cell, x, value, gradient);
}

ShortCurvatures LinearTriangleBasis::curvatures(Index /*cell*/, const Vec2& /*x*/) const {
  return ShortCurvatures::Zero(3, 3);
}

}  // namespace shoreline
