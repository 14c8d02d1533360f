#include "shoreline/bases/derivatives.hpp"

#include <numbers>
#include <string>

#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

/// Differences of curvatures over a distance: exact, as ∂xx and ∂xy are of degree 1 and 2 in x on a bicubic cell, and
/// of less on all others.
ShortDerivatives third_derivatives(const Basis& basis, Index cell, const Vec2& x) {
  const double step = 0.5 * basis.grid().size(cell);
  const auto slope = [&](const Vec2& direction) -> ShortCurvatures {
    const Vec2 move = step * direction;
    return (basis.curvatures(cell, x + move) - basis.curvatures(cell, x - move)) / (2.0 * step);
  };
  const ShortCurvatures in_x = slope(Vec2::UnitX());
  const ShortCurvatures in_y = slope(Vec2::UnitY());
  ShortDerivatives third(4, basis.functions_per_cell());
  third << in_x.row(0), in_y.row(1), std::numbers::sqrt3 * in_x.row(2), std::numbers::sqrt3 * in_y.row(2);
  return third;
}

}  // namespace

ShortDerivatives derivatives(const Basis& basis, Index cell, const Vec2& x, int order) {
  switch (order) {
    case 1:
      return basis.support(cell, x).gradient;
    case 2: {
      ShortDerivatives second = basis.curvatures(cell, x);
      second.row(2) *= std::numbers::sqrt2;
      return second;
    }
    case 3:
      return third_derivatives(basis, cell, x);
    default:
      throw InvalidArgument("derivatives: expected an order from 1 to 3, got " + std::to_string(order));
  }
}

ShortVector directional_derivative(const Basis& basis, Index cell, const Vec2& x, const Vec2& direction, int order) {
  const double c = direction.x();
  const double s = direction.y();
  const ShortDerivatives d = derivatives(basis, cell, x, order);
  switch (order) {
    case 1:
      return d.transpose() * direction;
    case 2:
      return d.transpose() * Vec3(c * c, s * s, std::numbers::sqrt2 * c * s);
    default:
      return d.transpose() *
             Eigen::Vector4d(c * c * c, s * s * s, std::numbers::sqrt3 * c * c * s, std::numbers::sqrt3 * c * s * s);
  }
}

}  // namespace shoreline
