#pragma once
// The inside of the outline: what lies in it, and how much of each cell.

#include <memory>
#include <span>
#include <vector>

#include "shoreline/bases/quadrilateral_grid.hpp"
#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// The region to the left of closed curves. Ends of curves that meet with a small gap are joined by a straight span.
class Region {
 public:
  /// @param curves  that close into loops, in any order
  explicit Region(std::span<const SplineCurve> curves);
  ~Region();
  Region(Region&&) noexcept;
  Region& operator=(Region&&) noexcept;

  /// Whether the curves wind around @p x. On the outline itself either answer.
  [[nodiscard]] bool contains(const Vec2& x) const;

  /// ½ ∮ (x dy − y dx), exactly for cubic spans, (R.1) [m²].
  [[nodiscard]] double area() const;

  /// The smallest box that holds the outline [m].
  [[nodiscard]] Box bounds() const;

  /// Whether the distance from @p x to the outline is at most @p distance > 0 [m].
  [[nodiscard]] bool near_outline(const Vec2& x, double distance) const;

 private:
  struct Spans;  // all spans and their spatial index
  std::unique_ptr<const Spans> spans_;
};

/// Highest order of moments that cell_moments computes.
inline constexpr int max_moment_order = 8;

/// Moments of the covered part of the cells of a lattice, in coordinates about each cell's centre.
struct CellMoments {
  std::vector<Index> cell;  ///< cells of which more than 1e-13 of the area is covered, ascending
  Eigen::MatrixXd moment;  ///< (monomials, cells): ∫ ξ^a η^b dA for a + b <= order, ordered (0,0) (1,0) (0,1) (2,0) …
};

/// ∫_{cell ∩ Ω} ξ^a η^b dA of every covered cell by Green's theorem on the cubics themselves, (R.2):
///
///     ∫ ξ^a η^b dA = −∮ (∫_ξ^{w/2} s^a ds) η^b dη over the boundary of cell ∩ Ω.
///
/// A row of cells is swept from its left end: a span adds the integral to its own cell and the one with the cell's full
/// width to every cell right of it, so no topology of cut cells is needed, (R.3), and the areas sum to that of the
/// region. A cell that no curve meets has the moments of the whole cell, exactly.
///
/// @param curves   that close into loops
/// @param lattice  any regular grid that holds them
/// @param order    highest a + b, 0 to max_moment_order
/// @throws OutsideGrid if a curve leaves the lattice, InvalidArgument if the order is out of range
[[nodiscard]] CellMoments cell_moments(std::span<const SplineCurve> curves, const QuadrilateralGrid& lattice,
                                       int order);

}  // namespace shoreline
