#pragma once
// The background grid: cells that tile a part of the plane. It knows nothing of functions, nor of the body.

#include <optional>
#include <span>
#include <vector>

#include "shoreline/bases/lanes.hpp"
#include "shoreline/bases/types.hpp"

namespace shoreline {

/// The line {x : normal·x = offset}; |normal| = 1.
struct Line {
  Vec2 normal;
  double offset;  ///< [m]
};

/// An edge that two cells share; it runs from a to b with @ref cell on its left.
struct Face {
  Index cell;
  Index neighbour;
  Vec2 a;
  Vec2 b;
};

/// How far outside the grid, in cells, a place still belongs to the cell at the border: what is held on the border may
/// slip a little.
inline constexpr double border_slack = 0.01;

/// Cells on each of which every function of a basis is one polynomial.
///
/// Cells are convex polygons numbered from 0. Everything that follows the edge of the body through the grid (trace,
/// ghost faces, nearest active cell) is written against this class alone.
class Grid {
 public:
  virtual ~Grid() = default;

  [[nodiscard]] virtual Index cells() const = 0;

  /// Cells e·parts … (e + 1)·parts − 1 are the parts of element e, all of which the same functions see: the six of a
  /// Powell-Sabin triangle; else 1.
  [[nodiscard]] virtual int parts() const { return 1; }

  /// The smallest box that holds all cells.
  [[nodiscard]] virtual Box bounds() const = 0;

  /// Whether a whole box lies in the grid. A grid may answer no where it cannot tell at once.
  [[nodiscard]] virtual bool covers(const Box& /*box*/) const { return false; }

  /// The cell that holds @p x; none more than border_slack outside the grid. On an edge one of its cells, which
  /// does not depend on the hint.
  /// @param hint  a cell near x (the one that held the point before), or 0
  [[nodiscard]] virtual std::optional<Index> locate(const Vec2& x, Index hint) const = 0;

  /// The cells that hold places near each other, −1 for none.
  /// @param x     (m) [m]
  /// @param hint  a cell near the first
  /// @param cell  (m)
  virtual void locate_all(std::span<const Vec2> x, Index hint, Index* cell) const;

  /// Whether locate finds @p cell for all of these points [m]. A grid may answer no where it cannot tell at once.
  [[nodiscard]] virtual bool holds_all(Index /*cell*/, std::span<const LanePoint> /*x*/) const { return false; }

  /// Vertices of a cell, counter-clockwise [m].
  [[nodiscard]] virtual std::vector<Vec2> polygon(Index cell) const = 0;

  /// The length h of a cell [m]: √(area) of a rectangle, √(2·area) of a triangle. Bands and penalties scale with it.
  [[nodiscard]] virtual double size(Index cell) const = 0;

  /// The lines on which edges of cells lie that meet @p box, or that it lies beside by at most border_slack; more lines
  /// than that do no harm.
  [[nodiscard]] virtual std::vector<Line> lines_near(const Box& box) const = 0;

  /// Whether every line runs through the whole grid, so that a box meets few; else about as many as it meets cells.
  [[nodiscard]] virtual bool lines_run_through() const { return false; }

  /// The faces that a cell shares with others; the cell is on their left.
  [[nodiscard]] virtual std::vector<Face> faces(Index cell) const = 0;
};

}  // namespace shoreline
