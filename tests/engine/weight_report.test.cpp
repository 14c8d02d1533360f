#include "shoreline/engine/weight_report.hpp"

#include <catch2/catch.hpp>

using namespace shoreline;

TEST_CASE("reports of several fits: the worst of each, the work of all", "[engine][weight_report]") {
  WeightReport report{.changed = 0.1, .bounded = 3, .unmet = 1e-9, .iterations = 4, .factorisations = 1};
  report.add({.changed = 0.05, .bounded = 7, .unmet = 1e-7, .iterations = 2, .factorisations = 2});
  CHECK(report.changed == 0.1);
  CHECK(report.bounded == 7);
  CHECK(report.unmet == 1e-7);
  CHECK(report.iterations == 6);
  CHECK(report.factorisations == 3);
}
