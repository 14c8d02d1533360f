#include "shoreline/boundary/spline.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "../plate.hpp"
#include "random_pieces.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/bases/quadrature.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

double length_of(const SplineCurve& curve) {
  double sum = 0.0;
  for (const CubicSpan& span : curve.spans) sum += span.length();
  return sum;
}

/// ½ ∫ x × dx: the area between the curve and the origin.
double sector_area(const SplineCurve& curve) {
  const QuadratureRule rule = gauss(3);
  double twice = 0.0;
  for (const CubicSpan& span : curve.spans)
    for (Eigen::Index q = 0; q < 3; ++q)
      twice += rule.weight[q] * cross(span.position(rule.point[q]), span.derivative(rule.point[q]));
  return 0.5 * twice;
}

/// Largest | |x| − 1 | on a curve through points of the unit circle.
double radial_error(const SplineCurve& curve) {
  double error = 0.0;
  for (const CubicSpan& span : curve.spans)
    for (int k = 0; k <= 50; ++k) error = std::max(error, std::abs(span.position(k / 50.0).norm() - 1.0));
  return error;
}

double angle_between(const Vec2& a, const Vec2& b) { return std::atan2(std::abs(cross(a, b)), a.dot(b)); }

}  // namespace

TEST_CASE("a spline passes through its points and is C1 in its knots' parameter", "[boundary][spline]") {
  test::RandomPieces random(1);
  for (int draw = 0; draw < 200; ++draw) {
    Piece piece = random.star();
    piece.closed = draw % 2 == 0;
    const SplineCurve curve = fit_spline(piece);
    const std::size_t count = piece.points.size();
    REQUIRE(curve.spans.size() == (piece.closed ? count : count - 1));
    for (std::size_t k = 0; k < curve.spans.size(); ++k) {
      const CubicSpan& span = curve.spans[k];
      CHECK((span.position(0.0) - piece.points[k]).norm() <= 1e-14);
      CHECK((span.position(1.0) - piece.points[(k + 1) % count]).norm() <= 1e-14);
      const double width = curve.knots[k + 1] - curve.knots[k];
      for (const double u : {0.0, 0.5, 1.0})  // the speed in the knots' parameter is 1 at both ends and in the middle
        CHECK_THAT(span.derivative(u).norm() / width, WithinAbs(1.0, 1e-13));
      if (k + 1 == curve.spans.size() && !piece.closed) continue;
      const CubicSpan& next = curve.spans[(k + 1) % curve.spans.size()];
      CHECK(angle_between(span.derivative(1.0), next.derivative(0.0)) <= 1e-13);
    }
  }
}

TEST_CASE("the derivative of a span is that of its position", "[boundary][spline]") {
  const SplineCurve curve = fit_spline(test::plate_outer());
  constexpr double step = 1e-5;
  for (const CubicSpan& span : curve.spans)
    for (const double u : {0.1, 0.5, 0.8}) {
      const Vec2 difference = (span.position(u + step) - span.position(u - step)) / (2.0 * step);
      CHECK((difference - span.derivative(u)).norm() <= 1e-9);
    }
}

TEST_CASE("the outer boundary of the plate has its length and area", "[boundary][spline]") {
  const SplineCurve curve =
      fit_spline(test::plate_outer());  // values: an independent implementation of the same formulas
  CHECK_THAT(length_of(curve), WithinAbs(4.1412792974, 1e-9));
  CHECK_THAT(sector_area(curve), WithinAbs(2.7762288926, 1e-9));
}

TEST_CASE("the fit of a circle converges with order four", "[boundary][spline][convergence]") {
  const bool closed = GENERATE(true, false);
  const std::vector<double> bounds{6.2e-5, 3.9e-6, 2.45e-7, 1.55e-8};
  std::vector<double> error;
  for (const int points : {5, 9, 17, 33}) {  // on a quarter
    const Piece piece = closed ? circle({0, 0}, 1.0, 4 * (points - 1), false) : arc({0, 0}, 1.0, 0.0, 90.0, points);
    error.push_back(radial_error(fit_spline(piece)));
    CHECK(error.back() <= bounds[error.size() - 1]);
  }
  for (std::size_t k = 1; k < error.size(); ++k) CHECK_THAT(std::log2(error[k - 1] / error[k]), WithinAbs(4.0, 0.05));
}

TEST_CASE("a straight piece is straight, at unit speed, whatever its spacing", "[boundary][spline]") {
  const Vec2 direction(0.6, 0.8);
  Piece piece{.name = "line", .points = {}};
  for (const double s : {0.0, 0.1, 1.0, 1.3, 5.0}) piece.points.push_back(s * direction);
  const SplineCurve curve = fit_spline(piece);
  CHECK_THAT(length_of(curve), WithinAbs(5.0, 1e-14));
  for (const CubicSpan& span : curve.spans)
    for (const double u : {0.0, 0.3, 0.9}) {
      CHECK(std::abs(cross(direction, span.position(u))) <= 1e-15);
      CHECK(direction.dot(span.derivative(u)) > 0.0);
    }
}

