#pragma once
// A regular grid of rectangles with any origin, spacing and extent.

#include <array>

#include "shoreline/bases/grid.hpp"

namespace shoreline {

/// Cells [lower + (i, j)·spacing, lower + (i+1, j+1)·spacing], numbered i + j·columns; nodes i + j·(columns + 1).
class QuadrilateralGrid final : public Grid {
 public:
  /// @param lower    lower left corner [m]
  /// @param spacing  width and height of a cell [m], positive
  /// @param cells    number of columns and rows, positive, at most 10⁹ cells
  /// @throws InvalidArgument with the value that breaks a precondition
  QuadrilateralGrid(const Vec2& lower, const Vec2& spacing, const std::array<Index, 2>& cells);

  [[nodiscard]] Index cells() const override { return count_[0] * count_[1]; }
  [[nodiscard]] Box bounds() const override;
  [[nodiscard]] bool covers(const Box& box) const override;
  [[nodiscard]] std::optional<Index> locate(const Vec2& x, Index hint) const override;
  void locate_all(std::span<const Vec2> x, Index hint, Index* cell) const override;
  [[nodiscard]] bool holds_all(Index cell, std::span<const LanePoint> x) const override;
  [[nodiscard]] std::vector<Vec2> polygon(Index cell) const override;
  [[nodiscard]] double size(Index cell) const override;
  [[nodiscard]] std::vector<Line> lines_near(const Box& box) const override;
  [[nodiscard]] bool lines_run_through() const override { return true; }
  [[nodiscard]] std::vector<Face> faces(Index cell) const override;

  [[nodiscard]] const Vec2& spacing() const { return spacing_; }
  [[nodiscard]] Index columns() const { return count_[0]; }
  [[nodiscard]] Index rows() const { return count_[1]; }
  [[nodiscard]] Index nodes() const { return (count_[0] + 1) * (count_[1] + 1); }

  /// Position of grid line @p number in direction @p axis [m].
  [[nodiscard]] double line(int axis, Index number) const { return lower_[axis] + number * spacing_[axis]; }
  /// Lower left corner of a cell [m].
  [[nodiscard]] Vec2 corner(Index cell) const;
  /// Position of a node [m].
  [[nodiscard]] Vec2 node(Index number) const;

 private:
  Vec2 lower_;
  Vec2 spacing_;
  std::array<Index, 2> count_;
};

}  // namespace shoreline
