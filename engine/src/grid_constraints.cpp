#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "shoreline/bases/error.hpp"
#include "shoreline/engine/scene.hpp"

namespace shoreline {
namespace {

constexpr double on_line = 1e-9;  ///< of a cell

/// Whether the points of a segment lie on one line of the grid.
bool on_grid_line(const Grid& grid, std::span<const BoundaryPoint> points, double tolerance) {
  const Vec2 reach = Vec2::Constant(tolerance);
  const std::vector<Line> lines = grid.lines_near({points.front().x - reach, points.front().x + reach});
  return std::ranges::any_of(lines, [&](const Line& line) {
    return std::ranges::all_of(
        points, [&](const BoundaryPoint& p) { return std::abs(line.normal.dot(p.x) - line.offset) <= tolerance; });
  });
}

/// First and last held component of a segment.
std::pair<int, int> held_components(const BoundaryPiece& piece, const Essential& condition, const BoundaryPoint& p) {
  if (!condition.normal_only) return {0, 1};
  Eigen::Index axis = 0;
  if (p.normal.cwiseAbs().maxCoeff(&axis) < 1.0 - on_line)
    throw InvalidArgument(fmt::format(
        "piece \"{}\" is a roller with method \"grid\" on a line that is not parallel to an axis, at ({:.6g}, {:.6g}); "
        "use method \"implicit_boundary\" or \"nitsche\"",
        piece.piece.name, p.x.x(), p.x.y()));
  return {static_cast<int>(axis), static_cast<int>(axis)};
}

}  // namespace

std::vector<Constraint> grid_constraints(const Basis& basis, const std::vector<BoundaryPiece>& boundary,
                                         const std::vector<Edge>& edges, const Eigen::Matrix2Xd& prescribed) {
  std::vector<Constraint> constraints;
  std::set<std::pair<Index, int>> taken;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const auto* condition = std::get_if<Essential>(&boundary[k].condition);
    if (condition == nullptr || condition->method != EssentialMethod::grid) continue;
    const Edge& edge = edges[k];
    const bool moves = condition->value && prescribed.cols() > 0;
    for (std::size_t s = 0; s < edge.segments.size(); ++s) {
      const auto n = static_cast<std::size_t>(edge.points_per_segment);
      const std::span points(&edge.points[s * n], n);
      const Index cell = edge.segments[s].cell;
      if (!on_grid_line(basis.grid(), points, on_line * basis.grid().size(cell)))
        throw InvalidArgument(
            fmt::format("piece \"{}\" has method \"grid\" but leaves the grid lines near ({:.6g}, {:.6g}); use method "
                        "\"implicit_boundary\" or \"nitsche\", or move the grid",
                        boundary[k].piece.name, points.front().x.x(), points.front().x.y()));
      const auto [low, high] = held_components(boundary[k], *condition, points.front());
      for (const BoundaryPoint& p : points) {
        const Support support = basis.support(cell, p.x);
        for (Eigen::Index a = 0; a < support.value.size(); ++a)
          for (int component = low; component <= high; ++component)
            if (std::abs(support.value[a]) > 1e-6 && taken.emplace(support.function[a], component).second)
              constraints.push_back({support.function[a], component, static_cast<int>(k),
                                     moves ? prescribed(component, support.function[a]) : 0.0});
      }
    }
  }
  return constraints;
}

}  // namespace shoreline
