#pragma once
// A spatial index of spans by their bounding boxes: the only place that knows Boost.Geometry.

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost 1.74 includes one of its own

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <span>
#include <utility>
#include <vector>

#include "shoreline/boundary/spline.hpp"

namespace shoreline {

class SpanTree {
 public:
  explicit SpanTree(std::span<const CubicSpan> spans) {
    std::vector<Entry> entries;
    entries.reserve(spans.size());
    for (std::size_t k = 0; k < spans.size(); ++k) entries.emplace_back(boost_box(spans[k].bounds()), k);
    tree_ = Tree(entries);
  }

  /// Calls visit(k) for every span whose bounding box meets @p box.
  template <class Visit>
  void for_each_in(const Box& box, Visit&& visit) const {
    tree_.query(boost::geometry::index::intersects(boost_box(box)),
                boost::make_function_output_iterator([&](const Entry& entry) { visit(entry.second); }));
  }

  /// The box of all spans.
  [[nodiscard]] Box bounds() const {
    const BoostBox box = tree_.bounds();
    return {{box.min_corner().get<0>(), box.min_corner().get<1>()},
            {box.max_corner().get<0>(), box.max_corner().get<1>()}};
  }

 private:
  using BoostPoint = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
  using BoostBox = boost::geometry::model::box<BoostPoint>;
  using Entry = std::pair<BoostBox, std::size_t>;
  using Tree = boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>>;

  static BoostBox boost_box(const Box& box) { return {{box.lower.x(), box.lower.y()}, {box.upper.x(), box.upper.y()}}; }

  Tree tree_;
};

}  // namespace shoreline
