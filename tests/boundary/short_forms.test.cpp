#include "shoreline/boundary/short_forms.hpp"

#include <catch2/catch.hpp>

#include "shoreline/bases/error.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

TEST_CASE("a line keeps its ends and a shared coordinate exactly", "[boundary][short_forms]") {
  const Piece piece = line({0.3, 0.1}, {0.3, 0.7}, 8);
  REQUIRE(piece.points.size() == 8);
  CHECK(piece.points.front() == Vec2(0.3, 0.1));
  CHECK(piece.points.back() == Vec2(0.3, 0.7));
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(piece.points[k].x() == 0.3);
    CHECK_THAT(piece.points[k].y(), WithinAbs(0.1 + 0.6 * static_cast<double>(k) / 7.0, 1e-15));
  }
  CHECK(line({0, 0}, {1, 2}).points.size() == 2);
}

TEST_CASE("an arc meets multiples of 90 degrees exactly, with the circle's tangents at its ends", "[boundary]") {
  const Piece up = arc({0, 0}, 0.7, 0.0, 90.0, 3);
  CHECK(up.points.front() == Vec2(0.7, 0.0));
  CHECK(up.points.back() == Vec2(0.0, 0.7));
  CHECK(*up.start_tangent == Vec2(0, 1));
  CHECK(*up.end_tangent == Vec2(-1, 0));

  const Piece down = arc({1, 2}, 0.5, 90.0, -180.0, 7);
  CHECK(down.points.front() == Vec2(1.0, 2.5));
  CHECK(down.points[2] == Vec2(1.5, 2.0));
  CHECK(down.points.back() == Vec2(0.5, 2.0));
  CHECK(*down.start_tangent == Vec2(1, 0));
  CHECK(*down.end_tangent == Vec2(0, 1));
  CHECK_FALSE(down.closed);
  for (const Vec2& x : down.points) CHECK_THAT((x - Vec2(1, 2)).norm(), WithinAbs(0.5, 1e-15));
}

TEST_CASE("a circle runs counter-clockwise, around a hole clockwise", "[boundary][short_forms]") {
  const bool hole = GENERATE(false, true);
  const Piece piece = circle({0, 0}, 2.0, 12, hole);
  REQUIRE(piece.points.size() == 12);
  CHECK(piece.closed);
  CHECK(piece.points[3] == Vec2(0.0, hole ? -2.0 : 2.0));
  for (std::size_t k = 0; k < 12; ++k) {
    const double turn = cross(piece.points[k], piece.points[(k + 1) % 12]);
    CHECK_THAT(turn, WithinAbs((hole ? -4.0 : 4.0) * 0.5, 1e-14));  // r² sin 30°
  }
}

TEST_CASE("short forms refuse what makes no curve, with the value", "[boundary][short_forms]") {
  CHECK_THROWS_WITH(line({0, 0}, {1, 0}, 1), Contains("at least 2 points, got 1"));
  CHECK_THROWS_WITH(line({1, 2}, {1, 2}), Contains("(1, 2)"));
  CHECK_THROWS_WITH(arc({0, 0}, -1.0, 0.0, 90.0, 5), Contains("-1"));
  CHECK_THROWS_WITH(arc({0, 0}, 1.0, 30.0, 30.0, 5), Contains("30"));
  CHECK_THROWS_WITH(arc({0, 0}, 1.0, 0.0, 360.0, 5), Contains("360"));
  CHECK_THROWS_WITH(circle({0, 0}, 1.0, 2, false), Contains("at least 3 points, got 2"));
  CHECK_THROWS_AS(circle({0, 0}, 0.0, 8, false), InvalidArgument);
}
