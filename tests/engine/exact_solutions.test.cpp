#include "shoreline/engine/exact_solutions.hpp"

#include <catch2/catch.hpp>

#include "../plate.hpp"
#include "../random.hpp"
#include "shoreline/boundary/trace.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double ramp(double t) { return t; }

constexpr ThickCylinder cylinder{.inner_radius = 1.0, .outer_radius = 5.0, .pressure = 0.756e6};
constexpr PlateWithHole plate{.radius = 0.5, .far_field_stress = 1e6};

struct Drawn {
  ElasticConstants material;
  ExactSolution solution;
};

/// The ring and the plate in a random material, at a random load factor.
std::vector<Drawn> drawn(test::Random& random) {
  const ElasticConstants material{random.uniform(1e6, 1e7), random.uniform(-0.9, 0.45),
                                  random.whole(0, 1) == 0 ? Plane::strain : Plane::stress};
  const auto factor = [f = random.uniform(0.1, 2.0)](double t) { return f * t; };
  return {{material, exact_solution(cylinder, material, factor)}, {material, exact_solution(plate, material, factor)}};
}

/// Derivative of a field along an axis by central differences.
template <class Field>
auto slope(const Field& field, const Vec2& x, int axis) {
  constexpr double step = 1e-4;
  return ((field(x + step * Vec2::Unit(axis), 1.0) - field(x - step * Vec2::Unit(axis), 1.0)) / (2.0 * step)).eval();
}

Vec2 traction(const Vec3& stress, const Vec2& normal) {
  return {stress[0] * normal.x() + stress[2] * normal.y(), stress[2] * normal.x() + stress[1] * normal.y()};
}

}  // namespace

TEST_CASE("exact stresses are in equilibrium", "[engine][exact_solutions]") {
  test::Random random(1);
  for (int draw = 0; draw < 50; ++draw)
    for (const Drawn& exact : drawn(random)) {
      const Vec2 x = random.uniform(1.0, 5.0) * random.direction();
      const Vec3 along_x = slope(exact.solution.stress, x, 0);
      const Vec3 along_y = slope(exact.solution.stress, x, 1);
      const double scale = along_x.norm() + along_y.norm();
      CHECK_THAT(along_x[0] + along_y[2], WithinAbs(0.0, 1e-5 * scale));
      CHECK_THAT(along_x[2] + along_y[1], WithinAbs(0.0, 1e-5 * scale));
    }
}

TEST_CASE("exact stresses are those of the exact displacements", "[engine][exact_solutions]") {
  test::Random random(2);
  for (int draw = 0; draw < 50; ++draw)
    for (const Drawn& exact : drawn(random)) {
      const LinearElastic law(exact.material.youngs_modulus, exact.material.poissons_ratio, exact.material.plane);
      const Vec2 x = random.uniform(0.6, 5.0) * random.direction();
      const Vec2 along_x = slope(exact.solution.displacement, x, 0);
      const Vec2 along_y = slope(exact.solution.displacement, x, 1);
      const Stress stress = law.updated(Stress::Zero(), {along_x.x(), along_y.y(), along_y.x() + along_x.y()});
      const Vec3 expected = exact.solution.stress(x, 1.0);
      CHECK_THAT((stress.head<3>() - expected).norm(), WithinAbs(0.0, 1e-5 * expected.norm()));
    }
}

TEST_CASE("the hole of the plate is free, and far from it the stress is uniaxial", "[engine][exact_solutions]") {
  test::Random random(3);
  const ExactSolution exact = exact_solution(plate, {1e7, 0.2, Plane::stress}, ramp);
  for (int draw = 0; draw < 20; ++draw) {
    const Vec2 e = random.direction();
    CHECK_THAT(traction(exact.stress(0.5 * e, 1.0), e).norm(), WithinAbs(0.0, 1e-9 * 1e6));
    CHECK_THAT((exact.stress(1e5 * e, 1.0) - Vec3(1e6, 0.0, 0.0)).norm(), WithinAbs(0.0, 1e-9 * 1e6));
  }
}

TEST_CASE("the ring is under the pressure at its inner radius and free at its outer one", "[engine][exact_solutions]") {
  test::Random random(4);
  const ExactSolution exact = exact_solution(cylinder, {1e6, 0.25, Plane::strain}, ramp);
  for (int draw = 0; draw < 20; ++draw) {
    const Vec2 e = random.direction();
    CHECK_THAT((traction(exact.stress(e, 1.0), e) + 0.756e6 * e).norm(), WithinAbs(0.0, 1e-9 * 1e6));
    CHECK_THAT(traction(exact.stress(5.0 * e, 1.0), e).norm(), WithinAbs(0.0, 1e-9 * 1e6));
    CHECK_THAT(cross(exact.displacement(2.0 * e, 1.0), e), WithinAbs(0.0, 1e-15));
  }
}

