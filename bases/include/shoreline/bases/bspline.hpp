#pragma once
// Tensor-product B-splines on a regular quadrilateral grid.

#include <vector>

#include "shoreline/bases/basis.hpp"
#include "shoreline/bases/quadrilateral_grid.hpp"

namespace shoreline {

/// Products of B-splines of degree p in x and y with open uniform knots on the grid lines, (S.11), (S.12): C^(p−1)
/// across them, interpolating at the border. Functions are numbered i + j·(columns + p); degree 1 is the bilinear
/// basis.
class BSplineBasis final : public Basis {
 public:
  /// @param degree  p, 1 to 3
  /// @throws InvalidArgument with the degree if it is out of range
  BSplineBasis(QuadrilateralGrid grid, int degree);

  [[nodiscard]] const QuadrilateralGrid& grid() const override { return grid_; }
  [[nodiscard]] Index functions() const override { return (grid_.columns() + degree_) * (grid_.rows() + degree_); }
  [[nodiscard]] int functions_per_cell() const override { return (degree_ + 1) * (degree_ + 1); }
  [[nodiscard]] int degree() const override { return degree_; }
  [[nodiscard]] int continuity() const override { return degree_ - 1; }
  [[nodiscard]] int gradient_degree() const override { return 2 * degree_ - 1; }
  [[nodiscard]] ShortIndices functions_of(Index cell) const override;
  [[nodiscard]] Vec2 control_point(Index function) const override;
  void evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const override;
  void evaluate(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const override;
  [[nodiscard]] std::optional<ProductCell> product_cell(Index cell) const override;
  [[nodiscard]] ShortCurvatures curvatures(Index cell, const Vec2& x) const override;

 private:
  /// The p + 1 functions of one knot span as polynomials: coefficient (function, power of ξ).
  using SpanPolynomials = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;

  static std::vector<SpanPolynomials> all_spans(Index spans, int degree);
  template <int P, class Point, class Number>
  void evaluate_degree(Index cell, std::span<const Point> x, Number* value, Number* gradient) const;
  template <class Point, class Number>
  void evaluate_all(Index cell, std::span<const Point> x, Number* value, Number* gradient) const;
  void evaluate_lanes(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const;

  QuadrilateralGrid grid_;
  int degree_;
  std::vector<SpanPolynomials> column_;
  std::vector<SpanPolynomials> row_;
};

}  // namespace shoreline
