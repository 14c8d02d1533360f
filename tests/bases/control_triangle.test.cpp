#include "shoreline/bases/control_triangle.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "../random.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/bases/triangle_mesh.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double area(const std::array<Vec2, 3>& q) { return 0.5 * twice_area(q[0], q[1], q[2]); }

/// How far the points reach beyond the sides of a triangle [m].
double beyond(const std::array<Vec2, 3>& q, const std::vector<Vec2>& points) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 side = (q[(k + 1) % 3] - q[k]).normalized();
    for (const Vec2& p : points) farthest = std::max(farthest, -cross(side, p - q[k]));
  }
  return farthest;
}

/// Whether a side of the triangle lies on a line.
bool has_side(const std::array<Vec2, 3>& q, const Line& line) {
  const auto on_line = [&](const Vec2& p) { return std::abs(line.normal.dot(p) - line.offset) < 1e-12; };
  return std::ranges::count_if(q, on_line) == 2;
}

std::vector<Vec2> cloud(test::Random& random) {
  std::vector<Vec2> points(static_cast<std::size_t>(random.whole(3, 20)));
  for (Vec2& p : points) p = random.vector();
  return points;
}

double support(const std::vector<Vec2>& points, double angle) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& p : points) least = std::min(least, p.dot(Vec2(std::cos(angle), std::sin(angle))));
  return least;
}

/// The least area of triangles whose three sides touch the points, over many directions of sides.
double least_area(const std::vector<Vec2>& points) {
  constexpr int directions = 72;
  const auto angle = [](int k) { return 2.0 * std::numbers::pi * k / directions; };
  std::vector<double> offset;
  for (int k = 0; k < directions; ++k) offset.push_back(support(points, angle(k)));
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < directions; ++i)
    for (int j = i + 1; j < std::min(i + directions / 2, directions); ++j)
      for (int k = std::max(j + 1, i + directions / 2 + 1); k < std::min(j + directions / 2, directions); ++k) {
        const auto o = [&](int n) { return offset[static_cast<std::size_t>(n)]; };
        const double s = o(i) * std::sin(angle(k - j)) + o(j) * std::sin(angle(i - k)) + o(k) * std::sin(angle(j - i));
        least = std::min(
            least,
            0.5 * s * s / (std::sin(angle(k - j)) * std::sin(angle(k - i + directions / 2)) * std::sin(angle(j - i))));
      }
  return least;
}

}  // namespace

TEST_CASE("a control triangle is counter-clockwise and holds all points", "[bases][control_triangle]") {
  test::Random random(1);
  for (int draw = 0; draw < 500; ++draw) {
    const std::vector<Vec2> points = cloud(random);
    const auto q = control_triangle(points, {});
    CHECK(area(q) > 0.0);
    CHECK(beyond(q, points) <= 1e-13 * (q[1] - q[0]).norm());
  }
}

TEST_CASE("three points are their own control triangle, a square's has twice its area", "[bases][control_triangle]") {
  test::Random random(2);
  for (int draw = 0; draw < 50; ++draw) {
    const std::vector<Vec2> three{random.vector(), random.vector(), random.vector()};
    CHECK_THAT(area(control_triangle(three, {})),
               WithinRel(0.5 * std::abs(twice_area(three[0], three[1], three[2])), 1e-10));
    const Vec2 side = random.vector();
    const Vec2 across(-side.y(), side.x());
    const std::vector<Vec2> square{three[0], three[0] + side, three[0] + side + across, three[0] + across};
    CHECK_THAT(area(control_triangle(square, {})), WithinRel(2.0 * side.squaredNorm(), 1e-10));
  }
}

TEST_CASE("no triangle around the points is smaller by more than a fifth, and few by more than two percent",
          "[bases][control_triangle]") {
  test::Random random(3);
  int larger = 0;
  for (int draw = 0; draw < 100; ++draw) {
    const std::vector<Vec2> points = cloud(random);
    const double ratio = area(control_triangle(points, {})) / least_area(points);
    CHECK(ratio < 1.2);
    if (ratio > 1.02) ++larger;
  }
  CHECK(larger < 20);
}

TEST_CASE("given sides are sides of the triangle, which holds all points", "[bases][control_triangle]") {
  test::Random random(4);
  for (int draw = 0; draw < 200; ++draw) {
    const std::vector<Vec2> points = cloud(random);
    const double angle = random.uniform(0.0, 6.3);
    const auto touching = [&](double at) { return Line{Vec2(std::cos(at), std::sin(at)), support(points, at)}; };
    const std::vector<Line> sides{touching(angle), touching(angle + random.uniform(0.3, 2.8))};
    for (const std::size_t given : {1, 2}) {
      const auto q = control_triangle(points, std::span(sides).first(given));
      CHECK(area(q) > 0.0);
      CHECK(beyond(q, points) <= 1e-12 * (q[1] - q[0]).norm());
      for (std::size_t k = 0; k < given; ++k) CHECK(has_side(q, sides[k]));
    }
  }
}

TEST_CASE("points on one line have no control triangle", "[bases][control_triangle]") {
  const std::vector<Vec2> points{{0.0, 0.0}, {1.0, 1.0}, {3.0, 3.0}};
  CHECK_THROWS_AS(control_triangle(points, {}), InvalidArgument);
  CHECK_THROWS_WITH(control_triangle(points, {}), Contains("one line"));
}
