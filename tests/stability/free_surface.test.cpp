// The critical time step while the top of a column passes through a cell.

#include <catch2/catch.hpp>

#include "shoreline/engine/failures.hpp"
#include "sweeps.hpp"

using namespace shoreline;

namespace {

constexpr int places = 24;

}  // namespace

TEST_CASE(
    "partly lumped or with a ghost mass the critical step stays within 30 % of that of full cells wherever the "
    "surface is",
    "[stability][dynamics]") {
  for (const std::string volumes : {"clipped", "fitted"})
    for (const std::vector<std::string>& mass : std::vector<std::vector<std::string>>{
             {"analysis.mass=partly_lumped"}, {"analysis.mass=consistent", "ghost=0.01"}}) {
      const test::SurfaceRow row = test::surface_sweep(mass, volumes, places);
      CAPTURE(volumes, mass, row.full, row.least, row.most);
      CHECK(row.least >= 0.7 * row.full);
      CHECK(row.most <= 1.3 * row.full);
    }
}

TEST_CASE("lumped it falls further, but stays above that of full cells under the partly lumped mass",
          "[stability][dynamics]") {
  for (const std::string volumes : {"clipped", "fitted"}) {
    CAPTURE(volumes);
    CHECK(test::surface_sweep({"analysis.mass=lumped"}, volumes, places).least >=
          test::surface_sweep({"analysis.mass=partly_lumped"}, volumes, 1).full);
  }
}

TEST_CASE("with the consistent mass alone it collapses as the surface leaves a cell, until the mass is singular",
          "[stability][dynamics]") {
  const std::vector<std::string> consistent{"analysis.mass=consistent"};
  const test::SurfaceRow row = test::surface_sweep(consistent, "clipped", 4);  // to three quarters of a block below
  CHECK(row.least < 0.5 * row.full);
  CHECK_THROWS_AS(test::surface_sweep(consistent, "clipped", places), ComputationError);
}
