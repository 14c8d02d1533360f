#include "shoreline/engine/error_norms.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

ExactSolution uniform(const Vec2& displacement, const Vec3& stress) {
  return {.displacement = [=](const Vec2&, double t) -> Vec2 { return t * displacement; },
          .stress = [=](const Vec2&, double t) -> Vec3 { return t * stress; }};
}

/// Two points of volumes 1 and 3.
MaterialPoints two_points() {
  MaterialPoints points = points_at(Eigen::Matrix2Xd::Zero(2, 2), Eigen::Vector2d(1.0, 3.0));
  points.displacement << 2.0, 2.5, 1.0, 1.0;
  points.stress << 10.0, 12.0, 5.0, 5.0, 0.0, 4.0, 0.0, 0.0;
  return points;
}

}  // namespace

TEST_CASE("means are weighted with volumes, and the largest error is not", "[engine][error_norms]") {
  const ErrorNorms norms = error_norms(two_points(), uniform(Vec2(4.0, 2.0), Vec3(20.0, 10.0, 4.0)), 0.5);
  CHECK(norms.places == 2);
  CHECK_THAT(norms.displacement[0].mean_absolute, WithinRel((1.0 * 0.0 + 3.0 * 0.5) / 4.0, 1e-15));
  CHECK_THAT(norms.displacement[0].mean_relative.value(), WithinRel((3.0 * 0.25) / 4.0, 1e-15));
  CHECK_THAT(norms.displacement[0].max_absolute, WithinRel(0.5, 1e-15));
  CHECK(norms.displacement[1].max_absolute == 0.0);
  CHECK_THAT(norms.stress[0].mean_relative.value(), WithinRel(3.0 * 0.2 / 4.0, 1e-15));
  CHECK_THAT(norms.stress[2].mean_absolute, WithinRel((1.0 * 2.0 + 3.0 * 2.0) / 4.0, 1e-15));
  CHECK(norms.stress[1].mean_relative.value() == 0.0);
}

TEST_CASE("L2 norms are those of the vectors (u, v) and (xx, yy, xy)", "[engine][error_norms]") {
  const ErrorNorms norms = error_norms(two_points(), uniform(Vec2(4.0, 2.0), Vec3(20.0, 10.0, 4.0)), 0.5);
  CHECK_THAT(norms.displacement_l2_relative.value(), WithinRel(std::sqrt(3.0 * 0.25 / (4.0 * 5.0)), 1e-14));
  CHECK_THAT(norms.stress_l2_relative.value(),
             WithinRel(std::sqrt((1.0 * 4.0 + 3.0 * (4.0 + 4.0)) / (4.0 * (100.0 + 25.0 + 4.0))), 1e-14));
}

TEST_CASE("an absolute L2 norm is the relative one times that of the exact solution, and stays where that vanishes",
          "[engine][error_norms]") {
  const ErrorNorms norms = error_norms(two_points(), uniform(Vec2(4.0, 2.0), Vec3(20.0, 10.0, 4.0)), 0.5);
  CHECK_THAT(norms.displacement_l2, WithinRel(*norms.displacement_l2_relative * std::sqrt(4.0 * 5.0), 1e-14));
  CHECK_THAT(norms.stress_l2, WithinRel(*norms.stress_l2_relative * std::sqrt(4.0 * (100.0 + 25.0 + 4.0)), 1e-14));
  const ErrorNorms of_zero = error_norms(two_points(), uniform(Vec2::Zero(), Vec3::Zero()), 0.5);
  CHECK_THAT(of_zero.displacement_l2, WithinRel(std::sqrt(1.0 * 5.0 + 3.0 * 7.25), 1e-14));
  CHECK_THAT(of_zero.stress_l2, WithinRel(std::sqrt(1.0 * 125.0 + 3.0 * (144.0 + 25.0 + 16.0)), 1e-14));
}

