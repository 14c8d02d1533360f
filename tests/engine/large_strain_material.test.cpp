#include "shoreline/engine/large_strain_material.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>

#include "../random.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/engine/linear_elastic.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using Law = std::unique_ptr<LargeStrainMaterial>;

const Mat2 identity = Mat2::Identity();
const Stress none = Stress::Zero();

std::vector<Law> every_law(double e, double nu) {
  std::vector<Law> laws;
  laws.push_back(linear_large(e, nu));
  laws.push_back(neo_hookean(e, nu));
  laws.push_back(hypoelastic(e, nu));
  return laws;
}

/// Where a law stands after steps along a motion.
struct State {
  Mat2 d = identity;
  Stress stress = none;
};

/// Steps D ← D + ΔL D from D = I with the same increment ΔL of the velocity gradient.
State after(const LargeStrainMaterial& law, const Mat2& increment, int steps) {
  State state;
  for (int k = 0; k < steps; ++k) {
    state.d += increment * state.d;
    state.stress = law.updated(state.stress, increment, state.d);
  }
  return state;
}

Mat2 matrix(double xx, double xy, double yx, double yy) {
  Mat2 m;
  m << xx, xy, yx, yy;
  return m;
}

Mat2 random_matrix(test::Random& random, double size) {
  return matrix(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size),
                random.uniform(-size, size));
}

Mat2 tensor(const Stress& s) { return matrix(s[0], s[2], s[2], s[1]); }

/// R σ Rᵀ; the component out of plane stays.
Stress turned(const Mat2& r, const Stress& s) {
  const Mat2 t = r * tensor(s) * r.transpose();
  return {t(0, 0), t(1, 1), t(0, 1), s[3]};
}

Mat2 rotation(double angle) { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }

/// J σ : L, the power per original volume of a velocity gradient.
double power(const Stress& s, const Mat2& d, const Mat2& l) {
  return d.determinant() * tensor(s).cwiseProduct(l).sum();
}

/// Slope of the energy of a law whose stress is a function of D, along D + s L D.
double energy_slope(const LargeStrainMaterial& law, const Mat2& d, const Mat2& l) {
  constexpr double step = 1e-6;
  const auto energy = [&](double s) {
    const Mat2 moved = d + s * l * d;
    return law.energy(law.updated(none, s * l, moved), moved);
  };
  return (energy(step) - energy(-step)) / (2.0 * step);
}

}  // namespace

TEST_CASE("a body that was never strained carries no stress and no energy", "[engine][large_strain]") {
  for (const Law& law : every_law(3.0, 0.3)) {
    CAPTURE(law->name());
    CHECK(law->updated(none, Mat2::Zero(), identity) == none);
    CHECK(law->energy(none, identity) == 0.0);
  }
}

TEST_CASE("at small strain every law is that of linear elasticity, to second order", "[engine][large_strain]") {
  test::Random random(1);
  for (int draw = 0; draw < 30; ++draw) {
    const double nu = random.uniform(-0.5, 0.45);
    const Mat2 g = random_matrix(random, 1.0);
    for (const double size : {1e-3, 1e-5}) {
      const Mat2 u = size * g;
      const Stress hooke = LinearElastic(1.0, nu, Plane::strain).updated(none, {u(0, 0), u(1, 1), u(0, 1) + u(1, 0)});
      for (const Law& law : every_law(1.0, nu)) {
        CAPTURE(law->name(), nu, size);
        CHECK((law->updated(none, u, identity + u) - hooke).norm() <= 50.0 * law->wave_modulus() * size * size);
      }
    }
  }
}

TEST_CASE("uniaxial strain: closed forms of the stress", "[engine][large_strain]") {
  const double e = 3.0, nu = 0.3;
  const double lambda = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const double mu = e / (2.0 * (1.0 + nu));
  for (const double d : {0.2, 0.7, 1.0, 1.9, 5.0}) {
    const Mat2 stretch = matrix(d, 0.0, 0.0, 1.0);
    const Stress linear = linear_large(e, nu)->updated(none, stretch - identity, stretch);
    CHECK_THAT(linear[0], WithinAbs((lambda + 2.0 * mu) * (d - 1.0), 1e-14));
    CHECK_THAT(linear[1], WithinAbs(lambda * (d - 1.0), 1e-14));
    CHECK_THAT(linear[3], WithinAbs(lambda * (d - 1.0), 1e-14));

    const Stress neo = neo_hookean(e, 0.0)->updated(none, stretch - identity, stretch);
    CHECK_THAT(neo[0], WithinAbs(0.5 * e * (d - 1.0 / d), 1e-14));  // λ = 0, μ = E/2
    CHECK_THAT(neo.tail<3>().norm(), WithinAbs(0.0, 1e-14));

    // J σ' + J' σ = E J' has this solution, and a step of any size meets it
    const Stress hypo = hypoelastic(e, 0.0)->updated(none, stretch - identity, stretch);
    CHECK_THAT(hypo[0], WithinAbs(e * (1.0 - 1.0 / d), 1e-14));
    CHECK_THAT(hypo.tail<3>().norm(), WithinAbs(0.0, 1e-14));
  }
}

