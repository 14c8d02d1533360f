#include "shoreline/boundary/short_forms.hpp"

#include <cmath>
#include <numbers>

#include "message.hpp"
#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

void check_count(const char* form, int points, int least) {
  if (points < least)
    throw InvalidArgument(std::string(form) + ": need at least " + std::to_string(least) + " points, got " +
                          std::to_string(points));
}

void check_circle(const char* form, const Vec2& centre, double radius) {
  if (!centre.allFinite() || !std::isfinite(radius) || radius <= 0.0)
    throw InvalidArgument(std::string(form) + ": need a finite centre and a positive radius, got " + text(centre) +
                          " and " + std::to_string(radius));
}

/// (cos, sin), exact at multiples of 90°.
Vec2 direction(double degrees) {
  const double turned = std::remainder(degrees, 360.0);
  const long quarters = std::lround(turned / 90.0);
  const double rest = (turned - 90.0 * static_cast<double>(quarters)) * std::numbers::pi / 180.0;
  const double c = std::cos(rest);
  const double s = std::sin(rest);
  switch (quarters & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

/// The unit vector a quarter turn to the left of a direction, or to its right.
Vec2 tangent_of(const Vec2& radial, bool counter_clockwise) {
  const double sign = counter_clockwise ? 1.0 : -1.0;
  return {-sign * radial.y(), sign * radial.x()};
}

}  // namespace

Piece line(const Vec2& from, const Vec2& to, int points) {
  check_count("line", points, 2);
  if (!from.allFinite() || !to.allFinite() || from == to)
    throw InvalidArgument("line: need two different finite ends, got " + text(from) + " and " + text(to));
  Piece piece;
  for (int k = 0; k < points - 1; ++k) piece.points.push_back(from + k * (to - from) / (points - 1));
  piece.points.push_back(to);
  return piece;
}

Piece arc(const Vec2& centre, double radius, double from_degrees, double to_degrees, int points) {
  check_count("arc", points, 2);
  check_circle("arc", centre, radius);
  const double turn = to_degrees - from_degrees;
  if (!(std::abs(turn) > 0.0 && std::abs(turn) < 360.0))
    throw InvalidArgument("arc: need an angle between 0 and 360 degrees, got one from " + std::to_string(from_degrees) +
                          " to " + std::to_string(to_degrees));
  Piece piece;
  for (int k = 0; k < points - 1; ++k)
    piece.points.push_back(centre + radius * direction(from_degrees + k * turn / (points - 1)));
  piece.points.push_back(centre + radius * direction(to_degrees));
  piece.start_tangent = tangent_of(direction(from_degrees), turn > 0.0);
  piece.end_tangent = tangent_of(direction(to_degrees), turn > 0.0);
  return piece;
}

Piece circle(const Vec2& centre, double radius, int points, bool hole) {
  check_count("circle", points, 3);
  check_circle("circle", centre, radius);
  Piece piece;
  piece.closed = true;
  for (int k = 0; k < points; ++k)
    piece.points.push_back(centre + radius * direction((hole ? -360.0 : 360.0) * k / points));
  return piece;
}

}  // namespace shoreline
