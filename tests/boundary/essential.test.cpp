#include "shoreline/boundary/essential.hpp"

#include <catch2/catch.hpp>

#include "../random.hpp"
#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/quadrature.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Everything that an essential condition meets at one boundary point.
struct Draw {
  Support support;
  Vec2 normal;
  Mat3 tangent;  ///< isotropic: λ or λ̄, and μ
  double lambda;
  double mu;
  double width;
};

Draw random_draw(test::Random& random) {
  const BilinearBasis basis(random.grid());
  const Vec2 x = random.in(basis.grid().bounds());
  const double poissons_ratio = random.uniform(-0.5, 0.49);
  const double mu = random.uniform(1.0, 10.0);
  double lambda = 2.0 * mu * poissons_ratio / (1.0 - 2.0 * poissons_ratio);
  if (random.whole(0, 1) == 1) lambda = 2.0 * lambda * mu / (lambda + 2.0 * mu);  // plane stress
  Mat3 tangent;
  tangent << lambda + 2.0 * mu, lambda, 0.0, lambda, lambda + 2.0 * mu, 0.0, 0.0, 0.0, mu;
  const Index cell = basis.grid().locate(x, 0).value();
  return {basis.support(cell, x), random.direction(), tangent, lambda, mu, random.uniform(0.1, 2.0)};
}

/// Turns a Voigt strain into the frame (n, t), t = (n_y, −n_x).
Mat3 rotation(const Vec2& n) {
  const double c = n.x();
  const double s = n.y();
  Mat3 turn;
  turn << c * c, s * s, c * s, s * s, c * c, -c * s, 2 * c * s, -2 * c * s, s * s - c * c;
  return turn;
}

/// The stiffness of a boundary point, ∫_0^δ B̄ᵀ C B̄ dφ, with the strain B̄ d of D P u + (I − P) u in the frame (n, t):
/// of ε(u) (D everywhere, as the method has it) and of sym(P u ⊗ ∇D), ∇D = D' n; less its part ∫ D² Bᵀ C B dφ.
Eigen::MatrixXd across_the_band(const Draw& draw, bool normal_only) {
  const Eigen::Index n = draw.support.value.size();
  const Vec2 frame_normal = Vec2::UnitX();
  Eigen::MatrixXd m(2, 2 * n);  // displacement in the frame
  Mat2 axes;
  axes << draw.normal.x(), draw.normal.y(), draw.normal.y(), -draw.normal.x();
  for (Eigen::Index a = 0; a < n; ++a) m.middleCols<2>(2 * a) = draw.support.value[a] * axes;
  if (normal_only) m.row(1).setZero();
  Eigen::Matrix<double, 3, 2> gradient_of_d;  // sym(u ⊗ n) in Voigt order
  gradient_of_d << frame_normal.x(), 0.0, 0.0, frame_normal.y(), frame_normal.y(), frame_normal.x();
  const Eigen::MatrixXd b = rotation(draw.normal) * strain_operator(draw.support.gradient);

  const QuadratureRule rule = gauss(4);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for (Eigen::Index q = 0; q < rule.point.size(); ++q) {
    const double depth = rule.point[q] * draw.width;
    const Eigen::MatrixXd b1 = d_function(depth, draw.width) * b;
    const Eigen::MatrixXd b2 = d_function_slope(depth, draw.width) * gradient_of_d * m;
    sum += rule.weight[q] * draw.width *
           ((b1 + b2).transpose() * draw.tangent * (b1 + b2) - b1.transpose() * draw.tangent * b1);
  }
  return sum;
}

}  // namespace

TEST_CASE("D rises from 0 on the boundary to 1 at the end of the band, and stays", "[boundary][essential]") {
  for (const double width : {1e-9, 0.3, 7.0}) {
    CHECK(d_function(0.0, width) == 0.0);
    CHECK(d_function(width, width) == 1.0);
    CHECK(d_function(5.0 * width, width) == 1.0);
    CHECK(d_function(-width, width) == 0.0);
    CHECK(d_function_slope(width, width) == 0.0);
    CHECK(d_function_slope(2.0 * width, width) == 0.0);
    CHECK(d_function_slope(-0.1 * width, width) == 0.0);
  }
}

TEST_CASE("the slope of D matches a finite difference", "[boundary][essential]") {
  test::Random random(1);
  for (int draw = 0; draw < 100; ++draw) {
    const double width = random.uniform(0.1, 10.0);
    const double depth = random.uniform(0.01, 1.5) * width;
    const double step = 1e-6 * width;
    if (std::abs(depth - width) < 2.0 * step) continue;
    const double difference = (d_function(depth + step, width) - d_function(depth - step, width)) / (2.0 * step);
    CHECK_THAT(d_function_slope(depth, width) * width, WithinAbs(difference * width, 1e-8));
  }
}

