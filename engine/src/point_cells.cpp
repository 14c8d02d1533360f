#include "point_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

#include "shoreline/engine/failures.hpp"
#include "threads.hpp"

namespace shoreline {
namespace {

constexpr double nudge = 1e-9;  ///< of a cell: moves a point on the outline off a grid line, into the body

}  // namespace

std::vector<Index> cells_of(const Basis& basis, const MaterialPoints& points) {
  const Grid& grid = basis.grid();
  std::vector<Index> cell(static_cast<std::size_t>(points.size()));
  constexpr Index batch = 64;
#pragma omp parallel if (worth_threads(cell.size()))
  {
    std::array<Vec2, batch> x;
    Index before = 0;  // points are sorted by cell: most share that of the point before
#pragma omp for schedule(static)
    for (Index first = 0; first < points.size(); first += batch) {
      const Index count = std::min(batch, points.size() - first);
      for (Index k = 0; k < count; ++k) x[static_cast<std::size_t>(k)] = points.position.col(first + k);
      Index* const found = &cell[static_cast<std::size_t>(first)];
      grid.locate_all(std::span(x.data(), static_cast<std::size_t>(count)), before, found);
      before = std::max(found[count - 1], Index{0});
    }
  }
  keep_on_body_side(basis, points, cell);
  return cell;
}

void keep_on_body_side(const Basis& basis, const MaterialPoints& points, std::vector<Index>& cell) {
  const Grid& grid = basis.grid();
  for (const OutlinePoint& edge : points.on_outline) {
    const Vec2 x = points.position.col(edge.point);
    const Index at = std::max(cell[static_cast<std::size_t>(edge.point)], Index{0});
    const Vec2 inside = x + nudge * grid.size(at) * edge.inward;
    if (const auto found = grid.locate(inside, at)) cell[static_cast<std::size_t>(edge.point)] = *found;
  }
}

void require_inside(const std::vector<Index>& cell, const MaterialPoints& points) {
  const auto outside = std::ranges::count(cell, -1);
  if (outside == 0) return;
  const auto p = std::ranges::find(cell, -1) - cell.begin();
  throw ComputationError(fmt::format(
      "{} of {} material points lie outside the grid, the first is point {} at ({:.6g}, {:.6g}); enlarge the grid or "
      "reduce the load",
      outside, cell.size(), p, points.position(0, p), points.position(1, p)));
}

void order_by_cell(const std::vector<Index>& cell, Index cells, std::vector<Index>& order) {
  order.resize(cell.size());
  if (std::ranges::is_sorted(cell)) {  // they are until the first point crosses into another cell
    std::iota(order.begin(), order.end(), 0);
    return;
  }
  std::vector<Index> next(static_cast<std::size_t>(cells) + 1, 0);
  for (const Index c : cell) ++next[static_cast<std::size_t>(c) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t p = 0; p < cell.size(); ++p)
    order[static_cast<std::size_t>(next[static_cast<std::size_t>(cell[p])]++)] = static_cast<Index>(p);
}

void group_points(const std::vector<Index>& cell, const Grid& grid, PointSupports& supports) {
  std::vector<Index>& first = supports.first;  // of all cells before it becomes that of occupied ones
  first.assign(static_cast<std::size_t>(grid.cells()) + 1, 0);
  for (const Index c : cell) ++first[static_cast<std::size_t>(c) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  supports.point.resize(cell.size());
  for (std::size_t p = 0; p < cell.size(); ++p)
    supports.point[static_cast<std::size_t>(first[static_cast<std::size_t>(cell[p])]++)] = static_cast<Index>(p);
  supports.cell.clear();
  supports.most = 0;
  // active is a whole element as soon as one of its cells holds a point
  supports.active.assign(static_cast<std::size_t>(grid.cells()), 0);
  Index begin = 0;
  for (Index c = 0; c < grid.cells(); ++c) {
    const Index end = first[static_cast<std::size_t>(c)];  // where its last point was put
    if (end == begin) continue;
    supports.most = std::max(supports.most, end - begin);
    first[supports.cell.size()] = std::exchange(begin, end);
    supports.cell.push_back(c);
    std::fill_n(supports.active.begin() + (c - c % grid.parts()), grid.parts(), 1);
  }
  first[supports.cell.size()] = begin;
  first.resize(supports.cell.size() + 1);
}

void reorder(const std::vector<Index>& order, MaterialPoints& points) {
  reorder_columns(order, points.position);
  reorder_columns(order, points.displacement);
  reorder_columns(order, points.stress);
  if (points.strain.cols() > 0) reorder_columns(order, points.strain);
  std::vector<Index> place(static_cast<std::size_t>(points.size()), -1);
  for (std::size_t k = 0; k < order.size(); ++k) place[static_cast<std::size_t>(order[k])] = static_cast<Index>(k);
  reorder_entries(order, points.volume);
  for (OutlinePoint& edge : points.on_outline) edge.point = place[static_cast<std::size_t>(edge.point)];
  std::erase_if(points.on_outline, [](const OutlinePoint& edge) { return edge.point < 0; });
}

void note_places(const MaterialPoints& points, PointSupports& supports) {
  supports.place.resize(supports.point.size());
#pragma omp parallel for schedule(static) if (worth_threads(supports.point.size()))
  for (std::size_t k = 0; k < supports.point.size(); ++k) supports.place[k] = points.position.col(supports.point[k]);
}

}  // namespace shoreline
