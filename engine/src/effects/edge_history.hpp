#pragma once
// A field along a boundary piece, kept from one load step to the next.

#include <algorithm>

#include "shoreline/boundary/respacing.hpp"
#include "shoreline/boundary/trace.hpp"

namespace shoreline {

/// Polynomial on each segment of the step before, (D.7). The place (span, u) moves with the material.
struct EdgeHistory {
  using Value = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;

  std::vector<Segment> segments{};
  Eigen::VectorXd node{};            ///< Gauss points of a segment, in [0, 1]
  Eigen::MatrixXd value{};           ///< (components, points): at the nodes of every segment, in order
  std::optional<PlaceMap> places{};  ///< where a place of the curve is on the segments, if it was re-spaced since

  [[nodiscard]] bool empty() const { return segments.empty(); }

  [[nodiscard]] Value at(int span, double u) const {
    const CurvePlace place = places ? (*places)({span, u}) : CurvePlace{span, u};
    return at_place(place.span, place.u);
  }

 private:
  [[nodiscard]] Value at_place(int span, double u) const {
    const auto ends_before = [&](const Segment& segment) {
      return segment.span < span || (segment.span == span && segment.end < u);
    };
    const auto found = std::ranges::partition_point(segments, ends_before);
    const auto s = static_cast<std::size_t>(std::min(found, segments.end() - 1) - segments.begin());
    const double place = (u - segments[s].begin) / (segments[s].end - segments[s].begin);
    Value sum = Value::Zero(value.rows());
    for (Eigen::Index i = 0; i < node.size(); ++i) {  // Lagrange polynomials
      double weight = 1.0;
      for (Eigen::Index j = 0; j < node.size(); ++j)
        if (j != i) weight *= (place - node[j]) / (node[i] - node[j]);
      sum += weight * value.col(static_cast<Eigen::Index>(s) * node.size() + i);
    }
    return sum;
  }
};

}  // namespace shoreline
