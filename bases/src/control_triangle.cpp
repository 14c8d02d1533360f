#include "shoreline/bases/control_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "shoreline/bases/error.hpp"
#include "shoreline/bases/triangle_mesh.hpp"

namespace shoreline {
namespace {

constexpr double parallel = 1e-9;  ///< sine of the angle between lines that count as parallel

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Vec2> convex_hull(std::span<const Vec2> points) {
  std::vector<Vec2> sorted(points.begin(), points.end());
  const auto key = [](const Vec2& p) { return std::tuple(p.x(), p.y()); };
  std::ranges::sort(sorted, {}, key);
  std::vector<Vec2> hull;
  for (int chain = 0; chain < 2; ++chain) {  // the lower one, then the upper one from right to left
    const std::size_t begin = hull.size();
    for (const Vec2& p : sorted) {
      while (hull.size() >= begin + 2 && twice_area(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // it begins the other chain
    std::ranges::reverse(sorted);
  }
  return hull;
}

Vec2 intersection(const Line& a, const Line& b) {
  const double sine = cross(a.normal, b.normal);
  return Vec2(a.offset * b.normal.y() - b.offset * a.normal.y(), b.offset * a.normal.x() - a.offset * b.normal.x()) /
         sine;
}

/// The triangle between three lines with inward normals; none if they do not bound one.
std::optional<std::array<Vec2, 3>> between(const Line& a, Line b, Line c) {
  if (cross(a.normal, b.normal) < 0.0) std::swap(b, c);
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
    if (cross(from.normal, to.normal) < parallel) return std::nullopt;
  return std::array{intersection(c, a), intersection(a, b), intersection(b, c)};
}

/// The side across from the corner of two others: orthogonal to their bisector, through the farthest point.
std::optional<Line> closing_side(const Line& a, const Line& b, std::span<const Vec2> points) {
  if (std::abs(cross(a.normal, b.normal)) < parallel) return std::nullopt;
  const Vec2 back = -(a.normal + b.normal).normalized();
  double offset = std::numeric_limits<double>::infinity();
  for (const Vec2& p : points) offset = std::min(offset, back.dot(p));
  return Line{back, offset};
}

}  // namespace

std::array<Vec2, 3> control_triangle(std::span<const Vec2> points, std::span<const Line> sides) {
  std::vector<Line> lines(sides.begin(), sides.end());
  const std::vector<Vec2> hull = convex_hull(points);
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vec2 edge = hull[(k + 1) % hull.size()] - hull[k];
    const Vec2 normal = Vec2(-edge.y(), edge.x()).normalized();
    lines.push_back({normal, normal.dot(hull[k])});
  }
  std::optional<std::array<Vec2, 3>> best;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const std::optional<std::array<Vec2, 3>>& candidate) {
    if (!candidate) return;
    const double area = twice_area((*candidate)[0], (*candidate)[1], (*candidate)[2]);
    if (area >= least) return;
    least = area;
    best = candidate;
  };
  const std::size_t given = sides.size();
  const std::size_t n = lines.size();
  for (std::size_t i = 0; i < (given > 0 ? 1 : n); ++i)
    for (std::size_t j = i + 1; j < (given > 1 ? 2 : n); ++j) {
      if (const auto third = closing_side(lines[i], lines[j], points)) offer(between(lines[i], lines[j], *third));
      for (std::size_t k = j + 1; k < n; ++k) offer(between(lines[i], lines[j], lines[k]));
    }
  if (!best) throw InvalidArgument("control_triangle: all points lie on one line");
  return *best;
}

}  // namespace shoreline
