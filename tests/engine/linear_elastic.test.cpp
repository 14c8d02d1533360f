#include "shoreline/engine/linear_elastic.hpp"

#include <catch2/catch.hpp>

#include "../random.hpp"
#include "shoreline/bases/error.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const Stress none = Stress::Zero();

}  // namespace

TEST_CASE("strains of a stress are those of Hooke's law in three dimensions", "[engine][linear_elastic]") {
  test::Random random(1);
  for (int draw = 0; draw < 50; ++draw) {
    const double e = random.uniform(1.0, 100.0);
    const double nu = random.uniform(-0.9, 0.49);
    const Vec3 strain(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      const Stress s = LinearElastic(e, nu, plane).updated(none, strain);
      CHECK_THAT((s[0] - nu * (s[1] + s[3])) / e, WithinAbs(strain[0], 1e-12));
      CHECK_THAT((s[1] - nu * (s[0] + s[3])) / e, WithinAbs(strain[1], 1e-12));
      CHECK_THAT(s[2] * 2.0 * (1.0 + nu) / e, WithinAbs(strain[2], 1e-12));
      if (plane == Plane::strain) CHECK_THAT((s[3] - nu * (s[0] + s[1])) / e, WithinAbs(0.0, 1e-12));
      if (plane == Plane::stress) CHECK(s[3] == 0.0);
    }
  }
}

TEST_CASE("a bar in plane stress has Young's modulus, in plane strain E/(1 - nu^2)", "[engine][linear_elastic]") {
  const double nu = 0.3;
  const Vec3 bar_stress(1.0, -nu, 0.0);  // lateral strains that leave σ_yy = 0
  const Vec3 bar_strain(1.0, -nu / (1.0 - nu), 0.0);
  const Stress in_stress = LinearElastic(7.0, nu, Plane::stress).updated(none, bar_stress);
  const Stress in_strain = LinearElastic(7.0, nu, Plane::strain).updated(none, bar_strain);
  CHECK_THAT(in_stress[0], WithinRel(7.0, 1e-14));
  CHECK_THAT(in_stress[1], WithinAbs(0.0, 1e-14));
  CHECK_THAT(in_strain[0], WithinRel(7.0 / (1.0 - nu * nu), 1e-14));
  CHECK_THAT(in_strain[1], WithinAbs(0.0, 1e-14));
}

TEST_CASE("the tangent is the derivative of stress, symmetric, positive, and the same at every stress",
          "[engine][linear_elastic]") {
  test::Random random(2);
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const LinearElastic law(3.0, 0.2, plane);
    const Mat3 tangent = law.tangent(none);
    const Stress some(1.0, 2.0, 3.0, 4.0);
    CHECK(law.constant_tangent());
    CHECK(law.tangent(some) == tangent);
    CHECK(tangent == tangent.transpose());
    for (int c = 0; c < 3; ++c)
      CHECK((law.updated(some, Vec3::Unit(c)) - some).head<3>().isApprox(tangent.col(c), 1e-14));
    for (int draw = 0; draw < 20; ++draw) {
      const Vec3 strain(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      CHECK(strain.dot(tangent * strain) > 0.0);
    }
  }
}

TEST_CASE("the scale of penalties is Young's modulus", "[engine][linear_elastic]") {
  CHECK(LinearElastic(5.0, 0.4, Plane::strain).stiffness() == 5.0);
  CHECK(LinearElastic(5.0, 0.4, Plane::strain).name() == "linear_elastic");
}

TEST_CASE("constants that no elastic material has are refused with the value", "[engine][linear_elastic]") {
  const auto law = [](double e, double nu) { return LinearElastic(e, nu, Plane::strain); };
  CHECK_THROWS_WITH(law(0.0, 0.3), Contains("Young's modulus") && Contains("got 0.0"));
  CHECK_THROWS_WITH(law(-2.5, 0.3), Contains("got -2.5"));
  CHECK_THROWS_AS(law(NAN, 0.3), InvalidArgument);
  CHECK_THROWS_AS(law(INFINITY, 0.3), InvalidArgument);
  CHECK_THROWS_WITH(law(1.0, 0.5), Contains("Poisson's ratio") && Contains("got 0.5"));
  CHECK_THROWS_WITH(law(1.0, -1.0), Contains("got -1.0"));
  CHECK_THROWS_AS(law(1.0, NAN), InvalidArgument);
  CHECK_NOTHROW(law(1.0, 0.499));
}
