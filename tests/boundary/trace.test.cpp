#include "shoreline/boundary/trace.hpp"

#include <catch2/catch.hpp>

#include "random_pieces.hpp"
#include "traced.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using test::cells_of;
using test::fault;
using test::outside;
using test::straight;

namespace {

const QuadrilateralGrid unit_cells({0, 0}, {1, 1}, {4, 4});

}  // namespace

TEST_CASE("segments tile random closed curves, each within its cell", "[boundary][trace]") {
  test::RandomPieces random(2);
  for (int draw = 0; draw < 10000; ++draw) {
    const SplineCurve curve = fit_spline(draw % 2 == 0 ? random.star() : random.wild());
    const QuadrilateralGrid grid = random.grid_around(curve);
    const std::vector<Segment> segments = trace(curve, grid, "loop");
    const std::string found = fault(curve, grid, segments);
    if (!found.empty()) FAIL("draw " << draw << ": " << found);
  }
}

TEST_CASE("normals of a closed curve integrate to zero, and their moment to twice the area", "[boundary][trace]") {
  test::RandomPieces random(3);
  const QuadratureRule rule = gauss(3);
  for (int draw = 0; draw < 500; ++draw) {
    const SplineCurve curve = fit_spline(random.star());
    const QuadrilateralGrid grid = random.grid_around(curve);
    Vec2 normals = Vec2::Zero();
    double moment = 0.0;
    for (const BoundaryPoint& p : boundary_points(curve, trace(curve, grid, "loop"), rule)) {
      normals += p.weight * p.normal;
      moment -= p.weight * p.x.dot(p.normal);
    }
    double twice_area = 0.0;  // ∮ x × dx
    for (const CubicSpan& span : curve.spans)
      for (Eigen::Index q = 0; q < 3; ++q)
        twice_area += rule.weight[q] * cross(span.position(rule.point[q]), span.derivative(rule.point[q]));
    CHECK_THAT(normals.norm(), WithinAbs(0.0, 1e-13));
    CHECK_THAT(moment, WithinAbs(twice_area, 1e-13));
  }
}

TEST_CASE("boundary points know their place, and their weights sum to the length", "[boundary][trace]") {
  const SplineCurve curve = fit_spline(circle({2, 2}, 1.7, 16, false));
  const std::vector<BoundaryPoint> points = boundary_points(curve, trace(curve, unit_cells, "circle"), gauss(8));
  double length = 0.0;
  for (const BoundaryPoint& p : points) {
    CHECK(curve.spans[static_cast<std::size_t>(p.span)].position(p.u) == p.x);
    CHECK(outside(unit_cells, p.cell, p.x) <= 0.0);
    CHECK((p.normal - (Vec2(2, 2) - p.x).normalized()).norm() <= 1e-3);
    length += p.weight;
  }
  double expected = 0.0;
  for (const CubicSpan& span : curve.spans) expected += span.length();
  CHECK_THAT(length, WithinAbs(expected, 1e-12));
}

TEST_CASE("a curve along a grid line belongs to the cells on its left", "[boundary][trace]") {
  CHECK(cells_of(trace(straight({2, 0.5}, {2, 2.5}), unit_cells, "up")) == std::vector<Index>{1, 5, 9});
  CHECK(cells_of(trace(straight({2, 2.5}, {2, 0.5}), unit_cells, "down")) == std::vector<Index>{10, 6, 2});
  CHECK(cells_of(trace(straight({0.5, 1}, {1.5, 1}), unit_cells, "right")) == std::vector<Index>{4, 5});
  CHECK(cells_of(trace(straight({1.5, 1}, {0.5, 1}), unit_cells, "left")) == std::vector<Index>{1, 0});
  const double rounding = GENERATE(-4e-16, 4e-16);
  CHECK(cells_of(trace(straight({2 + rounding, 0.5}, {2 - rounding, 1.5}), unit_cells, "up")) ==
        std::vector<Index>{1, 5});
}

