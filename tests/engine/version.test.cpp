#include "shoreline/engine/version.hpp"

#include <catch2/catch.hpp>

using namespace shoreline;
using Catch::Matchers::Contains;

TEST_CASE("the version report names version, build and libraries", "[engine][version]") {
  CHECK(version().find_first_not_of("0123456789.") == std::string::npos);
  CHECK_THAT(version_report(), Contains("shoreline " + version()) && Contains("build") && Contains("Eigen 3.") &&
                                   Contains("SuiteSparse") && Contains("BLAS"));
}
