#include "contour_moments.hpp"

#include <algorithm>

#include "shoreline/bases/quadrature.hpp"

namespace shoreline {

Moments along_curve(const CubicSpan& curve, const Vec2& centre) {
  static const QuadratureRule rule = gauss(6);  // degree 11
  Moments sum = Moments::Zero();
  for (Eigen::Index q = 0; q < rule.point.size(); ++q) {
    const Vec2 x = curve.position(rule.point[q]) - centre;
    const double turned = rule.weight[q] * cross(x, curve.derivative(rule.point[q]));
    Moments part;
    part << 1.0 / 2.0, x.x() / 3.0, x.y() / 3.0, x.x() * x.x() / 4.0, x.x() * x.y() / 4.0, x.y() * x.y() / 4.0;
    sum += turned * part;
  }
  return sum;
}

Foot nearest_place(Corners corners, const Vec2& x) {
  Foot nearest{0, corners[0]};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 edge = corners[(k + 1) % corners.size()] - corners[k];
    const Vec2 place = corners[k] + std::clamp(edge.dot(x - corners[k]) / edge.squaredNorm(), 0.0, 1.0) * edge;
    if ((place - x).squaredNorm() < (nearest.place - x).squaredNorm()) nearest = {k, place};
  }
  return nearest;
}

Moments along_border(Corners corners, const Foot& foot, const Vec2& x) {
  Moments sum = along_line(corners[foot.side], foot.place) + along_line(foot.place, x);
  for (std::size_t k = 0; k < foot.side; ++k) sum += along_line(corners[k], corners[k + 1]);
  return sum;
}

Moments closed_run(const CubicSpan& run, Corners corners, const Vec2& centre) {
  const auto border = [&](const Vec2& end) -> Moments {
    const Vec2 x = end - centre;
    return along_border(corners, nearest_place(corners, x), x);
  };
  return along_curve(run, centre) + border(run.control[0]) - border(run.control[3]);
}

}  // namespace shoreline
