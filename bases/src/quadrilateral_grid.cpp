#include "shoreline/bases/quadrilateral_grid.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

constexpr std::int64_t max_cells = 1'000'000'000;

std::string text(const Vec2& v) { return "(" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ")"; }

/// Whether points lie in the cell at @p place, by the rounding of locate.
SHORELINE_CLONES bool all_inside(std::span<const LanePoint> x, const Vec2& lower, const Vec2& spacing,
                                 const std::array<Index, 2>& place) {
  auto inside = Lanes{} == Lanes{};
  for (const LanePoint& point : x)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto d = static_cast<Eigen::Index>(axis);
      const Lanes cells_from_lower = (point[axis] - lower[d]) / spacing[d];
      inside &= (cells_from_lower >= 1.0 * place[axis]) & (cells_from_lower < place[axis] + 1.0);
    }
  return all_of(inside);
}

}  // namespace

QuadrilateralGrid::QuadrilateralGrid(const Vec2& lower, const Vec2& spacing, const std::array<Index, 2>& cells)
    : lower_(lower), spacing_(spacing), count_(cells) {
  if (!lower.allFinite() || !spacing.allFinite() || spacing.minCoeff() <= 0.0)
    throw InvalidArgument("QuadrilateralGrid: need a finite corner and a positive spacing, got " + text(lower) +
                          " and " + text(spacing));
  if (cells[0] < 1 || cells[1] < 1 || std::int64_t{cells[0]} * cells[1] > max_cells)
    throw InvalidArgument("QuadrilateralGrid: need 1 to " + std::to_string(max_cells) + " cells, got " +
                          std::to_string(cells[0]) + " x " + std::to_string(cells[1]));
}

Box QuadrilateralGrid::bounds() const { return {lower_, Vec2(line(0, count_[0]), line(1, count_[1]))}; }

bool QuadrilateralGrid::covers(const Box& box) const {
  const Box all = bounds();
  return (box.lower.array() >= all.lower.array()).all() && (box.upper.array() <= all.upper.array()).all();
}

std::optional<Index> QuadrilateralGrid::locate(const Vec2& x, Index /*hint*/) const {
  std::array<Index, 2> place{};
  for (int axis = 0; axis < 2; ++axis) {
    const double cells_from_lower = (x[axis] - lower_[axis]) / spacing_[axis];
    if (!(cells_from_lower >= -border_slack && cells_from_lower <= count_[axis] + border_slack)) return std::nullopt;
    place[axis] = std::clamp(static_cast<Index>(cells_from_lower), Index{0}, count_[axis] - 1);
  }
  return place[0] + place[1] * count_[0];
}

void QuadrilateralGrid::locate_all(std::span<const Vec2> x, Index hint, Index* cell) const {
  for (const Vec2& place : x) *cell++ = locate(place, hint).value_or(-1);
}

bool QuadrilateralGrid::holds_all(Index cell, std::span<const LanePoint> x) const {
  return all_inside(x, lower_, spacing_, {cell % count_[0], cell / count_[0]});
}

Vec2 QuadrilateralGrid::corner(Index cell) const { return {line(0, cell % count_[0]), line(1, cell / count_[0])}; }

Vec2 QuadrilateralGrid::node(Index number) const {
  return {line(0, number % (count_[0] + 1)), line(1, number / (count_[0] + 1))};
}

std::vector<Vec2> QuadrilateralGrid::polygon(Index cell) const {
  const Vec2 a = corner(cell);
  const Vec2 c(line(0, cell % count_[0] + 1), line(1, cell / count_[0] + 1));
  return {a, Vec2(c.x(), a.y()), c, Vec2(a.x(), c.y())};
}

double QuadrilateralGrid::size(Index /*cell*/) const { return std::sqrt(spacing_.prod()); }

std::vector<Line> QuadrilateralGrid::lines_near(const Box& box) const {
  std::vector<Line> lines;
  for (int axis = 0; axis < 2; ++axis) {
    const auto nearest = [&](double x, int beyond) {
      const double number = std::floor((x - lower_[axis]) / spacing_[axis]) + beyond;
      return static_cast<Index>(std::clamp(number, 0.0, static_cast<double>(count_[axis])));
    };
    for (Index k = nearest(box.lower[axis], 0); k <= nearest(box.upper[axis], 1); ++k)
      lines.push_back({Vec2::Unit(axis), line(axis, k)});
  }
  return lines;
}

std::vector<Face> QuadrilateralGrid::faces(Index cell) const {
  const Index i = cell % count_[0];
  const Index j = cell / count_[0];
  const std::vector<Vec2> p = polygon(cell);
  std::vector<Face> faces;
  faces.reserve(4);
  if (j > 0) faces.push_back({cell, cell - count_[0], p[0], p[1]});
  if (i + 1 < count_[0]) faces.push_back({cell, cell + 1, p[1], p[2]});
  if (j + 1 < count_[1]) faces.push_back({cell, cell + count_[0], p[2], p[3]});
  if (i > 0) faces.push_back({cell, cell - 1, p[3], p[0]});
  return faces;
}

}  // namespace shoreline
