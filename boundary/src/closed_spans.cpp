#include "closed_spans.hpp"

#include <algorithm>

#include "shoreline/bases/quadrature.hpp"

namespace shoreline {
namespace {

CubicSpan straight_span(const Vec2& from, const Vec2& to) {
  return {{from, (2.0 * from + to) / 3.0, (from + 2.0 * to) / 3.0, to}};
}

}  // namespace

std::vector<CubicSpan> closed_spans(std::span<const SplineCurve> curves) {
  std::vector<CubicSpan> spans;
  std::vector<Vec2> starts;
  for (const SplineCurve& curve : curves) {
    spans.insert(spans.end(), curve.spans.begin(), curve.spans.end());
    if (!curve.closed && !curve.spans.empty()) starts.push_back(curve.spans.front().control[0]);
  }
  for (const SplineCurve& curve : curves) {
    if (curve.closed || curve.spans.empty()) continue;
    const Vec2& end = curve.spans.back().control[3];
    const Vec2 start = *std::ranges::min_element(starts, {}, [&](const Vec2& x) { return (x - end).squaredNorm(); });
    if (start != end) spans.push_back(straight_span(end, start));
  }
  return spans;
}

double signed_area(std::span<const CubicSpan> spans) {
  static const QuadratureRule rule = gauss(3);  // degree 5
  double twice = 0.0;
  for (const CubicSpan& span : spans)
    for (Eigen::Index q = 0; q < rule.point.size(); ++q) {
      const Vec2 arm = span.position(rule.point[q]) - spans.front().control[0];
      twice += rule.weight[q] * cross(arm, span.derivative(rule.point[q]));
    }
  return 0.5 * twice;
}

}  // namespace shoreline
