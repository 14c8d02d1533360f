#pragma once
// One boundary piece at one load step: its curve in the grid, and how its tracking points move on.

#include <functional>

#include "shoreline/boundary/trace.hpp"

namespace shoreline {

/// A piece fitted and traced at the current positions of its tracking points.
struct Edge {
  SplineCurve curve{};
  std::vector<Segment> segments{};
  std::vector<BoundaryPoint> points{};  ///< points_per_segment of each segment, in order
  int points_per_segment = 0;
  std::vector<Index> support_cell{};  ///< a segment: the cell whose polynomials serve it, see nearest_active_cell
  double extended_share = 0.0;        ///< share of the length that lies in cells without material points

  /// The segment of a boundary point.
  [[nodiscard]] std::size_t segment_of(std::size_t point) const {
    return point / static_cast<std::size_t>(points_per_segment);
  }
};

/// The active cell nearest to @p x, searched outward from @p cell over shared faces; @p cell itself where it is active.
///
/// A boundary segment in a cell without material points uses the polynomials of that cell, continued to x: resultant
/// and moment of what acts there are kept.
///
/// @param active  (cells) whether a cell holds a material point of positive volume
/// @throws InvalidArgument if no cell is active
[[nodiscard]] Index nearest_active_cell(const Grid& grid, const std::vector<char>& active, Index cell, const Vec2& x);

/// Fits a piece and traces it.
/// @throws as fit_spline and trace
[[nodiscard]] Edge make_edge(const Piece& piece, const Grid& grid, const std::vector<char>& active,
                             const QuadratureRule& rule);

/// Displacement and its gradient at a boundary place, by the polynomials of an active cell.
struct Motion {
  Vec2 displacement;
  Mat2 gradient;
};

/// Moves the tracking points with the material and turns end tangents by (I + ∇u).
/// @param motion  of the material at x; called with the segment that touches the point
void move_piece(Piece& piece, const Edge& edge, const std::function<Motion(Index cell, const Vec2& x)>& motion);

}  // namespace shoreline
