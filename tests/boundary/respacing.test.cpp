#include "shoreline/boundary/respacing.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "random_pieces.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

namespace {

Vec2 position(const SplineCurve& curve, const CurvePlace& place) {
  return curve.spans[static_cast<std::size_t>(place.span)].position(place.u);
}

/// n chords on an ellipse, or on its upper half, whose lengths differ by a factor of about four.
Piece graded_ellipse(int n, bool closed) {
  Piece piece{.name = "ellipse", .points = {}, .closed = closed};
  for (int k = 0; k < n + (closed ? 0 : 1); ++k) {
    const double s = static_cast<double>(k) / n;
    const double angle = (closed ? 2.0 : 1.0) * std::numbers::pi *
                         (s - 0.6 * std::sin(2.0 * std::numbers::pi * s) / (2.0 * std::numbers::pi));
    piece.points.emplace_back(1.5 * std::cos(angle), std::sin(angle));
  }
  return piece;
}

/// The largest |f(span, u)| over places of a curve.
template <class F>
double largest(const SplineCurve& curve, F&& f) {
  double most = 0.0;
  for (int span = 0; span < static_cast<int>(curve.spans.size()); ++span)
    for (int k = 0; k < 10; ++k) most = std::max(most, f(CurvePlace{span, (k + 0.5) / 10.0}));
  return most;
}

}  // namespace

TEST_CASE("runs within the limit are left alone bit for bit", "[boundary][respacing]") {
  CHECK_FALSE(respace(line({0.0, 0.0}, {1.0, 0.3}, 7), 1.001));
  CHECK_FALSE(respace(circle({0.0, 0.0}, 1.0, 12, false), 1.001));
  CHECK_FALSE(respace(graded_ellipse(32, true), 10.0));

  Piece bent{.name = "bent", .points = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 0.1}, {2.0, 1.0}}, .corners = {2}};
  const auto respaced = respace(bent, 2.0);
  REQUIRE(respaced);
  CHECK(std::equal(bent.points.begin(), bent.points.begin() + 3, respaced->piece.points.begin()));
  CHECK(respaced->piece.points[4] == bent.points[4]);
  CHECK((respaced->piece.points[3] - Vec2(2.0, 0.5)).norm() < 1e-12);
  CHECK(respaced->piece.corners == bent.corners);
}

TEST_CASE("re-spaced points lie on the curve at equal arc lengths, ends and corners stay", "[boundary][respacing]") {
  test::RandomPieces random(3);
  int changed = 0;
  for (int draw = 0; draw < 100; ++draw) {
    const Piece piece = random.any();
    const auto respaced = respace(piece, 1.2);
    if (!respaced) continue;
    ++changed;
    const PlaceMap& places = respaced->places;
    const std::size_t count = piece.points.size();
    const auto fixed = [&](std::size_t k) {
      const bool end = piece.closed ? piece.corners.empty() && k == 0 : k == 0 || k + 1 == count;
      return end || std::ranges::count(piece.corners, static_cast<int>(k)) > 0;
    };
    const auto arc = [&](std::size_t k) {  // before, of new point k
      return k < places.start.size() ? places.start[k] : places.before.length();
    };
    for (std::size_t k = 0; k < count; ++k) {
      CHECK((position(places.before.curve(), places.before.at(arc(k))) - respaced->piece.points[k]).norm() < 1e-12);
      if (fixed(k)) CHECK(respaced->piece.points[k] == piece.points[k]);
      if (fixed(k) || respaced->piece.points[k] == piece.points[k]) continue;
      const double total = places.before.length();
      const auto gap = [&](std::size_t a, std::size_t b) { return std::fmod(arc(b) - arc(a) + total, total); };
      const std::size_t next = piece.closed ? (k + 1) % count : k + 1;
      const double after = next < places.start.size() || piece.closed ? gap(k, next) : total - arc(k);
      CHECK_THAT(gap((k + count - 1) % count, k) - after, WithinAbs(0.0, 1e-12 * total));
    }
  }
  CHECK(changed > 30);
}

TEST_CASE("places map monotonically, and at tracking points exactly", "[boundary][respacing]") {
  for (const bool closed : {true, false}) {
    const auto respaced = respace(graded_ellipse(20, closed), 2.0);
    REQUIRE(respaced);
    const PlaceMap& places = respaced->places;
    double before = -1.0;
    for (int span = 0; span < 20; ++span)
      for (const double u : {0.0, 0.3, 0.7}) {
        const CurvePlace old = places({span, u});
        CHECK(old.span + old.u > before);
        before = old.span + old.u;
        if (u == 0.0)
          CHECK((position(places.before.curve(), old) - respaced->piece.points[static_cast<std::size_t>(span)]).norm() <
                1e-13);
      }
  }
}

TEST_CASE("re-spacing changes the curve by no more than it misses what it interpolates",
          "[boundary][respacing][convergence]") {
  const auto off_ellipse = [](const Vec2& x) { return std::abs(std::hypot(x.x() / 1.5, x.y()) - 1.0); };
  for (const bool closed : {true, false}) {
    std::vector<double> change;
    std::vector<double> missed;
    for (const int n : {32, 64, 128, 256}) {
      const auto respaced = respace(graded_ellipse(n, closed), 2.0);
      REQUIRE(respaced);
      const PlaceMap& places = respaced->places;
      const SplineCurve& now = places.now.curve();
      const SplineCurve& before = places.before.curve();
      change.push_back(largest(now, [&](const CurvePlace& place) {
        return (position(now, place) - position(before, places(place))).norm();
      }));
      missed.push_back(largest(before, [&](const CurvePlace& place) { return off_ellipse(position(before, place)); }));
      CHECK(change.back() < 3.0 * missed.back());
    }
    CAPTURE(closed, change, missed);
    CHECK(std::log2(change[2] / change[3]) > 2.8);  // 3 on graded points, as for the curve itself; 4 on equal ones
    CHECK(change.back() < 4e-6);
  }
}

TEST_CASE("re-spacing keeps the original position of the material with order two",
          "[boundary][respacing][convergence]") {
  const auto deform = [](const Vec2& X) -> Vec2 {
    return {X.x() + 0.3 * std::sin(X.y()), 1.2 * X.y() + 0.2 * X.x() * X.x()};
  };
  for (const bool closed : {true, false}) {
    std::vector<double> error;
    for (const int n : {32, 64, 128}) {
      Piece piece = graded_ellipse(n, closed);
      const SplineCurve original = fit_spline(piece);
      for (Vec2& x : piece.points) x = deform(x);
      const auto respaced = respace(piece, 2.0);
      REQUIRE(respaced);
      const SplineCurve carried = respaced_original(original, *respaced);
      CHECK(carried.spans.size() == original.spans.size());
      error.push_back(largest(carried, [&](const CurvePlace& place) {
        return (deform(position(carried, place)) - position(respaced->places.now.curve(), place)).norm();
      }));
    }
    CAPTURE(closed, error);
    CHECK(std::log2(error[1] / error[2]) > 1.8);
    CHECK(error.back() < 1e-3);
  }
}
