#pragma once
// The outline of the body: boundary pieces that close into loops.

#include <span>
#include <vector>

#include "shoreline/bases/error.hpp"
#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// The pieces do not bound a body. The message names the piece and the coordinates.
class OutlineError : public Error {
 public:
  OutlineError(int piece, const std::string& message) : Error(message), piece_(piece) {}
  /// Number of the piece at fault.
  [[nodiscard]] int piece() const { return piece_; }

 private:
  int piece_;
};

/// Closes pieces into loops; each loop lists its pieces in order. Done once: motion does not change it.
///
/// An end meets a start where they are at most 1e-9 of the outline's size apart.
///
/// @pre    fit_spline accepts each piece
/// @throws OutlineError where a piece's end meets no start (open loop), more than one, or one that another end meets
[[nodiscard]] std::vector<std::vector<int>> close_loops(std::span<const Piece> pieces);

/// Checks that the curves bound a body: no curve of no length; no crossing or touch of a curve with itself or another,
/// except where consecutive pieces of a loop meet; outer loops counter-clockwise, holes clockwise (and
/// counter-clockwise again for a body within a hole).
///
/// @param curves  (pieces) their splines
/// @param loops   as close_loops returns them
/// @throws OutlineError with the piece and the place
void check_outline(std::span<const Piece> pieces, std::span<const SplineCurve> curves,
                   std::span<const std::vector<int>> loops);

}  // namespace shoreline
