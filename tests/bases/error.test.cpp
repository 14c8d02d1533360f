#include "shoreline/bases/error.hpp"

#include <catch2/catch.hpp>

using namespace shoreline;
using Catch::Matchers::Message;

TEST_CASE("a wrong argument is an error of Shoreline and a standard one, with its message", "[bases][error]") {
  const auto fail = [] { throw InvalidArgument("gauss: need 1 to 64 points, got 0"); };
  CHECK_THROWS_AS(fail(), Error);
  CHECK_THROWS_AS(fail(), std::runtime_error);
  CHECK_THROWS_MATCHES(fail(), InvalidArgument, Message("gauss: need 1 to 64 points, got 0"));
}
