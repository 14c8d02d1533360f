#pragma once
// A curve by its arc length.

#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// A place on a curve.
struct CurvePlace {
  int span;
  double u;  ///< in [0, 1]
};

/// Arc length s(span, u) = ∫ |C'| du from the start of a curve, to rounding, and its inverse.
class ArcLength {
 public:
  /// @pre the curve has spans, each of positive length
  explicit ArcLength(SplineCurve curve);

  [[nodiscard]] const SplineCurve& curve() const { return curve_; }
  [[nodiscard]] double length() const { return start_.back(); }  ///< of the whole curve [m]

  /// Arc length at which a span starts [m].
  /// @param span  0 to the number of spans, whose start is the end of the curve
  [[nodiscard]] double start_of(int span) const { return start_[static_cast<std::size_t>(span)]; }

  /// Arc length from the start of the curve to a place [m].
  [[nodiscard]] double to(const CurvePlace& place) const;

  /// The place at an arc length [m]; below 0 the start of the curve, beyond its length the end. Where two spans meet,
  /// the start of the latter.
  [[nodiscard]] CurvePlace at(double arc) const;

 private:
  SplineCurve curve_;
  std::vector<double> start_;  ///< (spans + 1) [m]
};

}  // namespace shoreline
