#include "sample_points.hpp"

#include <algorithm>
#include <cmath>

#include "shoreline/boundary/region.hpp"
#include "shoreline/engine/fill.hpp"

namespace shoreline {

MaterialPoints place_samples(std::span<const SplineCurve> curves, int across) {
  constexpr double rounding = 1e-9;  // of a sub-cell: sides in a whole ratio have whole numbers of them
  const Box body = Region(curves).bounds();
  const Vec2 sides = body.upper - body.lower;
  const auto along = [&](double side) {
    return static_cast<int>(std::ceil(across * side / sides.maxCoeff() - rounding));
  };
  return fill_lattice(curves, AcrossFill{.across = {along(sides.x()), along(sides.y())}});
}

}  // namespace shoreline
