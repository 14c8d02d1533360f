#include "shoreline/boundary/conditions.hpp"

#include <catch2/catch.hpp>
#include <string>

using namespace shoreline;

namespace {

std::string kind(const Condition& condition) {
  return std::visit(
      Overloaded{[](const Free&) { return "free"; }, [](const Traction&) { return "traction"; },
                 [](const Pressure&) { return "pressure"; }, [](const Essential&) { return "essential"; }},
      condition);
}

}  // namespace

TEST_CASE("a visitor of lambdas takes the one for the condition at hand", "[boundary][conditions]") {
  CHECK(kind(Free{}) == "free");
  CHECK(kind(Traction{}) == "traction");
  CHECK(kind(Pressure{}) == "pressure");
  CHECK(kind(Essential{}) == "essential");
}

TEST_CASE("a piece of which nothing is said is free, one that is held is fixed in a band of a thousandth of a cell",
          "[boundary][conditions]") {
  CHECK(kind(Condition{}) == "free");
  CHECK_FALSE(Essential{}.normal_only);
  CHECK(Essential{}.method == EssentialMethod::implicit_boundary);
  CHECK(Essential{}.band == 1e-3);
}

TEST_CASE("loads are functions of a boundary point and time", "[boundary][conditions]") {
  BoundaryPoint p{};
  p.x = Vec2(3.0, 4.0);
  p.normal = Vec2(0.0, -1.0);
  const Condition traction = Traction{[](const BoundaryPoint& at, double t) -> Vec2 { return t * at.x; }};
  const Condition pressure = Pressure{[](const BoundaryPoint& at, double t) { return t * at.normal.y(); }};
  CHECK(std::get<Traction>(traction).value(p, 0.5) == Vec2(1.5, 2.0));
  CHECK(std::get<Pressure>(pressure).value(p, 0.5) == -0.5);
}
