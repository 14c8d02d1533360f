#pragma once
// How much of each element the body covers.

#include <span>
#include <vector>

#include "shoreline/bases/grid.hpp"
#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// Share of an element that the body covers.
struct CutFraction {
  Index element;    ///< cells element·parts … (element + 1)·parts − 1 of the grid
  double fraction;  ///< |E ∩ Ω|/|E|, above 1e-13
};

/// |E ∩ Ω|/|E| of every element that holds any of the body, (R.6), ascending by element.
///
/// What bulges out of the grid, within border_slack, counts for the element at the border.
///
/// @param curves  that close into loops
/// @param grid    of rectangles or triangles
/// @throws OutsideGrid if a curve leaves the grid
[[nodiscard]] std::vector<CutFraction> cut_fractions(std::span<const SplineCurve> curves, const Grid& grid);

/// Centroid of the whole element [m].
[[nodiscard]] Vec2 element_centre(const Grid& grid, Index element);

}  // namespace shoreline
