#include "shoreline/engine/results.hpp"

#include <catch2/catch.hpp>

using namespace shoreline;

TEST_CASE("a summary has not completed, and has no errors, until it says so", "[engine][results]") {
  const Summary summary;
  CHECK_FALSE(summary.completed);
  CHECK_FALSE(summary.errors);
  CHECK_FALSE(summary.condition_estimate);
  CHECK(summary.warnings.empty());
  CHECK(summary.probes.empty());
  CHECK(summary.displacement_fit.empty());
  CHECK(summary.steps == 0);
  CHECK_FALSE(summary.dynamics);
  CHECK(summary.history.empty());
}

TEST_CASE("the total energy is the sum of its parts", "[engine][results]") {
  CHECK(HistoryState{.t = 9.0, .kinetic = 1.0, .strain = 2.0, .gravity = -4.0}.total() == -1.0);
}

TEST_CASE("norms that were not formed are missing, not zero", "[engine][results]") {
  const ErrorNorms norms;
  CHECK_FALSE(norms.displacement_l2_relative);
  CHECK_FALSE(norms.stress_l2_relative);
  for (const ErrorNorms::Component& c : norms.displacement) CHECK_FALSE(c.mean_relative);
  for (const ErrorNorms::Component& c : norms.stress) CHECK_FALSE(c.mean_relative);
}
