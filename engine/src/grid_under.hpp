#pragma once
// Whether triangles lie under the whole body.

#include <fmt/format.h>

#include <cmath>

#include "shoreline/bases/error.hpp"
#include "shoreline/boundary/region.hpp"

namespace shoreline {

/// A grid may have holes; the body may not reach over them.
/// @param covered  area of the body in all triangles [m²]
/// @throws InvalidArgument with both areas
inline void require_grid_under(const Region& region, double covered) {
  constexpr double tolerance = 1e-9;
  if (std::abs(covered - region.area()) > tolerance * region.area())
    throw InvalidArgument(
        fmt::format("the triangles under the body hold {:.6g} m² of its {:.6g} m²; expected all (mesh what is missing, "
                    "or change the outline)",
                    covered, region.area()));
}

}  // namespace shoreline
