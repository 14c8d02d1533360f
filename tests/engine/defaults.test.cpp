#include "shoreline/engine/defaults.hpp"

#include <catch2/catch.hpp>

#include "shoreline/engine/linear_elastic.hpp"

using namespace shoreline;

TEST_CASE("the penalty suits the basis: more for linear triangles, less for Powell-Sabin and cubic splines",
          "[engine][defaults]") {
  CHECK(ghost_for_nitsche(Case::BasisType::bilinear) == 1e-3);
  CHECK(ghost_for_nitsche(Case::BasisType::bspline, 1) == 1e-3);
  CHECK(ghost_for_nitsche(Case::BasisType::bspline, 2) == 3e-4);
  CHECK(ghost_for_nitsche(Case::BasisType::bspline, 3) == 1e-5);
  CHECK(ghost_for_nitsche(Case::BasisType::linear) == 1e-2);
  CHECK(ghost_for_nitsche(Case::BasisType::powell_sabin) == 1e-4);
}

TEST_CASE("where gradients jump, the band of Nitsche's method stays within the bound that the ghost penalty sets",
          "[engine][defaults]") {
  const LinearElastic material(1.0, 0.4, Plane::strain);
  const double bound = 4.0 / 3.0 / material.tangent(Stress::Zero())(0, 0);  // (D.10), of γ
  CHECK(nitsche_band(Case::BasisType::bilinear) <= bound * ghost_for_nitsche(Case::BasisType::bilinear));
  CHECK(nitsche_band(Case::BasisType::linear) <= bound * ghost_for_nitsche(Case::BasisType::linear));
  CHECK(nitsche_band(Case::BasisType::bspline, 1) == nitsche_band(Case::BasisType::bilinear));
  CHECK(nitsche_band(Case::BasisType::bspline) == 0.01);
  CHECK(nitsche_band(Case::BasisType::powell_sabin) == 0.02);
}