TEST_CASE("where the second chord is thrice the first, so that (B.1) has no direction, the end takes its chord's",
          "[boundary][spline]") {
  const Vec2 along(0.0923, 0.0387);
  for (const double next : {3.0 - 1e-15, 3.0, 3.0 + 1e-15, 5.0}) {
    const SplineCurve curve = fit_spline(
        {.name = "shore", .points = {{0.1, 0.2}, Vec2(0.1, 0.2) + along, Vec2(0.1, 0.2) + (1.0 + next) * along}});
    CHECK_THAT(curve.spans.front().derivative(0.0).normalized().dot(along.normalized()), WithinAbs(1.0, 1e-12));
  }
}

TEST_CASE("at a corner the tangents are those of the chords, and beside it the curve does not look across",
          "[boundary]") {
  Piece piece{.name = "bent", .points = {{0, 0}, {1, 0.1}, {2, 0.3}, {2.5, 1}, {2.4, 2}, {2, 3}}, .corners = {2}};
  const SplineCurve curve = fit_spline(piece);
  CHECK(angle_between(curve.spans[1].derivative(1.0), piece.points[2] - piece.points[1]) <= 1e-14);
  CHECK(angle_between(curve.spans[2].derivative(0.0), piece.points[3] - piece.points[2]) <= 1e-14);

  piece.points.back() += Vec2(0.5, 0.5);  // beyond the corner
  const SplineCurve moved = fit_spline(piece);
  for (const std::size_t span : {0U, 1U})
    for (std::size_t k = 0; k < 4; ++k) CHECK(moved.spans[span].control[k] == curve.spans[span].control[k]);
}

TEST_CASE("a closed piece with corners everywhere is the polygon, and with one corner a loop from it to it",
          "[boundary]") {
  Piece square{.name = "square", .points = {{0, 0}, {2, 0}, {2, 1}, {0, 1}}, .corners = {0, 1, 2, 3}, .closed = true};
  CHECK_THAT(length_of(fit_spline(square)), WithinAbs(6.0, 1e-14));
  CHECK_THAT(sector_area(fit_spline(square)), WithinAbs(2.0, 1e-14));

  square.corners = {1};
  const SplineCurve drop = fit_spline(square);
  CHECK(angle_between(drop.spans[0].derivative(1.0), Vec2(1, 0)) <= 1e-14);
  CHECK(angle_between(drop.spans[1].derivative(0.0), Vec2(0, 1)) <= 1e-14);
  for (const std::size_t k : {1U, 2U, 3U})
    CHECK(angle_between(drop.spans[k].derivative(1.0), drop.spans[(k + 1) % 4].derivative(0.0)) <= 1e-14);
}

TEST_CASE("end tangents that are given are kept", "[boundary][spline]") {
  Piece piece = test::plate_outer();
  piece.start_tangent = Vec2(0, 1);
  piece.end_tangent = Vec2(-1, -1);
  const SplineCurve curve = fit_spline(piece);
  CHECK(angle_between(curve.spans.front().derivative(0.0), Vec2(0, 1)) <= 1e-14);
  CHECK(angle_between(curve.spans.back().derivative(1.0), Vec2(-1, -1)) <= 1e-14);
}

TEST_CASE("a length is that of the curve", "[boundary][spline]") {
  const double reach = GENERATE(1.0, 20.0);  // y = x² from −reach to reach: nearly a hairpin if it is large
  const double top = reach * reach;
  const CubicSpan parabola{
      {Vec2(-reach, top), Vec2(-reach / 3, -top / 3), Vec2(reach / 3, -top / 3), Vec2(reach, top)}};
  const double length = reach * std::sqrt(1.0 + 4.0 * top) + 0.5 * std::asinh(2.0 * reach);
  CHECK_THAT(parabola.length() / length, WithinAbs(1.0, 1e-14));
}

TEST_CASE("a fit refuses points that make no curve, naming piece and place", "[boundary][spline]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto message = [](const Piece& piece) {
    try {
      (void)fit_spline(piece);
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK_THAT(message({.name = "dot", .points = {{0, 0}}}),
             Contains("'dot'") && Contains("at least 2") && Contains("1"));
  CHECK_THAT(message({.name = "two", .points = {{0, 0}, {1, 0}}, .closed = true}), Contains("at least 3"));
  CHECK_THAT(message({.name = "nan", .points = {{0, 0}, {1, nan}}}), Contains("'nan'") && Contains("(1, nan)"));
  CHECK_THAT(message({.name = "twice", .points = {{0, 0}, {1, 0.25}, {1, 0.25}, {2, 0}}}),
             Contains("'twice'") && Contains("points 1 and 2") && Contains("(1, 0.25)"));
  CHECK_THAT(message({.name = "closes", .points = {{0, 0}, {1, 0}, {1, 1}, {0, 0}}, .closed = true}),
             Contains("points 3 and 0"));
  CHECK_THAT(message({.name = "end", .points = {{0, 0}, {1, 0}, {2, 1}}, .corners = {2}}), Contains("corner 2"));
  CHECK_THAT(message({.name = "back", .points = {{0, 0}, {1, 0}, {0, 0}, {1, 0}}}),
             Contains("turn back") && Contains("(1, 0)"));
  CHECK_THAT(message({.name = "zero", .points = {{0, 0}, {1, 0}}, .start_tangent = Vec2(0, 0)}), Contains("tangent"));
  Piece loop = circle({0, 0}, 1.0, 8, false);
  loop.end_tangent = Vec2(1, 0);
  CHECK_THAT(message(loop), Contains("closed curve"));
}
