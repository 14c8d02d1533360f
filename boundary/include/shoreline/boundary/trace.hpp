#pragma once
// Where a curve runs through the cells of a grid.

#include <vector>

#include "shoreline/bases/error.hpp"
#include "shoreline/bases/grid.hpp"
#include "shoreline/bases/quadrature.hpp"
#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// A part of one span that lies in one cell.
struct Segment {
  int span;
  double begin;  ///< u in the span, [0, 1)
  double end;    ///< u in the span, (begin, 1]
  Index cell;    ///< where the segment runs along a cell edge: the cell on the body's side, its left
};

/// A quadrature point on the edge of the body.
struct BoundaryPoint {
  Vec2 x;         ///< [m]
  Vec2 normal;    ///< unit normal into the body
  double weight;  ///< [m]; the weights of a curve sum to its length
  Index cell;     ///< that holds x, on the body's side
  int span;       ///< place on the curve, which moves with the material
  double u;       ///< in [0, 1]
};

/// A curve reaches outside the grid.
class OutsideGrid : public Error {
 public:
  using Error::Error;
};

/// Splits a curve at every crossing with a line of the grid and at its own knots.
///
/// The segments of each span tile [0, 1] without gap or overlap, in order, and consecutive ones of a span lie in
/// different cells. A touch, a run along a line and a passage through a node need no care by the caller. A curve within
/// 1e-9 of the cell size of a line counts as on it, also on the border of the grid.
///
/// @param name  of the piece, for the message
/// @throws OutsideGrid with piece and position where the curve leaves the grid
[[nodiscard]] std::vector<Segment> trace(const SplineCurve& curve, const Grid& grid, const std::string& name);

/// Gauss points of every segment: u = begin + (end − begin) ξ, weight w |C'| (end − begin), (B.6).
[[nodiscard]] std::vector<BoundaryPoint> boundary_points(const SplineCurve& curve, const std::vector<Segment>& segments,
                                                         const QuadratureRule& rule);

}  // namespace shoreline
