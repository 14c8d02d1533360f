#include "shoreline/engine/defaults.hpp"

#include <catch2/catch.hpp>

using namespace shoreline;

TEST_CASE("the penalty suits the basis: more for linear triangles, less for Powell-Sabin and cubic splines",
          "[engine][defaults]") {
  CHECK(ghost_for_nitsche(Case::BasisType::bilinear) == 1e-3);
  CHECK(ghost_for_nitsche(Case::BasisType::bspline, 1) == 1e-3);
  CHECK(ghost_for_nitsche(Case::BasisType::bspline, 2) == 5e-4);
  CHECK(ghost_for_nitsche(Case::BasisType::bspline, 3) == 1e-5);
  CHECK(ghost_for_nitsche(Case::BasisType::linear) == 1e-2);
  CHECK(ghost_for_nitsche(Case::BasisType::powell_sabin) == 1e-4);
}

TEST_CASE("the band of Nitsche's method is twice as wide on Powell-Sabin splines", "[engine][defaults]") {
  CHECK(nitsche_band(Case::BasisType::bilinear) == 0.01);
  CHECK(nitsche_band(Case::BasisType::bspline) == 0.01);
  CHECK(nitsche_band(Case::BasisType::linear) == 0.01);
  CHECK(nitsche_band(Case::BasisType::powell_sabin) == 0.02);
}
