#include "shoreline/boundary/edge.hpp"

#include <algorithm>
#include <limits>
#include <unordered_set>

namespace shoreline {
namespace {

/// Squared distance from x to the centroid of a cell's vertices.
double distance(const Grid& grid, Index cell, const Vec2& x) {
  Vec2 centre = Vec2::Zero();
  const std::vector<Vec2> polygon = grid.polygon(cell);
  for (const Vec2& vertex : polygon) centre += vertex / static_cast<double>(polygon.size());
  return (x - centre).squaredNorm();
}

}  // namespace

Index nearest_active_cell(const Grid& grid, const std::vector<char>& active, Index cell, const Vec2& x) {
  if (active[static_cast<std::size_t>(cell)]) return cell;
  std::vector<Index> ring{cell};
  std::unordered_set<Index> seen{cell};
  int rings_left = std::numeric_limits<int>::max();
  Index nearest = -1;
  double smallest = std::numeric_limits<double>::infinity();
  while (!ring.empty() && rings_left-- > 0) {
    std::vector<Index> next;
    for (const Index c : ring)
      for (const Face& face : grid.faces(c))
        if (seen.insert(face.neighbour).second) next.push_back(face.neighbour);
    for (const Index c : next) {
      if (!active[static_cast<std::size_t>(c)]) continue;
      if (nearest < 0) rings_left = 1;  // one ring more: a cell across a corner may be nearer
      if (const double d = distance(grid, c, x); d < smallest) {
        smallest = d;
        nearest = c;
      }
    }
    ring = std::move(next);
  }
  if (nearest < 0) throw InvalidArgument("nearest_active_cell: no cell holds a material point");
  return nearest;
}

Edge make_edge(const Piece& piece, const Grid& grid, const std::vector<char>& active, const QuadratureRule& rule) {
  Edge edge;
  edge.curve = fit_spline(piece);
  edge.segments = trace(edge.curve, grid, piece.name);
  edge.points = boundary_points(edge.curve, edge.segments, rule);
  edge.points_per_segment = static_cast<int>(rule.point.size());
  edge.support_cell.reserve(edge.segments.size());
  double length = 0.0;
  double extended = 0.0;
  for (std::size_t s = 0; s < edge.segments.size(); ++s) {
    const auto first = edge.points.begin() + static_cast<std::ptrdiff_t>(s) * edge.points_per_segment;
    const Index cell = edge.segments[s].cell;
    edge.support_cell.push_back(nearest_active_cell(grid, active, cell, first->x));
    double weight = 0.0;
    std::for_each_n(first, edge.points_per_segment, [&](const BoundaryPoint& p) { weight += p.weight; });
    length += weight;
    if (edge.support_cell.back() != cell) extended += weight;
  }
  edge.extended_share = extended / length;
  return edge;
}

void move_piece(Piece& piece, const Edge& edge, const std::function<Motion(Index, const Vec2&)>& motion) {
  const int spans = static_cast<int>(edge.curve.spans.size());
  std::vector<Motion> moved(piece.points.size());
  std::size_t segment = 0;
  for (std::size_t k = 0; k < piece.points.size(); ++k) {
    const int span = std::min(static_cast<int>(k), spans - 1);  // the segment after the point; at an open end before it
    if (static_cast<int>(k) < spans)
      while (edge.segments[segment].span < span) ++segment;
    else
      segment = edge.segments.size() - 1;
    moved[k] = motion(edge.support_cell[segment], piece.points[k]);
  }
  const auto turn = [](std::optional<Vec2>& tangent, const Motion& m) {
    if (tangent) tangent = ((Mat2::Identity() + m.gradient) * *tangent).normalized();
  };
  turn(piece.start_tangent, moved.front());
  turn(piece.end_tangent, moved.back());
  for (std::size_t k = 0; k < piece.points.size(); ++k) piece.points[k] += moved[k].displacement;
}

}  // namespace shoreline
