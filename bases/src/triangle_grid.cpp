#include "shoreline/bases/triangle_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

namespace shoreline {
namespace {

std::size_t at(Index number) { return static_cast<std::size_t>(number); }

/// Whether x lies in a triangle, by a margin: least twice the area with each side [m²].
bool holds(const std::array<Vec2, 3>& p, const Vec2& x, double least = 0.0) {
  return twice_area(p[0], p[1], x) >= least && twice_area(p[1], p[2], x) >= least && twice_area(p[2], p[0], x) >= least;
}

/// The same of many points, side by side.
SHORELINE_CLONES bool all_inside(const std::array<Vec2, 3>& p, std::span<const LanePoint> x, double least) {
  auto inside = Lanes{} == Lanes{};
  for (const LanePoint& place : x)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 side = p[(k + 1) % 3] - p[k];
      inside &= side.x() * (place[1] - p[k].y()) - side.y() * (place[0] - p[k].x()) >= least;
    }
  return all_of(inside);
}

double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& x) {
  const Vec2 edge = b - a;
  const double s = std::clamp(edge.dot(x - a) / edge.squaredNorm(), 0.0, 1.0);
  return (x - a - s * edge).norm();
}

/// Distance of a place outside a triangle from it [m].
double distance(const std::array<Vec2, 3>& p, const Vec2& x) {
  return std::min(
      {distance_to_segment(p[0], p[1], x), distance_to_segment(p[1], p[2], x), distance_to_segment(p[2], p[0], x)});
}

/// Whether one of the lines through the edges of a triangle parts it from a box by more than @p slack.
bool parted(const std::array<Vec2, 3>& p, const Box& box, double slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 edge = p[(k + 1) % 3] - p[k];
    const Vec2 inward(-edge.y(), edge.x());
    const Vec2 innermost(inward.x() > 0.0 ? box.upper.x() : box.lower.x(),
                         inward.y() > 0.0 ? box.upper.y() : box.lower.y());
    if (inward.dot(innermost - p[k]) < -slack * edge.norm()) return true;
  }
  return false;
}

/// The line through two points; its normal points to the right half plane or, if vertical, upwards.
Line line_through(const Vec2& a, const Vec2& b) {
  Vec2 normal = Vec2(a.y() - b.y(), b.x() - a.x()).normalized();
  if (normal.x() < 0.0 || (normal.x() == 0.0 && normal.y() < 0.0)) normal = -normal;
  return {normal, normal.dot(0.5 * (a + b))};
}

Box box_of(const std::array<Vec2, 3>& p) {
  return {p[0].cwiseMin(p[1]).cwiseMin(p[2]), p[0].cwiseMax(p[1]).cwiseMax(p[2])};
}

bool overlap(const Box& a, const Box& b) {
  return (a.lower.array() <= b.upper.array()).all() && (b.lower.array() <= a.upper.array()).all();
}

}  // namespace

TriangleGrid::TriangleGrid(TriangleMesh mesh, int parts) : mesh_(std::move(mesh)), parts_(parts) {
  if (parts < 1 || cells() % parts != 0)
    throw InvalidArgument("TriangleGrid: parts must divide the number of triangles, " + std::to_string(cells()) +
                          ", got " + std::to_string(parts));
  check(mesh_, parts == 1 ? smallest_allowed_angle : 0.0);
  bounds_ = shoreline::bounds(mesh_);
  neighbour_ = neighbours(mesh_);
  for (Index main = 0; main < cells() / parts_; ++main) {
    double twice = 0.0;
    for (Index part = main * parts_; part < (main + 1) * parts_; ++part) {
      const auto [a, b, c] = corners(mesh_, part);
      twice += twice_area(a, b, c);
    }
    size_.push_back(std::sqrt(twice));
  }
  number_lines();
  sort_into_bins();
}

/// Edges whose lines agree to twelve digits share one, so that collinear edges give one line.
void TriangleGrid::number_lines() {
  struct Keyed {
    std::array<std::int64_t, 3> key;
    Line line;
    Index cell;
    std::size_t side;
  };
  const Vec2 middle = 0.5 * (bounds_.lower + bounds_.upper);
  const double extent = (bounds_.upper - bounds_.lower).norm();
  const auto rounded = [](double x) { return std::llround(x * 1e12); };
  std::vector<Keyed> edges;
  edges.reserve(3 * mesh_.triangle.size());
  for (Index cell = 0; cell < cells(); ++cell) {
    const std::array<Vec2, 3> p = corners(mesh_, cell);
    for (std::size_t k = 0; k < 3; ++k) {
      const Line line = line_through(p[k], p[(k + 1) % 3]);
      const double offset = (line.offset - line.normal.dot(middle)) / extent;
      edges.push_back({{rounded(line.normal.x()), rounded(line.normal.y()), rounded(offset)}, line, cell, k});
    }
  }
  std::ranges::sort(edges, {}, [](const Keyed& e) { return std::tie(e.key, e.cell, e.side); });
  line_of_.resize(mesh_.triangle.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (e == 0 || edges[e].key != edges[e - 1].key) lines_.push_back(edges[e].line);
    line_of_[at(edges[e].cell)][edges[e].side] = static_cast<Index>(lines_.size()) - 1;
  }
}

