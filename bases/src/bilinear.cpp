#include "shoreline/bases/bilinear.hpp"

#include <algorithm>

namespace shoreline {

ShortIndices BilinearBasis::functions_of(Index cell) const {
  const Index first = cell + cell / grid_.columns();  // one node more than cells in each row
  ShortIndices nodes(4);
  nodes << first, first + 1, first + grid_.columns() + 1, first + grid_.columns() + 2;
  return nodes;
}

void BilinearBasis::evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const {
  const Vec2 corner = grid_.corner(cell);
  const Vec2 inverse = grid_.spacing().cwiseInverse();
  for (const Vec2& point : x) {
    const double r = (point.x() - corner.x()) * inverse.x();
    const double s = (point.y() - corner.y()) * inverse.y();
    const double values[4] = {(1 - r) * (1 - s), r * (1 - s), (1 - r) * s, r * s};
    const double gradients[8] = {-(1 - s) * inverse.x(), -(1 - r) * inverse.y(), (1 - s) * inverse.x(),
                                 -r * inverse.y(),       -s * inverse.x(),       (1 - r) * inverse.y(),
                                 s * inverse.x(),        r * inverse.y()};
    value = std::copy_n(values, 4, value);
    gradient = std::copy_n(gradients, 8, gradient);
  }
}

ShortCurvatures BilinearBasis::curvatures(Index /*cell*/, const Vec2& /*x*/) const {
  const double mixed = 1.0 / grid_.spacing().prod();
  ShortCurvatures second = ShortCurvatures::Zero(3, 4);
  second.row(2) << mixed, -mixed, -mixed, mixed;
  return second;
}

}  // namespace shoreline
