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

/// Up to which order moments are asked for: on triangles that of products of gradients, on rectangles of all but their
/// highest mixed monomials. Gradients alone take one order less.
int order_for(const Basis& basis) {
  const bool triangles = highest_order(basis.grid()) < max_moment_order;
  return triangles ? basis.degree() : 2 * basis.degree();
}

/// The weights of one cell's points as their moments ask for, and the order of those that they meet.
struct CellFit {
  Eigen::VectorXd weight;
  int order = 0;
};

CellFit fit_cell(const Basis& basis, const PointSupports& supports, std::size_t c, const BodyMoments& moments,
                 Eigen::Index column, const MaterialPoints& points, const Eigen::VectorXd& plain) {
  const Eigen::Index n = supports.first[c + 1] - supports.first[c];
  const Index* const point = &supports.point[at(supports.first[c])];
  Eigen::Matrix2Xd x(2, n);
  CellFit fit{.weight = Eigen::VectorXd(n)};
  for (Eigen::Index k = 0; k < n; ++k) {
    x.col(k) = points.position.col(point[k]) - moments.centre.col(column);
    fit.weight[k] = plain[point[k]];
  }
  fit.order = fit_weights(x, basis.grid().size(supports.cell[c]), moments.moment.col(column), fit.weight);
  return fit;
}

/// Share of the body in elements without points.
double unserved(const PointSupports& supports, const BodyMoments& moments) {
  double served = 0.0;
  for (std::size_t k = 0; k < moments.cell.size(); ++k)
    if (supports.active[at(moments.cell[k])] != 0) served += moments.moment(0, static_cast<Eigen::Index>(k));
  return std::max(0.0, 1.0 - served / moments.moment.row(0).sum());
}

}  // namespace

Index FittedVolumes::fit_cells(const Basis& basis, const PointSupports& supports, const BodyMoments& moments,
                               MaterialPoints& points) const {
  const int highest = order_for(basis);
  const std::vector<Eigen::Index> column = columns_of(supports, moments);
  std::vector<CellFit> fits(supports.cell.size(), {.weight = {}, .order = highest});
#pragma omp parallel for schedule(dynamic, 64) if (worth_threads(supports.point.size()))
  for (Index c = 0; c < supports.cells(); ++c)
    if (column[at(c)] >= 0) fits[at(c)] = fit_cell(basis, supports, at(c), moments, column[at(c)], points, start_);

  const auto short_of = [](int order) { return [order](const CellFit& fit) { return fit.order < order; }; };
  const auto unmet = static_cast<Index>(std::ranges::count_if(fits, short_of(highest - 1)));
  points.volume = start_;
  for (std::size_t c = 0; c < fits.size(); ++c)
    if (unmet == 0 || fits[c].order == highest)
      for (Eigen::Index k = 0; k < fits[c].weight.size(); ++k)
        points.volume[supports.point[at(supports.first[c]) + static_cast<std::size_t>(k)]] = fits[c].weight[k];
  return unmet;
}

WeightReport FittedVolumes::fit(const Basis& basis, const PointSupports& supports, const std::vector<Edge>& edges,
                                MaterialPoints& points) {
  const bool first = start_.size() == 0;
  if (first) start_ = points.volume;
  std::vector<SplineCurve> curves;
  for (const Edge& edge : edges) curves.push_back(edge.curve);
  const BodyMoments moments = body_moments(curves, basis.grid(), order_for(basis));
  WeightReport report{.cells_unmet = fit_cells(basis, supports, moments, points),
                      .unserved = unserved(supports, moments)};
  const double area = moments.moment.row(0).sum();
  points.volume *= area / points.volume.sum();
  if (report.cells_unmet > 0) {
    if (!consistent_) consistent_.emplace(first ? Consistency::linear : Consistency::divergence);
    points.volume = consistent_->fit(basis, points, supports, edges);
    points.volume *= area / points.volume.sum();  // they have it but for the tolerance, if they meet all constraints
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
