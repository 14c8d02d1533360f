#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "shoreline/bases/error.hpp"
#include "shoreline/engine/fill.hpp"

namespace shoreline {
namespace {

constexpr double on_lattice = 1e-6;      ///< of the outer radius: how far off its radii and angles an outline may be
constexpr double area_tolerance = 1e-3;  ///< of the area: a spline through few points is no circle
constexpr double full_turn = 2.0 * std::numbers::pi;

/// a <= r <= b, first <= θ <= first + sweep.
struct Sector {
  double inner = std::numeric_limits<double>::infinity();
  double outer = 0.0;
  double first = 0.0;
  double sweep = 0.0;

  [[nodiscard]] bool full() const { return sweep > full_turn - 1e-9; }
  [[nodiscard]] double area() const { return 0.5 * (outer * outer - inner * inner) * sweep; }
};

double degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

Vec2 radial(double angle) { return {std::cos(angle), std::sin(angle)}; }

[[noreturn]] void refuse(const std::string& problem) {
  throw InvalidArgument("fill \"polar\" needs a sector of a ring: " + problem +
                        " (change the outline or the centre, or use fill \"lattice\")");
}

/// Calls use(from, to) for the two ends of every span, seen from the centre.
template <class Use>
void each_span(std::span<const SplineCurve> curves, const Vec2& centre, Use&& use) {
  for (const SplineCurve& curve : curves)
    for (const CubicSpan& span : curve.spans) use(Vec2(span.control[0] - centre), Vec2(span.control[3] - centre));
}

/// The sector whose radii are the smallest and largest of the tracking points, and whose angles are those between which
/// the outline follows the largest.
Sector find_sector(std::span<const SplineCurve> curves, const Vec2& centre) {
  Sector sector;
  each_span(curves, centre, [&](const Vec2& from, const Vec2& to) {
    sector.inner = std::min({sector.inner, from.norm(), to.norm()});
    sector.outer = std::max({sector.outer, from.norm(), to.norm()});
  });
  const double tolerance = on_lattice * sector.outer;
  if (sector.outer - sector.inner <= tolerance || sector.inner <= tolerance)
    refuse(
        fmt::format("about ({:.6g}, {:.6g}) the radii of the outline go from {:.6g} m to {:.6g} m; expected two "
                    "different positive ones",
                    centre.x(), centre.y(), sector.inner, sector.outer));
  each_span(curves, centre, [&](const Vec2& from, const Vec2& to) {
    if (to.norm() < sector.outer - tolerance) return;
    if (from.norm() < sector.outer - tolerance)
      sector.first = std::atan2(to.y(), to.x());
    else
      sector.sweep += std::atan2(cross(from, to), from.dot(to));
  });
  return sector;
}

void check_tracking_points(std::span<const SplineCurve> curves, const Vec2& centre, const Sector& sector) {
  const double tolerance = on_lattice * sector.outer;
  const auto on_side = [&](const Vec2& x, double angle) {
    return !sector.full() && std::abs(cross(radial(angle), x)) <= tolerance && radial(angle).dot(x) > 0.0;
  };
  each_span(curves, centre, [&](const Vec2& x, const Vec2&) {
    if (std::abs(x.norm() - sector.inner) <= tolerance || std::abs(x.norm() - sector.outer) <= tolerance) return;
    if (on_side(x, sector.first) || on_side(x, sector.first + sector.sweep)) return;
    refuse(
        fmt::format("the tracking point ({:.6g}, {:.6g}) lies neither on the radii {:.6g} m and {:.6g} m about "
                    "({:.6g}, {:.6g}) nor on the angles {:.6g}° and {:.6g}°",
                    x.x() + centre.x(), x.y() + centre.y(), sector.inner, sector.outer, centre.x(), centre.y(),
                    degrees(sector.first), degrees(sector.first + sector.sweep)));
  });
}

void check_area(std::span<const SplineCurve> curves, const Sector& sector) {
  const double area = Region({curves.begin(), curves.end()}).area();
  if (std::abs(area - sector.area()) <= area_tolerance * sector.area()) return;
  refuse(
      fmt::format("the outline bounds {:.6g} m², the sector with radii {:.6g} m and {:.6g} m over {:.6g}° has {:.6g} "
                  "m²",
                  area, sector.inner, sector.outer, degrees(sector.sweep), sector.area()));
}

/// Equally spaced coordinates along one direction of the lattice.
struct Coordinate {
  double first;
  double step;
  int count;
  bool wraps;  ///< has no ends