TEST_CASE("a hypoelastic bar that is stretched and let back in other steps is without stress again",
          "[engine][large_strain]") {
  const Law law = hypoelastic(1.0, 0.0);
  State state = after(*law, matrix(0.1, 0.0, 0.0, 0.0), 5);
  const double back = std::pow(state.d(0, 0), -1.0 / 40.0) - 1.0;
  for (int k = 0; k < 40; ++k) state.stress = law->updated(state.stress, matrix(back, 0.0, 0.0, 0.0), identity);
  CHECK_THAT(state.stress.norm(), WithinAbs(0.0, 1e-14));
}

TEST_CASE("simple shear by 1: D grows with the whole velocity gradient", "[engine][large_strain]") {
  const Law law = neo_hookean(2.0, 0.0);  // μ = 1, λ = 0
  const Mat2 rate = matrix(0.0, 1.0, 0.0, 0.0);
  const State whole = after(*law, 1e-3 * rate, 1000);
  CHECK_THAT((whole.stress - Stress(1.0, 0.0, 1.0, 0.0)).norm(), WithinAbs(0.0, 1e-12));

  // the symmetric part alone, as eq. 22 of de Koster et al. is printed: stretch by e^½ along the diagonal
  const State symmetric = after(*law, 1e-5 * 0.5 * (rate + rate.transpose()), 100000);
  CHECK_THAT((symmetric.stress - Stress(0.543, 0.543, 1.175, 0.0)).norm(), WithinAbs(0.0, 1e-3));
}

TEST_CASE("simple shear of a hypoelastic body oscillates with Jaumann's rate, met with order 2 in the step",
          "[engine][large_strain]") {
  const double mu = 0.4, shear = 2.0;
  const Law law = hypoelastic(2.0 * mu * 1.3, 0.3);
  const Stress exact(mu * (1.0 - std::cos(shear)), -mu * (1.0 - std::cos(shear)), mu * std::sin(shear), 0.0);
  const auto error = [&](int steps) {
    return (after(*law, matrix(0.0, shear / steps, 0.0, 0.0), steps).stress - exact).norm();
  };
  CHECK(error(100) < 1e-4);
  CHECK_THAT(std::log2(error(50) / error(100)), WithinAbs(2.0, 0.05));
}

TEST_CASE("pure change of volume: closed forms of the pressure", "[engine][large_strain]") {
  const double e = 3.0, nu = 0.3;
  const double lambda = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const double mu = e / (2.0 * (1.0 + nu));
  for (const double s : {0.6, 1.5}) {
    const double j = s * s;
    const auto close_to = [&](const Stress& stress, double in_plane, double out_of_plane, double tolerance) {
      CHECK_THAT((stress - Stress(in_plane, in_plane, 0.0, out_of_plane)).norm(), WithinAbs(0.0, tolerance));
    };
    const Mat2 d = s * identity;
    close_to(linear_large(e, nu)->updated(none, d - identity, d), 2.0 * (lambda + mu) * (s - 1.0),
             2.0 * lambda * (s - 1.0), 1e-14);
    const double neo = lambda * std::log(j) / j;
    close_to(neo_hookean(e, nu)->updated(none, d - identity, d), neo + mu / j * (j - 1.0), neo, 1e-14);
    const auto hypo = [&](int steps) {
      return after(*hypoelastic(e, nu), (std::pow(s, 1.0 / steps) - 1.0) * identity, steps).stress;
    };
    const auto error = [&](int steps) {
      const Stress stress = hypo(steps);
      return std::hypot(stress[0] - (lambda + mu) * (1.0 - 1.0 / j), stress[3] - lambda * (1.0 - 1.0 / j));
    };
    close_to(hypo(1000), (lambda + mu) * (1.0 - 1.0 / j), lambda * (1.0 - 1.0 / j), 1e-5);
    CHECK_THAT(std::log2(error(20) / error(40)), WithinAbs(2.0, 0.05));
  }
}

