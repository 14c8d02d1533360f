#pragma once
// Where a support that acts in a band integrates along its edge.

#include "shoreline/bases/basis.hpp"
#include "shoreline/boundary/edge.hpp"

namespace shoreline {

/// p + 1 points a segment: with more, the penalty holds more than the trace of the basis can follow on a curve.
[[nodiscard]] inline QuadratureRule slip_rule(const Basis& basis) { return gauss(basis.degree() + 1); }

/// The points of an edge by this rule, the same number in each segment, in order.
[[nodiscard]] inline std::vector<BoundaryPoint> slip_points(const Basis& basis, const Edge& edge) {
  return boundary_points(edge.curve, edge.segments, slip_rule(basis));
}

}  // namespace shoreline
