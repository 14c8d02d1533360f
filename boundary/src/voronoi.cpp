#include "shoreline/boundary/voronoi.hpp"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <limits>
#include <numeric>
#include <string>

#include "cover.hpp"
#include "message.hpp"
#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

namespace polygon = boost::polygon;
using RasterPoint = polygon::point_data<int>;
using Diagram = polygon::voronoi_diagram<double>;

/// Whole numbers about the middle of a box, on which Boost.Polygon computes without error.
struct Raster {
  explicit Raster(const Box& box)
      : middle(0.5 * (box.lower + box.upper)), step(helpers * (box.upper - box.lower).maxCoeff() / last) {}

  [[nodiscard]] RasterPoint point(const Vec2& x) const {
    const Vec2 steps = (x - middle) / step;
    return {static_cast<int>(std::lround(steps.x())), static_cast<int>(std::lround(steps.y()))};
  }
  [[nodiscard]] Vec2 place(const RasterPoint& point) const { return middle + step * Vec2(point.x(), point.y()); }

  static constexpr int last = std::numeric_limits<int>::max();
  static constexpr double helpers = 2.25;  ///< how far off helping sites are, in extents: farther than any in the box
  Vec2 middle;                             ///< [m]
  double step;                             ///< [m]
};

/// Sites on the raster without repetition.
struct DistinctSites {
  DistinctSites(const Eigen::Matrix2Xd& sites, const Raster& raster) : number(static_cast<std::size_t>(sites.cols())) {
    std::vector<RasterPoint> all;
    all.reserve(number.size());
    for (const auto& x : sites.colwise()) all.push_back(raster.point(x));
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](std::size_t k) { return std::pair(all[k].x(), all[k].y()); });
    for (const std::size_t k : order) {
      if (point.empty() || point.back() != all[k]) {
        point.push_back(all[k]);
        sharers.push_back(0);
      }
      ++sharers.back();
      number[k] = point.size() - 1;
    }
  }

  std::vector<RasterPoint> point;
  std::vector<int> sharers;         ///< sites at each point
  std::vector<std::size_t> number;  ///< the point of each site
};

/// The sites and, behind them, four far ones around, beside which every cell is bounded.
std::vector<RasterPoint> with_helpers(std::vector<RasterPoint> sites) {
  for (const int far : {-Raster::last, Raster::last}) {
    sites.emplace_back(far, 0);
    sites.emplace_back(0, far);
  }
  return sites;
}

/// Corners of a cell about a site, counter-clockwise [m].
std::vector<Vec2> corners_of(const Diagram::cell_type& cell, const RasterPoint& site, double step) {
  std::vector<Vec2> corners;
  const auto* edge = cell.incident_edge();
  do {
    const Vec2 corner = step * Vec2(edge->vertex0()->x() - site.x(), edge->vertex0()->y() - site.y());
    if (corners.empty() || corner != corners.back()) corners.push_back(corner);
    edge = edge->next();
  } while (edge != cell.incident_edge());
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  return corners;
}

void require_within(const Box& box, const Eigen::Matrix2Xd& sites) {
  const Vec2 tolerance = Vec2::Constant(1e-9 * (box.upper - box.lower).maxCoeff());
  for (Eigen::Index p = 0; p < sites.cols(); ++p) {
    const Vec2 x = sites.col(p);
    const Vec2 nearest = x.cwiseMax(box.lower - tolerance).cwiseMin(box.upper + tolerance);
    if (x == nearest) continue;
    throw InvalidArgument("voronoi_areas: site " + std::to_string(p) + " at " + text(x) +
                          " lies outside the box of the outline, " + text(box.lower) + " to " + text(box.upper));
  }
}

}  // namespace

Eigen::VectorXd voronoi_areas(std::span<const SplineCurve> curves, const Eigen::Matrix2Xd& sites) {
  const Cover cover(curves);
  const Box box = cover.region().bounds();
  require_within(box, sites);
  const Raster raster(box);
  const DistinctSites distinct(sites, raster);
  const std::vector<RasterPoint> all = with_helpers(distinct.point);
  Diagram diagram;
  polygon::construct_voronoi(all.begin(), all.end(), &diagram);
  const double shortest = 1e-3 * raster.step;
  std::vector<double> share(distinct.point.size(), 0.0);
  for (const auto& cell : diagram.cells()) {
    const std::size_t k = cell.source_index();
    if (k >= share.size()) continue;
    const RasterPoint& site = distinct.point[k];
    share[k] =
        cover.moments(corners_of(cell, site, raster.step), raster.place(site), shortest)[0] / distinct.sharers[k];
  }
  Eigen::VectorXd areas(sites.cols());
  for (std::size_t p = 0; p < distinct.number.size(); ++p)
    areas[static_cast<Eigen::Index>(p)] = share[distinct.number[p]];
  return areas;
}

}  // namespace shoreline