TEST_CASE("the band's two numbers are integrals of D across it", "[boundary][essential]") {
  const QuadratureRule rule = gauss(3);
  for (const double width : {1e-6, 0.25, 3.0}) {
    double share = 0.0;
    double penalty = 0.0;
    for (Eigen::Index q = 0; q < 3; ++q) {
      const double slope = d_function_slope(rule.point[q] * width, width);
      share += width * rule.weight[q] * d_function(rule.point[q] * width, width) * slope;
      penalty += width * rule.weight[q] * slope * slope;
    }
    const BandIntegrals band = band_integrals(EssentialMethod::implicit_boundary, width);
    CHECK_THAT(band.share, WithinRel(share, 1e-13));
    CHECK_THAT(band.penalty, WithinRel(penalty, 1e-13));
    CHECK(band_integrals(EssentialMethod::nitsche, width).share == 1.0);  // consistent: the whole traction
    CHECK(band_integrals(EssentialMethod::nitsche, width).penalty == band.penalty);
  }
}

TEST_CASE("the closed forms are the integrals of the stiffness across the band", "[boundary][essential]") {
  test::Random random(2);
  for (int k = 0; k < 100; ++k) {
    const Draw draw = random_draw(random);
    for (const bool normal_only : {false, true}) {
      const EdgeOperators o = edge_operators(draw.support, draw.normal, draw.tangent, normal_only);
      const BandIntegrals band = band_integrals(EssentialMethod::implicit_boundary, draw.width);
      const Eigen::MatrixXd k2 = band.share * o.traction.transpose() * o.displacement;
      const Eigen::MatrixXd k3 = band.penalty * o.displacement.transpose() * o.stiffness * o.displacement;
      const Eigen::MatrixXd integrated = across_the_band(draw, normal_only);
      CHECK((k2 + k2.transpose() + k3 - integrated).norm() <= 1e-12 * integrated.norm());
    }
  }
}

TEST_CASE("a fixed point resists with C_nn along the normal and G across it, a roller along it alone",
          "[boundary][essential]") {
  test::Random random(3);
  for (int k = 0; k < 100; ++k) {
    const Draw draw = random_draw(random);
    const Vec2 tangent(-draw.normal.y(), draw.normal.x());
    const Mat2 along = (draw.lambda + 2.0 * draw.mu) * draw.normal * draw.normal.transpose();
    const Mat2 across = draw.mu * tangent * tangent.transpose();
    const EdgeOperators fixed = edge_operators(draw.support, draw.normal, draw.tangent, false);
    const EdgeOperators roller = edge_operators(draw.support, draw.normal, draw.tangent, true);
    CHECK((fixed.stiffness - along - across).norm() <= 1e-13 * along.norm());
    CHECK((roller.stiffness - along).norm() <= 1e-13 * along.norm());
    CHECK((tangent.transpose() * roller.traction).norm() <= 1e-13 * roller.traction.norm());
    CHECK((tangent.transpose() * roller.displacement).norm() <= 1e-13);
  }
}

TEST_CASE("edge operators give displacement and traction of a linear field", "[boundary][essential]") {
  test::Random random(4);
  for (int k = 0; k < 100; ++k) {
    const BilinearBasis basis(random.grid());
    const Draw draw = random_draw(random);
    const Vec2 x = random.in(basis.grid().bounds());
    const Support support = basis.support(basis.grid().locate(x, 0).value(), x);
    Mat2 gradient;
    gradient << random.vector(), random.vector();
    Eigen::VectorXd d(8);
    for (Eigen::Index a = 0; a < 4; ++a) d.segment<2>(2 * a) = gradient * basis.control_point(support.function[a]);

    const Mat2 strain = 0.5 * (gradient + gradient.transpose());
    const Mat2 stress = draw.lambda * strain.trace() * Mat2::Identity() + 2.0 * draw.mu * strain;
    const EdgeOperators o = edge_operators(support, draw.normal, draw.tangent, false);
    CHECK_THAT((o.displacement * d - gradient * x).norm(), WithinAbs(0.0, 1e-12));
    CHECK_THAT((o.traction * d - stress * draw.normal).norm() / draw.tangent.norm(), WithinAbs(0.0, 1e-11));
    const Vec3 voigt(strain(0, 0), strain(1, 1), 2.0 * strain(0, 1));
    CHECK_THAT((strain_operator(support.gradient) * d - voigt).norm(), WithinAbs(0.0, 1e-11));
  }
}

TEST_CASE("the stiffness of a roller is normal and symmetric for every symmetric law", "[boundary][essential]") {
  test::Random random(5);
  for (int k = 0; k < 20; ++k) {
    const Draw draw = random_draw(random);
    const Vec2 across(-draw.normal.y(), draw.normal.x());
    Mat3 half = Mat3::Zero();
    for (double& entry : half.reshaped()) entry = random.uniform(-1.0, 1.0);
    const Mat2 stiffness = edge_operators(draw.support, draw.normal, half + half.transpose(), true).stiffness;
    CHECK_THAT((stiffness - stiffness.transpose()).norm(), WithinAbs(0.0, 1e-14));
    CHECK_THAT((stiffness * across).norm(), WithinAbs(0.0, 1e-14));
  }
}
