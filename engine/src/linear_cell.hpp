#pragma once
// A cell on which the gradients of a basis are linear: they are known everywhere from three places.

#include <array>

#include "shoreline/bases/basis.hpp"
#include "shoreline/bases/counters.hpp"

namespace shoreline {

/// Gradients C m with m = (1, ξ, η), (ξ, η) = (x − origin)/h. Bilinear and linear cells, parts of Powell-Sabin
/// triangles.
struct LinearCell {
  Vec2 origin;                                       ///< [m]
  double h;                                          ///< size of the cell [m]
  std::array<double, 3 * max_support> value;         ///< (n) at the origin come first
  std::array<double, 3 * 2 * max_support> gradient;  ///< (2n) at the origin and at h beside it along x and y [1/m]

  /// @pre gradients of the basis have degree 0 or 1
  LinearCell(const Basis& basis, Index cell, const Vec2& place) : origin(place), h(basis.grid().size(cell)) {
    const std::array<Vec2, 3> places{origin, origin + Vec2(h, 0.0), origin + Vec2(0.0, h)};
    count(Work::evaluations, 3);
    basis.evaluate(cell, places, value.data(), gradient.data());
  }

  [[nodiscard]] Vec2 local(const Vec2& x) const { return (x - origin) / h; }
};

}  // namespace shoreline
