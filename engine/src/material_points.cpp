#include "shoreline/engine/material_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "shoreline/engine/failures.hpp"
#include "threads.hpp"

namespace shoreline {
namespace {

constexpr double nudge = 1e-9;  ///< of a cell: moves a point on the outline off a grid line, into the body

/// The cell of every point, in the order of points; −1 outside the grid.
std::vector<Index> cells_of(const Basis& basis, const MaterialPoints& points) {
  const Grid& grid = basis.grid();
  std::vector<Index> cell(static_cast<std::size_t>(points.size()));
#pragma omp parallel if (worth_threads(cell.size()))
  {
    Index before = 0;  // points are sorted by cell: most share that of the point before
#pragma omp for schedule(static)
    for (Index p = 0; p < points.size(); ++p) {
      const std::optional<Index> found = grid.locate(points.position.col(p), before);
      cell[static_cast<std::size_t>(p)] = found.value_or(-1);
      before = found.value_or(before);
    }
  }
  for (const OutlinePoint& edge : points.on_outline) {
    const Vec2 x = points.position.col(edge.point);
    const Index at = std::max(cell[static_cast<std::size_t>(edge.point)], Index{0});
    const Vec2 inside = x + nudge * grid.size(at) * edge.inward;
    if (const auto found = grid.locate(inside, at)) cell[static_cast<std::size_t>(edge.point)] = *found;
  }
  return cell;
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

/// Order of the points by cell; points of one cell keep their order.
void order_by_cell(const std::vector<Index>& cell, std::vector<Index>& order) {
  order.resize(cell.size());
  std::iota(order.begin(), order.end(), 0);
  if (!std::ranges::is_sorted(cell))  // they are until the first point crosses into another cell
    std::ranges::stable_sort(order, {}, [&](Index p) { return cell[static_cast<std::size_t>(p)]; });
}

/// Groups the points by cell. Active is a whole element as soon as one of its cells holds a point.
void group(const std::vector<Index>& cell, const Grid& grid, PointSupports& supports) {
  order_by_cell(cell, supports.point);
  supports.cell.clear();
  supports.first.clear();
  supports.active.assign(static_cast<std::size_t>(grid.cells()), 0);
  for (std::size_t k = 0; k < supports.point.size(); ++k) {
    const Index here = cell[static_cast<std::size_t>(supports.point[k])];
    if (!supports.cell.empty() && supports.cell.back() == here) continue;
    supports.cell.push_back(here);
    supports.first.push_back(static_cast<Index>(k));
    std::fill_n(supports.active.begin() + (here - here % grid.parts()), grid.parts(), 1);
  }
  supports.first.push_back(static_cast<Index>(supports.point.size()));
}

void evaluate(const Basis& basis, const MaterialPoints& points, PointSupports& supports) {
  const Eigen::Index n = supports.functions;
  supports.value.resize(points.size() * n);
  supports.gradient.resize(points.size() * 2 * n);
#pragma omp parallel if (worth_threads(supports.point.size()))
  {
    std::vector<Vec2> x;
#pragma omp for schedule(static)
    for (Index c = 0; c < supports.cells(); ++c) {
      const auto at = static_cast<std::size_t>(c);
      const Index begin = supports.first[at];
      x.clear();
      for (Index k = begin; k < supports.first[at + 1]; ++k)
        x.push_back(points.position.col(supports.point[static_cast<std::size_t>(k)]));
      basis.evaluate(supports.cell[at], x, &supports.value[begin * n], &supports.gradient[begin * 2 * n]);
    }
  }
}

}  // namespace

MaterialPoints points_at(Eigen::Matrix2Xd position, Eigen::VectorXd volume) {
  const Eigen::Index n = volume.size();
  return {.position = std::move(position),
          .displacement = Eigen::Matrix2Xd::Zero(2, n),
          .volume = std::move(volume),
          .stress = Eigen::Matrix4Xd::Zero(4, n),
          .strain = Eigen::Matrix3Xd::Zero(3, n),
          .on_outline = {}};
}

void check_inside(const Basis& basis, const MaterialPoints& points) {
  Box box{points.position.col(0), points.position.col(0)};
  Vec2 sum = Vec2::Zero();  // is finite if all are; a minimum need not notice
  for (Index p = 0; p < points.size(); ++p) {
    const Vec2 x = points.position.col(p);
    box.lower = box.lower.cwiseMin(x);
    box.upper = box.upper.cwiseMax(x);
    sum += x;
  }
  if (!sum.allFinite() || !basis.grid().covers(box)) require_inside(cells_of(basis, points), points);
}

PointSupports locate_points(const Basis& basis, const MaterialPoints& points, PointSupports reuse) {
  const std::vector<Index> cell = cells_of(basis, points);
  require_inside(cell, points);
  PointSupports supports = std::move(reuse);
  supports.functions = basis.functions_per_cell();
  group(cell, basis.grid(), supports);
  evaluate(basis, points, supports);
  return supports;
}

void sort_by_cell(const Basis& basis, MaterialPoints& points) {
  std::vector<Index> order;
  order_by_cell(cells_of(basis, points), order);
  const MaterialPoints before = points;
  std::vector<Index> place(order.size());
  for (Index k = 0; k < points.size(); ++k) {
    const Index p = order[static_cast<std::size_t>(k)];
    place[static_cast<std::size_t>(p)] = k;
    points.position.col(k) = before.position.col(p);
    points.displacement.col(k) = before.displacement.col(p);
    points.volume[k] = before.volume[p];
    points.stress.col(k) = before.stress.col(p);
    points.strain.col(k) = before.strain.col(p);
  }
  for (OutlinePoint& edge : points.on_outline) edge.point = place[static_cast<std::size_t>(edge.point)];
}

}  // namespace shoreline
