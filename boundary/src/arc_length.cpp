#include "shoreline/boundary/arc_length.hpp"

#include <algorithm>
#include <cmath>

#include "cubic.hpp"

namespace shoreline {
namespace {

double length_to(const CubicSpan& span, double u) { return part(span, 0.0, u).length(); }

/// The u at which a span has run a length: Newton's method within a bracket.
double inverse(const CubicSpan& span, double length, double whole) {
  double low = 0.0;
  double high = 1.0;
  double u = length / whole;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double excess = length_to(span, u) - length;
    (excess > 0.0 ? high : low) = u;
    if (std::abs(excess) <= 1e-15 * whole) break;
    const double newton = u - excess / span.derivative(u).norm();
    u = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return u;
}

}  // namespace

ArcLength::ArcLength(SplineCurve curve) : curve_(std::move(curve)), start_{0.0} {
  for (const CubicSpan& span : curve_.spans) start_.push_back(start_.back() + span.length());
}

double ArcLength::to(const CurvePlace& place) const {
  return start_of(place.span) + length_to(curve_.spans[static_cast<std::size_t>(place.span)], place.u);
}

CurvePlace ArcLength::at(double arc) const {
  const int last = static_cast<int>(curve_.spans.size()) - 1;
  if (arc >= length()) return {last, 1.0};
  const auto next = std::ranges::upper_bound(start_, arc);
  const int span = std::max(static_cast<int>(next - start_.begin()) - 1, 0);
  const double rest = arc - start_of(span);
  if (rest <= 0.0) return {span, 0.0};
  return {span, inverse(curve_.spans[static_cast<std::size_t>(span)], rest, start_of(span + 1) - start_of(span))};
}

}  // namespace shoreline
