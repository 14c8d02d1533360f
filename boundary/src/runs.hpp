#pragma once
// Corners and ends split the tracking points of a piece into runs.

#include <vector>

#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// Points first, …, first + chords of a piece (closed: modulo its size) without a corner between them.
struct Run {
  std::size_t first;
  std::size_t chords;
};

/// The runs of a piece in order; a closed piece without corners is one that starts and ends at point 0.
[[nodiscard]] std::vector<Run> smooth_runs(const Piece& piece);

}  // namespace shoreline
