#pragma once
// Curves that close into loops, as one list of spans without gaps.

#include <span>

#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// All spans of curves that close into loops. Where an open curve's end and the nearest start differ (by rounding, or
/// because the two ends moved apart a little) a straight span joins them, so that integrals around the loop are exact.
[[nodiscard]] std::vector<CubicSpan> closed_spans(std::span<const SplineCurve> curves);

/// ½ ∮ (x dy − y dx) of closed spans, exactly for cubics, (R.1) [m²].
[[nodiscard]] double signed_area(std::span<const CubicSpan> spans);

}  // namespace shoreline
