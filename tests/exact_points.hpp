#pragma once
// Exact quadrature of a polygonal body: Gauss points of every cell, clipped by the body, as listed material points.

#include "shoreline/bases/grid.hpp"
#include "shoreline/bases/quadrature.hpp"
#include "shoreline/engine/case.hpp"

namespace shoreline::test {

/// The part of a convex polygon to the left of the line from a to b.
inline std::vector<Vec2> left_part(const std::vector<Vec2>& polygon, const Vec2& a, const Vec2& b) {
  std::vector<Vec2> part;
  const auto height = [&](const Vec2& x) { return cross(b - a, x - a); };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2& x = polygon[k];
    const Vec2& next = polygon[(k + 1) % polygon.size()];
    const double here = height(x);
    const double there = height(next);
    if (here >= 0.0) part.push_back(x);
    if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0))
      part.push_back(x + here / (here - there) * (next - x));
  }
  return part;
}

/// n² points in a triangle, exact to degree 2n − 2: a Gauss rule of a square that collapses on corner a.
inline void add_triangle(const std::array<Vec2, 3>& p, const QuadratureRule& rule,
                         std::vector<Case::ListedPoint>& points) {
  const double twice = cross(p[1] - p[0], p[2] - p[0]);
  for (Eigen::Index i = 0; i < rule.point.size(); ++i)
    for (Eigen::Index j = 0; j < rule.point.size(); ++j) {
      const double s = rule.point[i];
      points.push_back(
          {p[0] + s * (p[1] - p[0] + rule.point[j] * (p[2] - p[1])), rule.weight[i] * rule.weight[j] * s * twice});
    }
}

/// Points that integrate polynomials of degree 2n − 2 exactly over what a convex polygon covers of each cell.
/// @param body  corners, counter-clockwise
inline std::vector<Case::ListedPoint> exact_points(const Grid& grid, const std::vector<Vec2>& body, int n) {
  const QuadratureRule rule = gauss(n);
  std::vector<Case::ListedPoint> points;
  for (Index cell = 0; cell < grid.cells(); ++cell) {
    std::vector<Vec2> part = grid.polygon(cell);
    for (std::size_t k = 0; k < body.size() && !part.empty(); ++k)
      part = left_part(part, body[k], body[(k + 1) % body.size()]);
    const double negligible = 1e-14 * grid.size(cell) * grid.size(cell);
    for (std::size_t k = 2; k < part.size(); ++k)
      if (cross(part[k - 1] - part[0], part[k] - part[0]) > negligible)
        add_triangle({part[0], part[k - 1], part[k]}, rule, points);
  }
  return points;
}

}  // namespace shoreline::test
