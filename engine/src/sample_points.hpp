#pragma once
// Sample points: where errors are measured, the same places whatever the grid, the basis and the material points.

#include <span>

#include "move_points.hpp"
#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// One sample in each sub-cell that the body covers, at the centroid of that part and with its area, (N.9).
///
/// Sub-cells are those of the smallest box that holds the outline, as square as whole numbers allow.
///
/// @param curves  that close into loops
/// @param across  sub-cells along the longer side of the box, at least 1
[[nodiscard]] MaterialPoints place_samples(std::span<const SplineCurve> curves, int across);

/// The cells whose polynomials serve the samples, and the basis there: the cell in which a sample lies or, where that
/// holds no material, the nearest one that does, continued to the sample, as for boundary segments.
///
/// @param active  (cells of the grid) those of the material points
/// @throws ComputationError naming the first sample outside the grid and its position
[[nodiscard]] PointSupports locate_samples(const Basis& basis, const std::vector<char>& active,
                                           const MaterialPoints& samples);

/// Carries the samples along with the material in a load step, as material points are.
/// @throws ComputationError as locate_samples
void move_samples(const StepMotion& motion, const std::vector<char>& active, MaterialPoints& samples);

}  // namespace shoreline