TEST_CASE("a curve along the border of the grid is inside it, also a rounding error beyond", "[boundary][trace]") {
  const double rounding = GENERATE(0.0, 4e-16, -4e-16);
  const Vec2 low = Vec2::Constant(-rounding);
  const Vec2 high = Vec2::Constant(4 + rounding);
  const Piece square{.name = "square",
                     .points = {low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())},
                     .corners = {0, 1, 2, 3},
                     .closed = true};
  const SplineCurve curve = fit_spline(square);
  const std::vector<Index> around{0, 1, 2, 3, 3, 7, 11, 15, 15, 14, 13, 12, 12, 8, 4, 0};
  CHECK(cells_of(trace(curve, unit_cells, "square")) == around);
}

TEST_CASE("along the border with its left outside, a curve has the cells inside", "[boundary][trace]") {
  CHECK(cells_of(trace(straight({4, 0}, {0, 0}), unit_cells, "border")) == std::vector<Index>{3, 2, 1, 0});
}

TEST_CASE("a touch does not split, and a passage through nodes splits once", "[boundary][trace]") {
  const SplineCurve bow =
      fit_spline(arc({2.5, 1.5}, 0.5, 45.0, 135.0, 3));  // its top touches y = 2 at a tracking point
  CHECK(cells_of(trace(bow, unit_cells, "bow")) == std::vector<Index>{6, 6});
  CHECK(cells_of(trace(straight({0.5, 0.5}, {3.5, 3.5}), unit_cells, "diagonal")) == std::vector<Index>{0, 5, 10, 15});

  const CubicSpan touch{{Vec2(2.1, 1.5), Vec2(2.3, 2 + 1.0 / 6), Vec2(2.6, 2 + 1.0 / 6), Vec2(2.9, 1.5)}};  // at u = ½
  REQUIRE_THAT(touch.position(0.5).y(), WithinAbs(2.0, 1e-15));
  const std::vector<Segment> segments = trace({.spans = {touch}, .knots = {0, 1}}, unit_cells, "touch");
  CHECK(cells_of(segments).front() == 6);
  CHECK(cells_of(segments).back() == 6);
  for (const Segment& s : segments) CHECK((s.cell == 6 || s.end - s.begin < 1e-7));
}

TEST_CASE("an inflection with its tangent along the line is one crossing", "[boundary][trace]") {
  const CubicSpan cubic{{Vec2(0.5, 0), Vec2(0.75, 2), Vec2(1.25, 0), Vec2(1.5, 2)}};  // y − 1 = (2u − 1)³
  const std::vector<Segment> segments = trace({.spans = {cubic}, .knots = {0, 1}}, unit_cells, "s");
  for (const Segment& s : segments) {
    const double y = cubic.position(0.5 * (s.begin + s.end)).y();
    CHECK((s.cell / 4 == (y > 1.0 ? 1 : 0)));
  }
  CHECK(segments.size() <= 3);
}

TEST_CASE("a curve that leaves the grid is refused with piece and place", "[boundary][trace]") {
  const auto message = [](const SplineCurve& curve) {
    try {
      (void)trace(curve, unit_cells, "shore");
    } catch (const OutsideGrid& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK_THAT(message(straight({1, 1}, {5, 1})), Contains("'shore'") && Contains("(4.5, 1)") && Contains("(4, 4)"));
  CHECK_THAT(message(straight({-1, -1}, {-1, 5})), Contains("'shore'") && Contains("(-1, "));
  CHECK_THAT(message(fit_spline(circle({2, 2}, 2.1, 4, false))), Contains("'shore'") && Contains("(4.07425, "));
  const auto bulge = [](double top) {  // x = top in its middle, between grid lines
    const double x = (top - 0.75) * 4.0 / 3.0;
    return SplineCurve{.spans = {{{Vec2(3, 1.1), Vec2(x, 1.4), Vec2(x, 1.6), Vec2(3, 1.9)}}}, .knots = {0, 1}};
  };
  CHECK_THAT(message(bulge(4.0 + 1.01 * border_slack)), Contains("'shore'") && Contains("(4.0101, 1.5)"));
  CHECK(message(bulge(4.0 + 0.99 * border_slack)) == "accepted");
  CHECK(message(bulge(4.0)) == "accepted");
  CHECK(message(bulge(4.0 - 1e-6)) == "accepted");
}
