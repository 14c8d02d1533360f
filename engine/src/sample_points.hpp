#pragma once
// Sample points: where errors are measured, the same places whatever the grid, the basis and the material points.

#include <span>

#include "shoreline/boundary/spline.hpp"
#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// One sample in each sub-cell that the body covers, at the centroid of that part and with its area, (N.9).
///
/// Sub-cells are those of the smallest box that holds the outline, as square as whole numbers allow.
///
/// @param curves  that close into loops
/// @param across  sub-cells along the longer side of the box, at least 1
[[nodiscard]] MaterialPoints place_samples(std::span<const SplineCurve> curves, int across);

}  // namespace shoreline
