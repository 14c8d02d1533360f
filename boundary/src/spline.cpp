#include "shoreline/boundary/spline.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "message.hpp"
#include "runs.hpp"
#include "shoreline/bases/counters.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/bases/quadrature.hpp"

namespace shoreline {
namespace {

[[noreturn]] void refuse(const Piece& piece, const std::string& problem) {
  throw InvalidArgument(quoted(piece.name) + ": " + problem);
}

void check_points(const Piece& piece) {
  const std::size_t count = piece.points.size();
  const std::size_t least = piece.closed ? 3 : 2;
  if (count < least)
    refuse(piece, "need at least " + std::to_string(least) + (piece.closed ? " points of a closed curve" : " points") +
                      ", got " + std::to_string(count));
  for (std::size_t k = 0; k < count; ++k)
    if (!piece.points[k].allFinite())
      refuse(piece, "point " + std::to_string(k) + " is not finite: " + text(piece.points[k]));

  Eigen::AlignedBox2d box;
  for (const Vec2& x : piece.points) box.extend(x);
  for (std::size_t k = piece.closed ? 0 : 1; k < count; ++k) {
    const std::size_t before = (k + count - 1) % count;
    if ((piece.points[k] - piece.points[before]).norm() <= 1e-14 * box.diagonal().norm())
      refuse(piece, "points " + std::to_string(before) + " and " + std::to_string(k) + " are the same, " +
                        text(piece.points[k]));
  }
}

void check_corners_and_tangents(const Piece& piece) {
  const int count = static_cast<int>(piece.points.size());
  for (const int corner : piece.corners) {
    const bool inner = piece.closed ? corner >= 0 && corner < count : corner > 0 && corner < count - 1;
    if (!inner)
      refuse(piece, "corner " + std::to_string(corner) + " is not the number of an inner point (the points are 0 to " +
                        std::to_string(count - 1) + ")");
  }
  for (const std::optional<Vec2>& tangent : {piece.start_tangent, piece.end_tangent}) {
    if (!tangent) continue;
    if (piece.closed) refuse(piece, "a closed curve has no end tangents");
    if (!tangent->allFinite() || tangent->isZero(0.0)) refuse(piece, "no direction in the tangent " + text(*tangent));
  }
}

/// q_{-1}, q_0, [q_1, …, q_m], q_{m+1}, q_{m+2}: the chords of a run of m >= 2, continued by two at either end.
std::vector<Vec2> continued_chords(std::span<const Vec2> chords, bool wraps) {
  const std::size_t m = chords.size();
  std::vector<Vec2> q(m + 4);
  std::ranges::copy(chords, q.begin() + 2);
  q[1] = wraps ? chords[m - 1] : Vec2(2.0 * q[2] - q[3]);
  q[0] = wraps ? chords[m - 2] : Vec2(2.0 * q[1] - q[2]);
  q[m + 2] = wraps ? chords[0] : Vec2(2.0 * q[m + 1] - q[m]);
  q[m + 3] = wraps ? chords[1] : Vec2(2.0 * q[m + 2] - q[m + 1]);
  return q;
}

/// V = (1 − a) q_k + a q_{k+1}, not yet of unit length, from q_{k−1}, …, q_{k+2}; (B.1), (B.2).
Vec2 tangent_direction(std::span<const Vec2, 4> q) {
  const double before = std::abs(cross(q[0], q[1]));
  const double after = std::abs(cross(q[2], q[3]));
  const bool straight = before + after <= 1e-12 * q[1].norm() * q[2].norm();
  const double a = straight ? 0.5 : before / (before + after);
  return (1.0 - a) * q[1] + a * q[2];
}

/// Unit tangents at the points of a run by (B.1), (B.2) with chords continued at its ends.
std::vector<Vec2> run_tangents(const Piece& piece, const Run& run, std::span<const Vec2> chords) {
  if (chords.size() == 1) return {chords[0].normalized(), chords[0].normalized()};
  const bool wraps = piece.closed && piece.corners.empty();
  const std::vector<Vec2> q = continued_chords(chords, wraps);
  std::vector<Vec2> tangents;
  for (std::size_t k = 0; k <= chords.size(); ++k) {
    Vec2 direction = tangent_direction(std::span(q).subspan(k).first<4>());
    const bool at_end = !wraps && (k == 0 || k == chords.size());
    const Vec2& chord = chords[std::min(k, chords.size() - 1)];
    if (at_end && direction.dot(chord) <= 1e-12 * chord.squaredNorm())
      direction = chord;  // the next chord is thrice as long or longer
    if (direction.norm() <= 1e-12 * chord.norm())
      refuse(piece, "the points turn back on themselves at " +
                        text(piece.points[(run.first + k) % piece.points.size()]) + "; declare a corner there");
    tangents.push_back(direction.normalized());
  }
  return tangents;
}

/// Replaces tangents at the ends of a run where more is known: chords at corners (a = 0 before, 1 after), given ones.
void set_end_tangents(const Piece& piece, const Run& run, std::span<const Vec2> chords, std::vector<Vec2>& tangents) {
  if (piece.closed && piece.corners.empty()) return;
  const bool starts = !piece.closed && run.first == 0;
  const bool ends = !piece.closed && run.first + run.chords + 1 == piece.points.size();
  if (!starts) tangents.front() = chords.front().normalized();
  if (!ends) tangents.back() = chords.back().normalized();
  if (starts && piece.start_tangent) tangents.front() = piece.start_tangent->normalized();
  if (ends && piece.end_tangent) tangents.back() = piece.end_tangent->normalized();
}

/// The span between two points with unit tangents that has the same speed s at both ends and in the middle, (B.3),
/// (B.4).
CubicSpan hermite_span(const Vec2& p0, const Vec2& t0, const Vec2& p3, const Vec2& t3) {
  const Vec2 chord = p3 - p0;
  const Vec2 sum = t0 + t3;
  const double a = 16.0 - sum.squaredNorm();
  const double b = 6.0 * chord.dot(sum);
  const double c = 36.0 * chord.squaredNorm();
  const double root = std::sqrt(b * b + a * c);
  const double s = b >= 0.0 ? c / (b + root) : (root - b) / a;  // the positive root of a s² + 2 b s − c
  return {{p0, p0 + s / 3.0 * t0, p3 - s / 3.0 * t3, p3}};
}

}  // namespace

Box CubicSpan::bounds() const {
  Box box{control[0], control[0]};
  for (const Vec2& p : control) {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
  return box;
}

double CubicSpan::length() const {
  static const QuadratureRule rule = gauss(16);
  const auto with_panels = [this](int panels) {
    double sum = 0.0;
    for (int k = 0; k < panels; ++k)
      for (Eigen::Index q = 0; q < rule.point.size(); ++q)
        sum += rule.weight[q] * derivative((k + rule.point[q]) / panels).norm();
    return sum / panels;
  };
  double length = with_panels(1);
  for (int panels = 2; panels <= 1024; panels *= 2) {
    const double before = length;
    length = with_panels(panels);
    if (std::abs(length - before) <= 1e-15 * length) break;
  }
  return length;
}

SplineCurve fit_spline(const Piece& piece) {
  count(Work::splines);
  check_points(piece);
  check_corners_and_tangents(piece);
  const std::size_t count = piece.points.size();
  SplineCurve curve{.spans = {}, .knots = {0.0}, .closed = piece.closed};
  curve.spans.resize(piece.closed ? count : count - 1);
  for (const Run& run : smooth_runs(piece)) {
    const auto point = [&](std::size_t k) -> const Vec2& { return piece.points[(run.first + k) % count]; };
    std::vector<Vec2> chords(run.chords);
    for (std::size_t k = 0; k < run.chords; ++k) chords[k] = point(k + 1) - point(k);
    std::vector<Vec2> tangents = run_tangents(piece, run, chords);
    set_end_tangents(piece, run, chords, tangents);
    for (std::size_t k = 0; k < run.chords; ++k)
      curve.spans[(run.first + k) % count] = hermite_span(point(k), tangents[k], point(k + 1), tangents[k + 1]);
  }
  for (const CubicSpan& span : curve.spans)
    curve.knots.push_back(curve.knots.back() + 3.0 * (span.control[1] - span.control[0]).norm());
  return curve;
}

}  // namespace shoreline
