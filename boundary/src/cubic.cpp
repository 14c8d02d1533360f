#include "cubic.hpp"

#include <algorithm>
#include <cmath>

namespace shoreline {
namespace {

template <class T>
T between(const T& a, const T& b, double u) {
  return (1.0 - u) * a + u * b;
}

/// The symmetric trilinear form whose diagonal is the cubic (de Casteljau with one parameter a level).
template <class T>
T blossom(const std::array<T, 4>& p, double u, double v, double w) {
  const T a = between(p[0], p[1], u);
  const T b = between(p[1], p[2], u);
  const T c = between(p[2], p[3], u);
  return between<T>(between(a, b, v), between(b, c, v), w);
}

/// The derivative of a cubic, by de Casteljau on its differences.
template <class T>
T derivative_of(const std::array<T, 4>& p, double u) {
  const T a = p[1] - p[0];
  const T b = p[2] - p[1];
  const T c = p[3] - p[2];
  return 3.0 * between<T>(between(a, b, u), between(b, c, u), u);
}

}  // namespace

double Cubic::value(double u) const { return blossom(b, u, u, u); }

double Cubic::slope(double u) const { return derivative_of(b, u); }

Vec2 CubicSpan::position(double u) const { return blossom(control, u, u, u); }

Vec2 CubicSpan::derivative(double u) const { return derivative_of(control, u); }

Cubic coordinate(const CubicSpan& span, const Vec2& direction) {
  Cubic f{};
  std::ranges::transform(span.control, f.b.begin(), [&](const Vec2& p) { return direction.dot(p); });
  return f;
}

MonotoneParts monotone_parts(const Cubic& f, double begin, double end) {
  // f'/3 = A u² + 2 B u + C
  const double c = f.b[1] - f.b[0];
  const double b = f.b[2] - f.b[1] - c;
  const double a = f.b[3] - f.b[2] - (f.b[2] - f.b[1]) - b;
  const double discriminant = b * b - a * c;

  MonotoneParts parts{.count = 1, .u = {begin}, .value = {f.value(begin)}};
  const auto cut = [&](double u) {
    if (!(u > begin && u < end)) return;
    const auto at = static_cast<std::size_t>(parts.count++);
    parts.u[at] = u;
    parts.value[at] = f.value(u);
  };
  if (discriminant > 0.0) {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    cut(std::min(q / a, c / q));
    cut(std::max(q / a, c / q));
  }
  const auto last = static_cast<std::size_t>(parts.count);
  parts.u[last] = end;
  parts.value[last] = f.value(end);
  return parts;
}

double crossing(const Cubic& f, double begin, double end, double level) {
  constexpr double resolution = 1e-16;
  const bool rising = f.value(end) > f.value(begin);
  double previous = end - begin;
  double u = 0.5 * (begin + end);
  while (end - begin > resolution) {
    const double residual = f.value(u) - level;
    if (residual == 0.0) return u;
    ((residual > 0.0) == rising ? end : begin) = u;
    double next = u - residual / f.slope(u);
    const bool slow = !(std::abs(next - u) < 0.5 * previous);
    if (slow || next < begin || next > end) next = 0.5 * (begin + end);
    previous = std::abs(next - u);
    if (previous <= resolution) return next;
    u = next;
  }
  return u;
}

CubicSpan part(const CubicSpan& span, double begin, double end) {
  const std::array<Vec2, 4>& p = span.control;
  return {{blossom(p, begin, begin, begin), blossom(p, begin, begin, end), blossom(p, begin, end, end),
           blossom(p, end, end, end)}};
}

std::vector<CubicSpan> monotone_spans(const CubicSpan& span, int axis) {
  const MonotoneParts parts = monotone_parts(coordinate(span, Vec2::Unit(axis)));
  std::vector<CubicSpan> spans;
  for (std::size_t k = 0; k < static_cast<std::size_t>(parts.count); ++k)
    spans.push_back(part(span, parts.u[k], parts.u[k + 1]));
  return spans;
}

}  // namespace shoreline