TEST_CASE("displacements of the ring and the plate of Bing et al. 2019, by hand from the closed forms",
          "[engine][exact_solutions]") {
  const ExactSolution ring = exact_solution(cylinder, {1e6, 0.25, Plane::strain}, ramp);
  CHECK_THAT(1.0 + ring.displacement(Vec2(1.0, 0.0), 1.0).x(), WithinRel(2.0040625, 1e-14));
  CHECK_THAT(5.0 + ring.displacement(Vec2(0.0, 5.0), 1.0).y(), WithinRel(5.2953125, 1e-14));

  const ExactSolution holed = exact_solution(plate, {1e7, 0.2, Plane::stress}, ramp);
  CHECK_THAT((holed.displacement(Vec2(0.5, 0.0), 1.0) - Vec2(0.15, 0.0)).norm(), WithinAbs(0.0, 1e-15));
  CHECK_THAT((holed.displacement(Vec2(2.0, 0.75), 1.0) - Vec2(0.225067902, -0.0124450988)).norm(),
             WithinAbs(0.0, 1e-10));
}

TEST_CASE("Kirsch's stress at the hole: three times the far field at its top, its negative at its side",
          "[engine][exact_solutions]") {
  const ExactSolution exact = exact_solution(plate, {1e7, 0.2, Plane::stress}, ramp);
  CHECK_THAT((exact.stress(Vec2(0.0, 0.5), 1.0) - Vec3(3e6, 0.0, 0.0)).norm(), WithinAbs(0.0, 1e-6));
  CHECK_THAT((exact.stress(Vec2(0.5, 0.0), 1.0) - Vec3(0.0, -1e6, 0.0)).norm(), WithinAbs(0.0, 1e-6));
}

TEST_CASE("the resultant of the exact traction on the plate's outer boundary", "[engine][exact_solutions]") {
  const ExactSolution exact = exact_solution(plate, {1e7, 0.2, Plane::stress}, ramp);
  const SplineCurve curve = fit_spline(test::plate_outer());
  const QuadrilateralGrid grid(Vec2::Zero(), Vec2(0.25, 0.25), {9, 9});
  Vec2 sum = Vec2::Zero();
  for (const BoundaryPoint& p : boundary_points(curve, trace(curve, grid, "outer"), gauss(8)))
    sum += p.weight * traction(exact.stress(p.x, 1.0), -p.normal);
  // Stress is divergence-free: by Gauss' theorem the two straight edges of the quarter plate carry the opposite.
  CHECK_THAT((sum / 1e6 - Vec2(1.4074074074, -0.0740740741)).norm(), WithinAbs(0.0, 1e-9));
}

TEST_CASE("a solution follows its load factor", "[engine][exact_solutions]") {
  const ElasticConstants material{1e6, 0.25, Plane::stress};
  const Vec2 x(1.3, 0.4);
  const auto check = [&](const auto& problem) {
    const ExactSolution whole = exact_solution(problem, material, ramp);
    const ExactSolution squared = exact_solution(problem, material, [](double t) { return t * t; });
    CHECK(squared.displacement(x, 0.5).isApprox(0.25 * whole.displacement(x, 1.0), 1e-14));
    CHECK(squared.stress(x, 0.5).isApprox(0.25 * whole.stress(x, 1.0), 1e-14));
  };
  check(cylinder);
  check(plate);
}

TEST_CASE("radii that make no ring or hole are refused with the value", "[engine][exact_solutions]") {
  const ElasticConstants material{1e6, 0.25, Plane::strain};
  const auto ring = [&](double a, double b) { return exact_solution(ThickCylinder{a, b, 1.0}, material, ramp); };
  CHECK_THROWS_WITH(ring(0.0, 1.0), Contains("radius > 0, got 0.0"));
  CHECK_THROWS_WITH(ring(2.0, 2.0), Contains("outer radius > 2.0") && Contains("got 2.0"));
  CHECK_THROWS_AS(ring(NAN, 2.0), InvalidArgument);
  CHECK_THROWS_AS(ring(1.0, NAN), InvalidArgument);
  CHECK_THROWS_WITH(exact_solution(PlateWithHole{-0.5, 1.0}, material, ramp), Contains("got -0.5"));
}
