#include "shoreline/engine/exact_solutions.hpp"

#include <catch2/catch.hpp>
#include <numbers>

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

namespace {

constexpr SelfWeightColumn column{.height = 1.5, .density = 2000.0, .gravity = 9.81};
const ElasticConstants soft{1e5, 0.3, Plane::strain};
const double modulus = 1e5 * 0.7 / (1.3 * 0.4);  // λ + 2μ
const double period = 4.0 * column.height / std::sqrt(modulus / column.density);
const double amplitude = column.density * column.gravity * column.height * column.height / modulus;

/// The column's displacement by its series, eigenfunctions sin((2n−1)πy/2H) about the equilibrium.
double series(double y, double t) {
  constexpr double pi = std::numbers::pi;
  double u = 0.5 * y * y / column.height / column.height - y / column.height;
  for (int n = 1; n <= 200; ++n) {
    const double k = (2.0 * n - 1.0) * pi / 2.0;
    u += 2.0 / (k * k * k) * std::cos(k * 4.0 * t / period) * std::sin(k * y / column.height);
  }
  return amplitude * u;
}

}  // namespace

TEST_CASE("the column under its own weight is the sum of its series", "[engine][exact_solutions]") {
  const ExactSolution exact = exact_solution(column, soft);
  test::Random random(5);
  for (int draw = 0; draw < 200; ++draw) {
    const double y = random.uniform(0.0, column.height), t = random.uniform(0.0, 3.0 * period);
    const Vec2 u = exact.displacement(Vec2(random.uniform(-1.0, 1.0), y), t);
    CHECK(u.x() == 0.0);
    CHECK_THAT(u.y(), WithinAbs(series(y, t), 1e-4 * amplitude));
  }
  // half a period after the start it has gone down by twice its settlement
  CHECK_THAT(exact.displacement(Vec2(0.0, column.height), 0.5 * period).y(), WithinRel(-amplitude, 1e-12));
}

TEST_CASE("the column under its own weight starts at rest, is held at the base and free at the top",
          "[engine][exact_solutions]") {
  const ExactSolution exact = exact_solution(column, soft);
  test::Random random(6);
  for (int draw = 0; draw < 50; ++draw) {
    const Vec2 x(0.3, random.uniform(0.0, column.height));
    const double t = random.uniform(0.0, 3.0 * period);
    CHECK_THAT(exact.displacement(x, 0.0).y(), WithinAbs(0.0, 1e-14 * amplitude));
    CHECK_THAT(exact.displacement(x, 1e-7 * period).y(), WithinAbs(0.0, 1e-12 * amplitude));
    CHECK_THAT(exact.stress(x, 0.0).norm(), WithinAbs(0.0, 1e-9 * modulus * amplitude));
    CHECK_THAT(exact.displacement(Vec2(0.3, 0.0), t).y(), WithinAbs(0.0, 1e-13 * amplitude));
    CHECK_THAT(exact.stress(Vec2(0.3, column.height), t).norm(), WithinAbs(0.0, 1e-12 * modulus * amplitude));
  }
}

TEST_CASE("the column moves by the wave equation under gravity, with the stress of its strain",
          "[engine][exact_solutions]") {
  const ExactSolution exact = exact_solution(column, soft);
  const double speed = std::sqrt(modulus / column.density);
  test::Random random(7);
  const double step = 1e-4;  // [m]
  int checked = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const double y = random.uniform(0.1, 1.4), t = random.uniform(0.1 * period, 3.0 * period);
    const auto near_kink = [&](double z) { return std::abs(std::remainder(z, 2.0 * column.height)) < 3.0 * step; };
    if (near_kink(y - speed * t) || near_kink(y + speed * t)) continue;
    ++checked;
    const auto u = [&](double dy, double dt) { return exact.displacement(Vec2(0.0, y + dy), t + dt).y(); };
    const double strain = (u(step, 0.0) - u(-step, 0.0)) / (2.0 * step);
    const Vec3 stress = exact.stress(Vec2(0.0, y), t);
    CHECK_THAT(stress[1], WithinAbs(modulus * strain, 1e-7 * modulus * amplitude));
    CHECK_THAT(stress[0], WithinAbs(0.3 / 0.7 * stress[1], 1e-9 * modulus));
    CHECK(stress[2] == 0.0);
    const double dt = step / speed;
    const double acceleration = (u(0.0, dt) - 2.0 * u(0.0, 0.0) + u(0.0, -dt)) / (dt * dt);
    const double curvature = (u(step, 0.0) - 2.0 * u(0.0, 0.0) + u(-step, 0.0)) / (step * step);
    CHECK_THAT(acceleration, WithinAbs(speed * speed * curvature - column.gravity, 1e-4 * column.gravity));
  }
  CHECK(checked > 150);
}

TEST_CASE("a column without height is refused with the value", "[engine][exact_solutions]") {
  CHECK_THROWS_WITH(exact_solution(SelfWeightColumn{0.0, 1.0, 9.81}, soft), Contains("height > 0, got 0.0"));
  CHECK_THROWS_AS(exact_solution(SelfWeightColumn{NAN, 1.0, 9.81}, soft), InvalidArgument);
}
