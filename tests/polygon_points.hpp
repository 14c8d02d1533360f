#pragma once
// Exact quadrature of a body with any simple polygon as its outline, as listed material points.

#include <algorithm>
#include <span>

#include "exact_points.hpp"

namespace shoreline::test {

/// What a convex polygon covers of any other, both counter-clockwise (Sutherland and Hodgman). Parts that fall asunder
/// stay joined by edges that run there and back.
inline std::vector<Vec2> clipped(std::vector<Vec2> polygon, const std::vector<Vec2>& convex) {
  for (std::size_t k = 0; k < convex.size() && !polygon.empty(); ++k)
    polygon = left_part(polygon, convex[k], convex[(k + 1) % convex.size()]);
  return polygon;
}

/// n² Gauss points in each of the trapezoids into which lines y = const through all vertices cut a polygon.
inline void add_polygon(const std::vector<Vec2>& polygon, const QuadratureRule& rule,
                        std::vector<Case::ListedPoint>& points) {
  std::vector<double> level;
  for (const Vec2& v : polygon) level.push_back(v.y());
  std::ranges::sort(level);
  for (std::size_t s = 0; s + 1 < level.size(); ++s) {
    const double low = level[s];
    const double high = level[s + 1];
    std::vector<std::array<double, 2>> side;  // x at low and at high
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      Vec2 a = polygon[k];
      Vec2 b = polygon[(k + 1) % polygon.size()];
      if (a.y() > b.y()) std::swap(a, b);
      if (a.y() > low || b.y() < high || a.y() == b.y()) continue;
      const auto at = [&](double y) { return a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()); };
      side.push_back({at(low), at(high)});
    }
    std::ranges::sort(side, {}, [](const auto& x) { return x[0] + x[1]; });
    for (std::size_t k = 0; k + 1 < side.size(); k += 2)
      for (Eigen::Index i = 0; i < rule.point.size(); ++i)
        for (Eigen::Index j = 0; j < rule.point.size(); ++j) {
          const double r = rule.point[i];
          const double left = (1.0 - r) * side[k][0] + r * side[k][1];
          const double width = (1.0 - r) * side[k + 1][0] + r * side[k + 1][1] - left;
          const double volume = rule.weight[i] * rule.weight[j] * width * (high - low);
          if (volume > 0.0) points.push_back({{left + rule.point[j] * width, (1.0 - r) * low + r * high}, volume});
        }
  }
}

/// As polygon_points, for some cells: halves them until one is left, and clips on the way.
inline void add_cells(const Grid& grid, std::span<Index> cells, std::vector<Vec2> body, const QuadratureRule& rule,
                      std::vector<Case::ListedPoint>& points) {
  if (cells.size() == 1) return add_polygon(clipped(std::move(body), grid.polygon(cells[0])), rule, points);
  Vec2 a = grid.polygon(cells[0])[0];
  Vec2 b = a;
  for (const Index cell : cells)
    for (const Vec2& v : grid.polygon(cell)) {
      a = a.cwiseMin(v);
      b = b.cwiseMax(v);
    }
  body = clipped(std::move(body), {a, {b.x(), a.y()}, b, {a.x(), b.y()}});
  if (body.empty()) return;
  const Eigen::Index axis = b.x() - a.x() > b.y() - a.y() ? 0 : 1;
  const auto half = cells.begin() + static_cast<std::ptrdiff_t>(cells.size() / 2);
  std::ranges::nth_element(cells, half, {}, [&](Index cell) { return grid.polygon(cell)[0][axis]; });
  add_cells(grid, {cells.begin(), half}, body, rule, points);
  add_cells(grid, {half, cells.end()}, body, rule, points);
}

/// Points that integrate polynomials of degree 2n − 2 exactly over what a simple polygon covers of each cell.
/// @param body  corners, counter-clockwise
inline std::vector<Case::ListedPoint> polygon_points(const Grid& grid, const std::vector<Vec2>& body, int n) {
  std::vector<Index> cells(static_cast<std::size_t>(grid.cells()));
  for (std::size_t c = 0; c < cells.size(); ++c) cells[c] = static_cast<Index>(c);
  std::vector<Case::ListedPoint> points;
  add_cells(grid, cells, body, gauss(n), points);
  return points;
}

}  // namespace shoreline::test
