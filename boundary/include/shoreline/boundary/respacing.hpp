#pragma once
// Re-spacing: tracking points whose distances have become too different get new places on their curve.

#include <optional>

#include "shoreline/boundary/arc_length.hpp"

namespace shoreline {

/// Where the material of a re-spaced curve was on the curve before, (B.9). The new tracking points lie on that curve;
/// between two of them places correspond in proportion of arc length, so the map is monotone.
struct PlaceMap {
  ArcLength now;
  ArcLength before;
  std::vector<double> start;  ///< (spans) arc length before at which each span of now starts [m]

  [[nodiscard]] CurvePlace operator()(const CurvePlace& place) const;
};

/// A piece with new tracking points, and how it follows from the one before.
struct Respaced {
  Piece piece;
  PlaceMap places;
};

/// Re-spaces the runs between ends and corners in which the longest chord is more than @p limit times the shortest:
/// their inner points go to equal arc lengths along the current curve. Ends, corners and other runs stay as they are;
/// without corners, a closed piece keeps its point 0. The curve changes about as much as it misses the curve that it
/// interpolates: with order 3 where the spacing is graded.
///
/// @param limit  > 1
/// @return nothing where no run is beyond the limit
/// @throws as fit_spline
[[nodiscard]] std::optional<Respaced> respace(const Piece& piece, double limit);

/// The curve of the start that goes with a re-spaced piece: through the original positions of its tracking points, with
/// the tangents that the one before has at its ends.
/// @param original  the curve of the start that went with the piece before: same spans
[[nodiscard]] SplineCurve respaced_original(const SplineCurve& original, const Respaced& respaced);

}  // namespace shoreline