  [[nodiscard]] double at(int i) const { return first + i * step; }
  [[nodiscard]] bool begins(int i) const { return !wraps && i == 0; }
  [[nodiscard]] bool ends(int i) const { return !wraps && i == count - 1; }
};

/// Volume of node (i, j): ½ (r_+² − r_−²) Δθ.
double volume(const Coordinate& r, const Coordinate& angle, int i, int j, VolumeRule rule) {
  const bool halved = rule == VolumeRule::clipped;
  const double below = halved && r.begins(i) ? r.at(i) : r.at(i) - 0.5 * r.step;
  const double above = halved && r.ends(i) ? r.at(i) : r.at(i) + 0.5 * r.step;
  const double width = halved && (angle.begins(j) || angle.ends(j)) ? 0.5 * angle.step : angle.step;
  return 0.5 * (above - below) * (above + below) * width;
}

/// The way into the body from node (i, j) on an outer layer.
std::optional<Vec2> inward(const Coordinate& r, const Coordinate& angle, int i, int j) {
  const Vec2 out = radial(angle.at(j));
  const Vec2 left(-out.y(), out.x());
  const double along_radius = r.begins(i) ? 1.0 : r.ends(i) ? -1.0 : 0.0;
  const double along_angle = angle.begins(j) ? 1.0 : angle.ends(j) ? -1.0 : 0.0;
  const Vec2 direction = along_radius * out + along_angle * left;
  if (direction.isZero(0.0)) return std::nullopt;
  return direction.normalized();
}

}  // namespace

MaterialPoints fill_polar(std::span<const SplineCurve> curves, const PolarFill& fill) {
  const Sector sector = find_sector(curves, fill.centre);
  check_tracking_points(curves, fill.centre, sector);
  check_area(curves, sector);
  const int least = sector.full() ? 3 : 2;
  if (fill.across[0] < 2 || fill.across[1] < least)
    throw InvalidArgument(
        fmt::format("fill \"polar\" needs at least 2 points along the radius and {} along the angle, "
                    "got {} and {}",
                    least, fill.across[0], fill.across[1]));
  const Coordinate r{sector.inner, (sector.outer - sector.inner) / (fill.across[0] - 1), fill.across[0], false};
  const Coordinate angle{sector.full() ? 0.0 : sector.first,
                         sector.full() ? full_turn / fill.across[1] : sector.sweep / (fill.across[1] - 1),
                         fill.across[1], sector.full()};
  Eigen::Matrix2Xd position(2, Eigen::Index{r.count} * angle.count);
  Eigen::VectorXd volumes(position.cols());
  std::vector<OutlinePoint> on_outline;
  Index p = 0;
  for (int j = 0; j < angle.count; ++j)
    for (int i = 0; i < r.count; ++i, ++p) {
      position.col(p) = fill.centre + r.at(i) * radial(angle.at(j));
      volumes[p] = volume(r, angle, i, j, fill.volumes);
      if (const auto into = inward(r, angle, i, j)) on_outline.push_back({p, *into});
    }
  if (fill.volumes == VolumeRule::equal) volumes.setConstant(sector.area() / static_cast<double>(p));
  MaterialPoints points = points_at(std::move(position), std::move(volumes));
  points.on_outline = std::move(on_outline);
  return points;
}

}  // namespace shoreline
