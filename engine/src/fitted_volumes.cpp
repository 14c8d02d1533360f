#include "fitted_volumes.hpp"

#include <algorithm>
#include <cmath>

#include "shoreline/boundary/body_moments.hpp"
#include "shoreline/boundary/fitted_weights.hpp"
#include "shoreline/boundary/region.hpp"
#include "threads.hpp"

namespace shoreline {
namespace {

constexpr double changed = 0.1;  ///< of a plain weight
constexpr double met = 1e-8;     ///< of the area of a cell
constexpr double at_bound = 1.0 + 1e-9;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

std::vector<Eigen::Index> columns_of(const PointSupports& supports, const BodyMoments& moments) {
  std::vector<Eigen::Index> column;
  for (const Index cell : supports.cell) {
    const auto found = std::ranges::lower_bound(moments.cell, cell);
    const bool covered = found != moments.cell.end() && *found == cell;
    column.push_back(covered ? found - moments.cell.begin() : -1);
  }
  return column;
}

/// Up to which order the moments of cells are asked for: on triangles that of products of gradients; on rectangles of
/// all but the highest mixed ones of these.
int order_for(const Basis& basis, bool triangles) { return triangles ? basis.degree() : 2 * basis.degree(); }

/// And up to which they must be met for gradients to be integrated exactly.
int gradient_order(const Basis& basis, bool triangles) { return order_for(basis, triangles) - 1; }

bool has_triangles(const Basis& basis) { return highest_order(basis.grid()) < max_moment_order; }

/// Fits the weights of one cell. Where its points cannot meet all moments, they keep their plain weights.
/// @return whether the weights integrate gradients
bool fit_cell(const Basis& basis, const PointSupports& supports, std::size_t c, const BodyMoments& moments,
              Eigen::Index column, const Eigen::VectorXd& plain, MaterialPoints& points) {
  const Eigen::Index n = supports.first[c + 1] - supports.first[c];
  Eigen::Matrix2Xd x(2, n);
  Eigen::VectorXd weight(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Index p = supports.point[at(supports.first[c]) + static_cast<std::size_t>(k)];
    x.col(k) = points.position.col(p) - moments.centre.col(column);
    weight[k] = plain[p];
  }
  const auto moment = moments.moment.col(column);
  const double size = basis.grid().size(supports.cell[c]);
  const bool integrates = order_met(x, size, moment, weight) >= gradient_order(basis, has_triangles(basis));
  if (monomials(fit_weights(x, size, moment, weight)) < moment.size()) return integrates;
  for (Eigen::Index k = 0; k < n; ++k)
    points.volume[supports.point[at(supports.first[c]) + static_cast<std::size_t>(k)]] = weight[k];
  return true;
}

}  // namespace

WeightReport FittedVolumes::fit_cells(const Basis& basis, const PointSupports& supports, const BodyMoments& moments,
                                      MaterialPoints& points) const {
  const std::vector<Eigen::Index> column = columns_of(supports, moments);
  std::vector<char> met(supports.cell.size(), 1);
  points.volume = start_;
#pragma omp parallel for schedule(dynamic, 64) if (worth_threads(supports.point.size()))
  for (Index c = 0; c < supports.cells(); ++c)
    if (column[at(c)] >= 0) met[at(c)] = fit_cell(basis, supports, at(c), moments, column[at(c)], start_, points);

  WeightReport report;
  double served = 0.0;
  report.cells_unmet = static_cast<Index>(std::ranges::count(met, 0));
  for (std::size_t k = 0; k < moments.cell.size(); ++k)
    if (supports.active[at(moments.cell[k])] != 0) served += moments.moment(0, static_cast<Eigen::Index>(k));
  report.unserved = std::max(0.0, 1.0 - served / moments.moment.row(0).sum());
  return report;
}

WeightReport FittedVolumes::fit(const Basis& basis, const PointSupports& supports, const std::vector<Edge>& edges,
                                MaterialPoints& points) {
  const bool first = start_.size() == 0;
  if (first) start_ = points.volume;
  std::vector<SplineCurve> curves;
  for (const Edge& edge : edges) curves.push_back(edge.curve);
  const BodyMoments moments = body_moments(curves, basis.grid(), order_for(basis, has_triangles(basis)));
  WeightReport report = fit_cells(basis, supports, moments, points);
  points.volume *= moments.moment.row(0).sum() / points.volume.sum();
  if (report.cells_unmet > 0) {
    if (!consistent_) consistent_.emplace(first ? Consistency::linear : Consistency::divergence);
    points.volume = consistent_->fit(basis, points, supports, edges);
    report.unmet = consistent_->report().unmet;
    report.iterations = consistent_->report().iterations;
    report.factorisations = consistent_->report().factorisations;
  }
  const auto off = (points.volume - start_).cwiseAbs().array() > changed * start_.array();
  report.changed = static_cast<double>(off.count()) / points.size();
  report.bounded = static_cast<Index>((points.volume.array() <= at_bound * least_weight * start_.array()).count());
  return report;
}

}  // namespace shoreline
