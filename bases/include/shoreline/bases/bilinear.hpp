#pragma once
// The bilinear basis of a regular quadrilateral grid (Q4).

#include "shoreline/bases/basis.hpp"
#include "shoreline/bases/quadrilateral_grid.hpp"

namespace shoreline {

/// φ = (1 − ξ)(1 − η), ξ(1 − η), (1 − ξ)η, ξη on each cell, 0 <= ξ, η <= 1, one function a node, (S.1); continuous,
/// not smooth.
class BilinearBasis final : public Basis {
 public:
  explicit BilinearBasis(QuadrilateralGrid grid) : grid_(std::move(grid)) {}

  [[nodiscard]] const QuadrilateralGrid& grid() const override { return grid_; }
  [[nodiscard]] Index functions() const override { return grid_.nodes(); }
  [[nodiscard]] int functions_per_cell() const override { return 4; }
  [[nodiscard]] int degree() const override { return 1; }
  [[nodiscard]] int continuity() const override { return 0; }
  [[nodiscard]] int gradient_degree() const override { return 1; }
  [[nodiscard]] ShortIndices functions_of(Index cell) const override;
  [[nodiscard]] Vec2 control_point(Index function) const override { return grid_.node(function); }
  void evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const override;
  void evaluate(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const override;
  [[nodiscard]] ShortCurvatures curvatures(Index cell, const Vec2& x) const override;

 private:
  template <class Point, class Number>
  void evaluate_all(Index cell, std::span<const Point> x, Number* value, Number* gradient) const;
  void evaluate_lanes(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const;

  QuadrilateralGrid grid_;
};

}  // namespace shoreline
