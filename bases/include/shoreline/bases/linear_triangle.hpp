#pragma once
// The linear basis of a triangle mesh (P1).

#include "shoreline/bases/basis.hpp"
#include "shoreline/bases/triangle_grid.hpp"

namespace shoreline {

/// The barycentric coordinates of each triangle, one function a vertex, (S.3); continuous, not smooth.
class LinearTriangleBasis final : public Basis {
 public:
  /// @throws MeshError by check(mesh)
  explicit LinearTriangleBasis(TriangleMesh mesh) : grid_(std::move(mesh)) {}

  [[nodiscard]] const TriangleGrid& grid() const override { return grid_; }
  [[nodiscard]] Index functions() const override { return static_cast<Index>(grid_.mesh().vertex.size()); }
  [[nodiscard]] int functions_per_cell() const override { return 3; }
  [[nodiscard]] int degree() const override { return 1; }
  [[nodiscard]] int continuity() const override { return 0; }
  [[nodiscard]] int gradient_degree() const override { return 0; }
  [[nodiscard]] ShortIndices functions_of(Index cell) const override;
  [[nodiscard]] Vec2 control_point(Index function) const override;
  void evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const override;
  void evaluate(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const override;
  [[nodiscard]] ShortCurvatures curvatures(Index cell, const Vec2& x) const override;

 private:
  template <class Point, class Number>
  void evaluate_all(Index cell, std::span<const Point> x, Number* value, Number* gradient) const;
  void evaluate_lanes(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const;

  TriangleGrid grid_;
};

}  // namespace shoreline
