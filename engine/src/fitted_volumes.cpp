#include "fitted_volumes.hpp"

#include <algorithm>
#include <cmath>

#include "shoreline/boundary/body_moments.hpp"
#include "shoreline/boundary/fitted_weights.hpp"
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

/// Fits the weights of one cell and returns the order of the moments that they meet.
/// @param plain  (points) volumes at the start
int fit_cell(const Basis& basis, const PointSupports& supports, std::size_t c, const BodyMoments& moments,
             Eigen::Index column, const Eigen::VectorXd& plain, MaterialPoints& points) {
  const Eigen::Index n = supports.first[c + 1] - supports.first[c];
  Eigen::Matrix2Xd x(2, n);
  Eigen::VectorXd weight(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Index p = supports.point[at(supports.first[c]) + static_cast<std::size_t>(k)];
    x.col(k) = points.position.col(p) - moments.centre.col(column);
    weight[k] = plain[p];
  }
  const int order = fit_weights(x, basis.grid().size(supports.cell[c]), moments.moment.col(column), weight);
  for (Eigen::Index k = 0; k < n; ++k)
    points.volume[supports.point[at(supports.first[c]) + static_cast<std::size_t>(k)]] = weight[k];
  return order;
}

}  // namespace

WeightReport FittedVolumes::fit_cells(const Basis& basis, const PointSupports& supports, const BodyMoments& moments,
                                      int order, MaterialPoints& points) const {
  const std::vector<Eigen::Index> column = columns_of(supports, moments);
  std::vector<int> met(supports.cell.size(), order);
#pragma omp parallel for schedule(dynamic, 64) if (worth_threads(supports.point.size()))
  for (Index c = 0; c < supports.cells(); ++c)
    if (column[at(c)] >= 0) met[at(c)] = fit_cell(basis, supports, at(c), moments, column[at(c)], start_, points);

  WeightReport report;
  double served = 0.0;
  for (std::size_t c = 0; c < met.size(); ++c) {
    if (column[c] >= 0) served += moments.moment(0, column[c]);
    if (met[c] < order) ++report.cells_unmet;
  }
  report.unserved = std::max(0.0, 1.0 - served / moments.moment.row(0).sum());
  return report;
}

WeightReport FittedVolumes::fit(const Basis& basis, const PointSupports& supports, const std::vector<Edge>& edges,
                                MaterialPoints& points) {
  if (start_.size() == 0) start_ = points.volume;
  std::vector<SplineCurve> curves;
  for (const Edge& edge : edges) curves.push_back(edge.curve);
  const int order = std::min(2 * basis.degree(), highest_order(basis.grid()));
  const BodyMoments moments = body_moments(curves, basis.grid(), order);
  WeightReport report = fit_cells(basis, supports, moments, order, points);
  points.volume *= moments.moment.row(0).sum() / points.volume.sum();
  if (report.cells_unmet > 0) {
    points.volume = consistent_.fit(basis, points, supports, edges);
    report.unmet = consistent_.report().unmet;
    report.iterations = consistent_.report().iterations;
    report.factorisations = consistent_.report().factorisations;
  }
  const auto off = (points.volume - start_).cwiseAbs().array() > changed * start_.array();
  report.changed = static_cast<double>(off.count()) / points.size();
  report.bounded = static_cast<Index>((points.volume.array() <= at_bound * least_weight * start_.array()).count());
  return report;
}

}  // namespace shoreline