TEST_CASE("no relative error is formed where the exact value vanishes", "[engine][error_norms]") {
  const ErrorNorms norms = error_norms(two_points(), uniform(Vec2(4.0, 0.0), Vec3::Zero()), 1.0);
  CHECK(norms.displacement[0].mean_relative);
  CHECK_FALSE(norms.displacement[1].mean_relative);
  CHECK_THAT(norms.displacement[1].mean_absolute, WithinRel(1.0, 1e-15));
  CHECK(norms.displacement_l2_relative);
  CHECK_FALSE(norms.stress_l2_relative);
  for (const ErrorNorms::Component& component : norms.stress) CHECK_FALSE(component.mean_relative);
}

TEST_CASE("exact values are those at the original positions", "[engine][error_norms]") {
  MaterialPoints points = points_at(Eigen::Matrix2Xd::Zero(2, 1), Eigen::VectorXd::Ones(1));
  points.position.col(0) = Vec2(3.5, -1.0);
  points.displacement.col(0) = Vec2(0.5, 1.0);  // it came from (3, −2)
  const ExactSolution exact{.displacement = [](const Vec2& x, double) -> Vec2 { return x - Vec2(2.5, -3.0); },
                            .stress = [](const Vec2& x, double) -> Vec3 {
                              return {x.x(), x.y(), 0.0};
                            }};
  const ErrorNorms norms = error_norms(points, exact, 1.0);
  CHECK(norms.displacement_l2_relative.value() == 0.0);
  CHECK(norms.stress[0].mean_absolute == 3.0);
  CHECK(norms.stress[1].mean_absolute == 2.0);
}

TEST_CASE("the radius of a ring that grows as the exact one has no error, of another its difference",
          "[engine][error_norms]") {
  const ExactSolution grows{.displacement = [](const Vec2& x, double t) -> Vec2 { return t * 0.5 * x; }, .stress = {}};
  const Piece before = arc(Vec2::Zero(), 2.0, 90.0, 0.0, 33);
  const SplineCurve now = fit_spline(arc(Vec2::Zero(), 3.0, 90.0, 0.0, 33));
  const auto exact = radius_error(fit_spline(before), now, grows, 1.0);
  REQUIRE(exact);
  CHECK_THAT(exact->mean, WithinRel(3.0, 1e-6));
  CHECK_THAT(exact->exact, WithinRel(3.0, 1e-15));
  CHECK_THAT(exact->mean_relative, WithinAbs(0.0, 1e-6));
  const auto off = radius_error(fit_spline(before), now, grows, 0.6);
  CHECK_THAT(off->exact, WithinRel(2.6, 1e-15));
  CHECK_THAT(off->mean_relative, WithinRel(0.4 / 2.6, 1e-5));
}

TEST_CASE("a ring moved aside has the mean radius of a circle about a point off its centre", "[engine][error_norms]") {
  const ExactSolution rest = uniform(Vec2::Zero(), Vec3::Zero());
  const SplineCurve before = fit_spline(circle(Vec2::Zero(), 1.0, 64, false));
  const auto error = radius_error(before, fit_spline(circle(Vec2(0.01, 0.0), 1.0, 64, false)), rest, 1.0);
  REQUIRE(error);
  CHECK_THAT(error->mean, WithinRel(1.0 + 0.01 * 0.01 / 4.0, 1e-6));
  CHECK_THAT(error->mean_relative, WithinRel(0.01 * 2.0 / std::numbers::pi, 1e-3));  // mean |cos|
}

TEST_CASE("a piece that was no arc about the origin has no radius", "[engine][error_norms]") {
  const ExactSolution rest = uniform(Vec2::Zero(), Vec3::Zero());
  const auto measured = [&](const Piece& piece) {
    const SplineCurve curve = fit_spline(piece);
    return radius_error(curve, curve, rest, 1.0).has_value();
  };
  CHECK(measured(circle(Vec2::Zero(), 1.0, 16, true)));
  CHECK(measured(circle(Vec2(4e-4, 0.0), 1.0, 16, true)));
  CHECK_FALSE(measured(circle(Vec2(2e-3, 0.0), 1.0, 16, true)));
  CHECK_FALSE(measured(line({1.0, 0.0}, {2.0, 0.0}, 3)));
  CHECK_FALSE(measured(line({-1.0, 0.0}, {1.0, 0.0}, 3)));
}
