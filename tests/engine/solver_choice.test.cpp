#include "shoreline/engine/solver_choice.hpp"

#include <catch2/catch.hpp>

using namespace shoreline;
using Catch::Matchers::Contains;

namespace {

/// A band that no rule takes.
SystemSize wide(Index unknowns, int functions_per_cell) {
  return {.unknowns = unknowns, .width = 100000, .functions_per_cell = functions_per_cell};
}

}  // namespace

TEST_CASE("a solver that is named is taken", "[engine][solver_choice]") {
  for (const SolverType type : {SolverType::band, SolverType::cholmod, SolverType::multigrid})
    for (const Index unknowns : {10, 100000000}) CHECK(choose_solver({.type = type}, wide(unknowns, 4)).type == type);
}

TEST_CASE("narrow bands are solved as bands whatever their length", "[engine][solver_choice]") {
  for (const Index unknowns : {100, 10000, 10000000})
    CHECK(choose_solver({}, {.unknowns = unknowns, .width = 50, .functions_per_cell = 4}).type == SolverType::band);
}

TEST_CASE("the choice changes once from the band to another as bands widen", "[engine][solver_choice]") {
  for (const int functions : {3, 4, 9, 16}) {
    bool band = true;
    for (Index width = 1; width < 2000; ++width) {
      const bool now = choose_solver({}, {.unknowns = 20000, .width = width, .functions_per_cell = functions}).type ==
                       SolverType::band;
      CHECK((band || !now));
      band = now;
    }
    CHECK_FALSE(band);
  }
}

TEST_CASE("multigrid is chosen only for many unknowns, where it is installed and nobody asks for pivots",
          "[engine][solver_choice]") {
  const SolverType large = multigrid_available() ? SolverType::multigrid : SolverType::cholmod;
  for (const int functions : {4, 9}) {
    CHECK(choose_solver({}, wide(100000, functions)).type == SolverType::cholmod);
    CHECK(choose_solver({}, wide(2000000, functions)).type == large);
    const SolverChoice kept = choose_solver({.needs_factors = true}, wide(2000000, functions));
    CHECK(kept.type == SolverType::cholmod);
    CHECK_THAT(kept.reason, Contains("pivots"));
  }
}

TEST_CASE("a choice gives its reason in numbers", "[engine][solver_choice]") {
  CHECK_THAT(choose_solver({}, {.unknowns = 1000, .width = 64, .functions_per_cell = 4}).reason, Contains("64"));
  CHECK_THAT(choose_solver({}, wide(100000, 4)).reason, Contains("100000"));
}

TEST_CASE("a band takes eight bytes for every place of its lower half", "[engine][solver_choice]") {
  CHECK(band_bytes({.unknowns = 1000, .width = 9, .functions_per_cell = 4}) == 80000.0);
}
