#include "shoreline/engine/failures.hpp"

#include <catch2/catch.hpp>

using namespace shoreline;

TEST_CASE("a case error says file, place and problem, in this order", "[engine][failures]") {
  const CaseError error("a.json", "/grid/lower", "found 1, expected 2");
  CHECK(std::string(error.what()) == "a.json: /grid/lower: found 1, expected 2");
  CHECK(error.pointer() == "/grid/lower");
  CHECK(std::string(CaseError("a.json", "", "is empty").what()) == "a.json: is empty");
}

TEST_CASE("each failure is an error and none is another", "[engine][failures]") {
  CHECK_THROWS_AS(throw CaseError("a.json", "", ""), Error);
  CHECK_THROWS_AS(throw ComputationError("step 1"), Error);
  CHECK_THROWS_AS(throw OutputError("disk full"), Error);
  STATIC_REQUIRE_FALSE(std::is_base_of_v<ComputationError, OutputError>);
  STATIC_REQUIRE_FALSE(std::is_base_of_v<CaseError, ComputationError>);
}
