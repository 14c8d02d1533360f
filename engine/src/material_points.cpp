#include "shoreline/engine/material_points.hpp"

#include "point_cells.hpp"
#include "shoreline/bases/counters.hpp"

namespace shoreline {
MaterialPoints points_at(Eigen::Matrix2Xd position, Eigen::VectorXd volume) {
  const Eigen::Index n = volume.size();
  return {.position = std::move(position),
          .displacement = Eigen::Matrix2Xd::Zero(2, n),
          .volume = std::move(volume),
          .stress = Eigen::Matrix4Xd::Zero(4, n),
          .strain = {},
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
  group_points(cell, basis.grid(), supports);
  note_places(points, supports);
  return supports;
}

BasisAtPoints::BasisAtPoints(const Basis& basis, const PointSupports& supports, Evaluate what)
    : basis_(&basis), supports_(&supports) {
  const auto most = static_cast<std::size_t>(supports.most) * static_cast<std::size_t>(supports.functions);
  value_.resize(most);
  if (what == Evaluate::values_and_gradients) gradient_.resize(2 * most);
}

void BasisAtPoints::evaluate(Index c) {
  const auto at = static_cast<std::size_t>(c);
  begin_ = supports_->first[at];
  const Index points = supports_->first[at + 1] - begin_;
  count(Work::evaluations, points);
  basis_->evaluate(supports_->cell[at],
                   std::span(&supports_->place[static_cast<std::size_t>(begin_)], static_cast<std::size_t>(points)),
                   value_.data(), gradient_.empty() ? nullptr : gradient_.data());
}

void sort_by_cell(const Basis& basis, MaterialPoints& points) {
  std::vector<Index> order;
  order_by_cell(cells_of(basis, points), basis.grid().cells(), order);
  reorder(order, points);
}

}  // namespace shoreline