TEST_CASE("a finite rotation turns the stress of an objective law and changes nothing else", "[engine][large_strain]") {
  test::Random random(4);
  for (int draw = 0; draw < 20; ++draw) {
    const Mat2 r = rotation(random.uniform(-2.5, 2.5));
    const Mat2 d = identity + random_matrix(random, 0.3);
    for (const Law& law : every_law(2.0, 0.25)) {
      CAPTURE(law->name());
      const Stress before = law->updated(none, d - identity, d);
      const Stress expected = turned(r, before);
      const Stress rotated = law->updated(before, r - identity, r * d);
      if (law->objective()) {
        CHECK((rotated - expected).norm() <= 1e-12 * before.norm());
        CHECK_THAT(law->energy(rotated, r * d), WithinRel(law->energy(before, d), 1e-12));
      } else {
        CHECK((rotated - expected).norm() > 1e-3 * before.norm());
      }
    }
  }
}

TEST_CASE("the linear law takes a rotation for the strain (cos - 1) I, and says so", "[engine][large_strain]") {
  const Law law = linear_large(2.0, 0.0);
  CHECK_FALSE(law->objective());
  const Mat2 r = rotation(0.7);
  const double strain = std::cos(0.7) - 1.0;
  CHECK_THAT((law->updated(none, r - identity, r) - 2.0 * Stress(strain, strain, 0.0, 0.0)).norm(),
             WithinAbs(0.0, 1e-14));
}

TEST_CASE("what stress works is stored: dW = J sigma : L", "[engine][large_strain]") {
  test::Random random(5);
  const Law neo = neo_hookean(2.0, 0.3);
  const Law linear = linear_large(2.0, 0.3);
  for (int draw = 0; draw < 30; ++draw) {
    const Mat2 l = random_matrix(random, 1.0);
    const Mat2 d = identity + random_matrix(random, 0.4);
    CHECK_THAT(energy_slope(*neo, d, l), WithinAbs(power(neo->updated(none, l, d), d, l), 1e-8));
    // the linear law: where D is uniaxial, and in the limit of small strains
    const Mat2 stretch = matrix(random.uniform(0.3, 2.0), 0.0, 0.0, 1.0);
    const Mat2 along = matrix(random.uniform(-1.0, 1.0), 0.0, 0.0, 0.0);
    CHECK_THAT(energy_slope(*linear, stretch, along),
               WithinAbs(power(linear->updated(none, along, stretch), stretch, along), 1e-8));
    const Mat2 small = identity + 1e-4 * (d - identity);
    const double work = power(linear->updated(none, l, small), small, l);
    CHECK_THAT(energy_slope(*linear, small, l), WithinAbs(work, 1e-7));
  }
}

TEST_CASE("the energy of a hypoelastic body is that of its stress, half of stress times strain where that is small",
          "[engine][large_strain]") {
  test::Random random(6);
  const Law law = hypoelastic(2.0, 0.3);
  for (int draw = 0; draw < 30; ++draw) {
    const Mat2 u = 1e-5 * random_matrix(random, 1.0);
    const Stress stress = law->updated(none, u, identity + u);
    CHECK_THAT(law->energy(stress, identity + u), WithinRel(0.5 * tensor(stress).cwiseProduct(u).sum(), 1e-3));
  }
}

TEST_CASE("waves travel by lambda + 2 mu, and laws know their names", "[engine][large_strain]") {
  const std::vector<Law> laws = every_law(2.0, 0.25);
  for (const Law& law : laws) CHECK_THAT(law->wave_modulus(), WithinRel(2.4, 1e-14));
  CHECK(laws[0]->name() == "linear_large");
  CHECK(laws[1]->name() == "neo_hookean");
  CHECK(laws[2]->name() == "hypoelastic");
}

TEST_CASE("constants that no large-strain law has are refused with the value", "[engine][large_strain]") {
  for (const auto make : {linear_large, neo_hookean, hypoelastic}) {
    CHECK_THROWS_WITH(make(0.0, 0.3), Contains("Young's modulus") && Contains("got 0.0"));
    CHECK_THROWS_WITH(make(-2.5, 0.3), Contains("got -2.5"));
    CHECK_THROWS_AS(make(NAN, 0.3), InvalidArgument);
    CHECK_THROWS_AS(make(INFINITY, 0.3), InvalidArgument);
    CHECK_THROWS_WITH(make(1.0, 0.5), Contains("Poisson's ratio") && Contains("got 0.5"));
    CHECK_THROWS_WITH(make(1.0, -1.0), Contains("got -1.0"));
    CHECK_THROWS_AS(make(1.0, NAN), InvalidArgument);
    CHECK_NOTHROW(make(1.0, 0.0));
  }
}
