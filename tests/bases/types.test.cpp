#include "shoreline/bases/types.hpp"

#include <catch2/catch.hpp>

#include "../random.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

TEST_CASE("the cross product is the signed area of a parallelogram", "[bases][types]") {
  test::Random random(1);
  for (int draw = 0; draw < 100; ++draw) {
    const Vec2 a = random.vector();
    const Vec2 b = random.vector();
    Mat2 sides;
    sides << a, b;
    CHECK_THAT(cross(a, b), WithinAbs(sides(0, 0) * sides(1, 1) - sides(0, 1) * sides(1, 0), 1e-15));
    CHECK(cross(b, a) == -cross(a, b));
    CHECK(cross(a, a) == 0.0);
  }
  CHECK(cross(Vec2::UnitX(), Vec2::UnitY()) == 1.0);  // counter-clockwise is positive
}

TEST_CASE("a box that is not set holds the origin alone", "[bases][types]") {
  CHECK(Box{}.lower == Vec2::Zero());
  CHECK(Box{}.upper == Vec2::Zero());
}
