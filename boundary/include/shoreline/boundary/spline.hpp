#pragma once
// The edge of the body: a cubic spline through tracking points, one Bézier span between each two of them.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "shoreline/bases/types.hpp"

namespace shoreline {

/// The tracking points of one boundary piece, and what is known of the curve through them. The material lies to the
/// left of the direction in which they run.
struct Piece {
  std::string name{};
  std::vector<Vec2> points{};  ///< [m]; at least 2, closed: 3; a closed piece does not repeat its first point
  std::vector<int> corners{};  ///< inner points (closed: any points) at which the tangent may jump
  bool closed = false;
  std::optional<Vec2> start_tangent{};  ///< direction at an open end where it is known (arcs); else extrapolated
  std::optional<Vec2> end_tangent{};
};

/// A cubic Bézier span, C(u) = Σ B_k³(u) P_k, u in [0, 1].
struct CubicSpan {
  std::array<Vec2, 4> control;  ///< [m]

  [[nodiscard]] Vec2 position(double u) const;    ///< exactly P_0 at u = 0 and P_3 at u = 1
  [[nodiscard]] Vec2 derivative(double u) const;  ///< dC/du [m]
  [[nodiscard]] Box bounds() const;               ///< of the control polygon, which holds the span
  [[nodiscard]] double length() const;            ///< by Gauss quadrature, converged to rounding [m]
};

/// The C¹ cubic B-spline through the tracking points, as its spans. A place on it is (span, u).
struct SplineCurve {
  std::vector<CubicSpan> spans;  ///< span k runs from point k to point k + 1 (closed: the last one back to point 0)
  std::vector<double> knots;  ///< (spans + 1) ū_0 = 0, ū_{k+1} = ū_k + 3|P_1 − P_0|; each inner one is double, (B.5)
  bool closed = false;
};

/// Local cubic interpolation of the points of a piece (Piegl & Tiller, The NURBS Book, §9.3.4). With the chords
/// q_k = Q_k − Q_{k−1}, the unit tangent at Q_k is
///
///     T_k = V_k / |V_k|,  V_k = (1 − a_k) q_k + a_k q_{k+1},                              (B.1)
///     a_k = |q_{k−1} × q_k| / (|q_{k−1} × q_k| + |q_{k+1} × q_{k+2}|), ½ on a straight line,  (B.2)
///
/// and the span from Q_k to Q_{k+1} has the same speed s at both ends and in the middle:
///
///     (16 − |T_k + T_{k+1}|²) s² + 12 (P_3 − P_0)·(T_k + T_{k+1}) s − 36 |P_3 − P_0|² = 0,  (B.3)
///     P_1 = P_0 + (s/3) T_k,  P_2 = P_3 − (s/3) T_{k+1}.                                    (B.4)
///
/// Ends and corners split the points into runs; (B.2) never looks across a corner. Chords are continued beyond the ends
/// of a run by q_0 = 2q_1 − q_2, q_{−1} = 2q_0 − q_1, and likewise at its far end. Without corners a closed piece
/// wraps. At a corner the tangent is the direction of the chord on either side; at an end of the piece it is the one
/// given, else that of (B.1), or of the chord where (B.1) would point backwards. One chord alone is straight.
///
/// @throws InvalidArgument naming the piece: fewer than 2 points (closed: 3), not finite, two consecutive points equal,
///         a corner that is no inner point, an end tangent of a closed piece or without direction, points that run
///         back and forth on a line, so that (B.1) has no direction
[[nodiscard]] SplineCurve fit_spline(const Piece& piece);

}  // namespace shoreline