/// First and last column, first and last row of the bins that a box meets; at least one of each.
std::array<Index, 4> TriangleGrid::bins_of(const Box& box) const {
  std::array<Index, 4> range{};
  for (int axis = 0; axis < 2; ++axis) {
    const auto side = static_cast<std::size_t>(axis);
    const auto bin = [&](double x) {
      const double number = (x - bins_.lower[axis]) / bins_.width[axis];
      return static_cast<Index>(std::clamp(number, 0.0, bins_.count[side] - 1.0));
    };
    range[2 * side] = bin(box.lower[axis]);
    range[2 * side + 1] = bin(box.upper[axis]);
  }
  return range;
}

/// About one bin a cell. A cell is in every bin that it, widened by the border's slack, meets.
void TriangleGrid::sort_into_bins() {
  const Vec2 margin = Vec2::Constant(2.0 * border_slack * *std::ranges::max_element(size_));
  bins_.lower = bounds_.lower - margin;
  const Vec2 extent = bounds_.upper + margin - bins_.lower;
  const double columns = std::clamp(std::sqrt(cells() * extent.x() / extent.y()), 1.0, 1.0 * cells());
  bins_.count = {static_cast<Index>(std::ceil(columns)), static_cast<Index>(std::ceil(cells() / columns))};
  bins_.width = extent.cwiseQuotient(Vec2(bins_.count[0], bins_.count[1]));

  std::vector<std::pair<Index, Index>> entries;  // (bin, cell)
  for (Index cell = 0; cell < cells(); ++cell) {
    const std::array<Vec2, 3> p = corners(mesh_, cell);
    const double slack = 2.0 * border_slack * size(cell);
    Box box = box_of(p);
    box = {box.lower - Vec2::Constant(slack), box.upper + Vec2::Constant(slack)};
    const auto [left, right, bottom, top] = bins_of(box);
    for (Index j = bottom; j <= top; ++j)
      for (Index i = left; i <= right; ++i) {
        const Vec2 corner = bins_.lower + bins_.width.cwiseProduct(Vec2(i, j));
        if (!parted(p, {corner, corner + bins_.width}, slack)) entries.emplace_back(i + j * bins_.count[0], cell);
      }
  }
  bins_.first.assign(at(bins_.count[0] * bins_.count[1]) + 1, 0);
  for (const auto& [bin, cell] : entries) ++bins_.first[at(bin) + 1];
  std::partial_sum(bins_.first.begin(), bins_.first.end(), bins_.first.begin());
  bins_.cell.resize(entries.size());
  std::vector<Index> next = bins_.first;
  for (const auto& [bin, cell] : entries) bins_.cell[at(next[at(bin)]++)] = cell;
}

std::optional<Index> TriangleGrid::locate(const Vec2& x, Index hint) const {
  if (holds(corners(mesh_, hint), x, clear(hint))) return hint;
  const Vec2 place = (x - bins_.lower).cwiseQuotient(bins_.width);
  if (!(place.minCoeff() >= 0.0 && place.x() < bins_.count[0] && place.y() < bins_.count[1])) return std::nullopt;
  const auto bin = at(static_cast<Index>(place.x()) + static_cast<Index>(place.y()) * bins_.count[0]);
  const auto begin = bins_.cell.begin() + bins_.first[bin];
  const auto end = bins_.cell.begin() + bins_.first[bin + 1];
  for (auto cell = begin; cell != end; ++cell)
    if (holds(corners(mesh_, *cell), x)) return *cell;

  std::optional<Index> nearest;  // beside the grid, or a rounding error off every cell
  double least = border_slack;
  for (auto cell = begin; cell != end; ++cell)
    if (const double cells_away = distance(corners(mesh_, *cell), x) / size(*cell); cells_away <= least) {
      least = cells_away;
      nearest = *cell;
    }
  return nearest;
}

bool TriangleGrid::holds_all(Index cell, std::span<const LanePoint> x) const {
  return all_inside(corners(mesh_, cell), x, clear(cell));
}

std::vector<Vec2> TriangleGrid::polygon(Index cell) const {
  const auto [a, b, c] = corners(mesh_, cell);
  return {a, b, c};
}

std::vector<Line> TriangleGrid::lines_near(const Box& box) const {
  const auto [left, right, bottom, top] = bins_of(box);
  std::vector<Index> numbers;
  for (Index j = bottom; j <= top; ++j)
    for (Index b = left + j * bins_.count[0]; b <= right + j * bins_.count[0]; ++b)
      for (Index k = bins_.first[at(b)]; k < bins_.first[at(b + 1)]; ++k) {
        const Index cell = bins_.cell[at(k)];
        const double slack = border_slack * size(cell);
        const Box reach = box_of(corners(mesh_, cell));
        if (overlap({reach.lower - Vec2::Constant(slack), reach.upper + Vec2::Constant(slack)}, box))
          numbers.insert(numbers.end(), line_of_[at(cell)].begin(), line_of_[at(cell)].end());
      }
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::vector<Line> lines;
  lines.reserve(numbers.size());
  for (const Index number : numbers) lines.push_back(lines_[at(number)]);
  return lines;
}

std::vector<Face> TriangleGrid::faces(Index cell) const {
  const std::array<Vec2, 3> p = corners(mesh_, cell);
  std::vector<Face> faces;
  faces.reserve(3);
  for (std::size_t k = 0; k < 3; ++k)
    if (const Index neighbour = neighbour_[at(cell)][k]; neighbour >= 0)
      faces.push_back({cell, neighbour, p[k], p[(k + 1) % 3]});
  return faces;
}

}  // namespace shoreline
