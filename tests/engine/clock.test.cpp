#include "shoreline/engine/clock.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <thread>

using namespace shoreline;

namespace {

void pause(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

}  // namespace

TEST_CASE("time is booked by name, in the order of first use", "[engine][clock]") {
  Clock clock;
  CHECK(clock.entries().empty());
  clock.time("solve", [] { pause(2); });
  clock.time("assembly", [] {});
  clock.time("solve", [] { pause(3); });
  REQUIRE(clock.entries().size() == 2);
  CHECK(clock.entries()[0].name == "solve");
  CHECK(clock.entries()[0].calls == 2);
  CHECK(clock.entries()[0].seconds >= 0.005);
  CHECK(clock.entries()[1].name == "assembly");
  CHECK(clock.entries()[1].calls == 1);
  CHECK(clock.entries()[1].seconds < clock.entries()[0].seconds);
}

TEST_CASE("timed work returns what it returns, values and references", "[engine][clock]") {
  Clock clock;
  int number = 1;
  CHECK(clock.time("value", [] { return 42; }) == 42);
  clock.time("reference", [&]() -> int& { return number; }) = 7;
  CHECK(number == 7);
}

TEST_CASE("phases nest: the outer one has the inner one's time too", "[engine][clock]") {
  Clock clock;
  clock.time("outer", [&] { clock.time("inner", [] { pause(2); }); });
  REQUIRE(clock.entries().size() == 2);
  CHECK(clock.entries()[0].name == "inner");  // it ended first
  CHECK(clock.entries()[1].seconds >= clock.entries()[0].seconds);
}

TEST_CASE("work that fails is booked as well", "[engine][clock]") {
  Clock clock;
  CHECK_THROWS_AS(clock.time("solve", []() -> int { throw std::runtime_error("singular"); }), std::runtime_error);
  REQUIRE(clock.entries().size() == 1);
  CHECK(clock.entries()[0].calls == 1);
}
