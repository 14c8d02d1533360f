#include "shoreline/bases/bilinear.hpp"

namespace shoreline {

ShortIndices BilinearBasis::functions_of(Index cell) const {
  const Index first = cell + cell / grid_.columns();  // one node more than cells in each row
  ShortIndices nodes(4);
  nodes << first, first + 1, first + grid_.columns() + 1, first + grid_.columns() + 2;
  return nodes;
}

template <class Point, class Number>
SHORELINE_INLINE void BilinearBasis::evaluate_all(Index cell, std::span<const Point> x, Number* value,
                                                  Number* gradient) const {
  const Vec2 corner(grid_.line(0, cell % grid_.columns()), grid_.line(1, cell / grid_.columns()));
  const Vec2 inverse = grid_.spacing().cwiseInverse();
  for (const Point& point : x) {
    const Number r = (point[0] - corner.x()) * inverse.x();
    const Number s = (point[1] - corner.y()) * inverse.y();
    const Number r1 = 1.0 - r;
    const Number s1 = 1.0 - s;
    *value++ = r1 * s1;
    *value++ = r * s1;
    *value++ = r1 * s;
    *value++ = r * s;
    if (gradient == nullptr) continue;
    *gradient++ = -s1 * inverse.x();
    *gradient++ = -r1 * inverse.y();
    *gradient++ = s1 * inverse.x();
    *gradient++ = -r * inverse.y();
    *gradient++ = -s * inverse.x();
    *gradient++ = r1 * inverse.y();
    *gradient++ = s * inverse.x();
    *gradient++ = r * inverse.y();
  }
}

void BilinearBasis::evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const {
  evaluate_all(cell, x, value, gradient);
}

SHORELINE_CLONES void BilinearBasis::evaluate_lanes(Index cell, std::span<const LanePoint> x, Lanes* value,
                                                    Lanes* gradient) const {
  evaluate_all(cell, x, value, gradient);
}

void BilinearBasis::evaluate(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const {
  evaluate_lanes(cell, x, value, gradient);
}

ShortCurvatures BilinearBasis::curvatures(Index /*cell*/, const Vec2& /*x*/) const {
  const double mixed = 1.0 / grid_.spacing().prod();
  ShortCurvatures second = ShortCurvatures::Zero(3, 4);
  second.row(2) << mixed, -mixed, -mixed, mixed;
  return second;
}

}  // namespace shoreline
