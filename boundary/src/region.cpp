#include "shoreline/boundary/region.hpp"

#include <algorithm>
#include <cmath>

#include "closed_spans.hpp"
#include "cubic.hpp"
#include "span_tree.hpp"

namespace shoreline {
namespace {

std::vector<CubicSpan> rising_or_falling(std::span<const CubicSpan> spans) {
  std::vector<CubicSpan> parts;
  for (const CubicSpan& span : spans)
    for (const CubicSpan& monotone : monotone_spans(span, 1)) parts.push_back(monotone);
  return parts;
}

/// Winding that a y-monotone span adds for the ray from x to the right: 1 if the span rises across it, −1 if it falls.
int winding_of(const CubicSpan& span, const Vec2& x) {
  const double begin = span.control[0].y();
  const double end = span.control[3].y();
  if (!passes(begin, end, x.y())) return 0;
  const int sign = end > begin ? 1 : -1;
  const Box box = span.bounds();
  if (x.x() < box.lower.x()) return sign;
  if (x.x() > box.upper.x()) return 0;
  const double u = crossing(coordinate(span, Vec2::UnitY()), 0.0, 1.0, x.y());
  return span.position(u).x() > x.x() ? sign : 0;
}

/// Whether a point of the span lies within @p distance of x, by halving where control points leave it open.
bool within(const CubicSpan& span, const Vec2& x, double distance) {
  const Box box = span.bounds();
  const Vec2 outside = (box.lower - x).cwiseMax(x - box.upper).cwiseMax(0.0);
  if (outside.norm() > distance) return false;
  if ((span.control[0] - x).norm() <= distance || (span.control[3] - x).norm() <= distance) return true;
  const double extent = (box.upper - box.lower).norm();
  if (extent <= 1e-9 * distance || extent <= 1e-14 * x.norm()) return true;
  return within(part(span, 0.0, 0.5), x, distance) || within(part(span, 0.5, 1.0), x, distance);
}

}  // namespace

struct Region::Spans {
  explicit Spans(std::span<const SplineCurve> curves)
      : closed(closed_spans(curves)), monotone(rising_or_falling(closed)), tree(monotone) {}

  std::vector<CubicSpan> closed;
  std::vector<CubicSpan> monotone;  ///< in y
  SpanTree tree;                    ///< of the monotone ones
};

Region::Region(std::span<const SplineCurve> curves) : spans_(std::make_unique<const Spans>(curves)) {}
Region::~Region() = default;
Region::Region(Region&&) noexcept = default;
Region& Region::operator=(Region&&) noexcept = default;

bool Region::contains(const Vec2& x) const {
  int winding = 0;
  const Box ray{x, Vec2(std::max(x.x(), spans_->tree.bounds().upper.x()), x.y())};
  spans_->tree.for_each_in(ray, [&](std::size_t k) { winding += winding_of(spans_->monotone[k], x); });
  return winding != 0;
}

double Region::area() const { return signed_area(spans_->closed); }

Box Region::bounds() const {
  Box box{Vec2::Constant(INFINITY), Vec2::Constant(-INFINITY)};
  for (const CubicSpan& span : spans_->closed)
    for (const int axis : {0, 1}) {
      const MonotoneParts parts = monotone_parts(coordinate(span, Vec2::Unit(axis)));
      for (std::size_t k = 0; k <= static_cast<std::size_t>(parts.count); ++k) {
        box.lower[axis] = std::min(box.lower[axis], parts.value[k]);
        box.upper[axis] = std::max(box.upper[axis], parts.value[k]);
      }
    }
  return box;
}

bool Region::near_outline(const Vec2& x, double distance) const {
  bool near = false;
  const Vec2 reach = Vec2::Constant(distance);
  spans_->tree.for_each_in({x - reach, x + reach},
                           [&](std::size_t k) { near = near || within(spans_->monotone[k], x, distance); });
  return near;
}

}  // namespace shoreline
