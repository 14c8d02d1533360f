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

TEST_CASE("a curve that is off by a uniform offset errs by offset times root of length", "[engine][error_norms]") {
  const Vec2 offset(3e-3, -4e-3);
  const ExactSolution rest = uniform(Vec2::Zero(), Vec3::Zero());
  const Piece straight = line({0.0, 0.0}, {3.0, 0.0}, 4);
  Piece moved = straight;
  for (Vec2& x : moved.points) x += offset;
  const SplineCurve before = fit_spline(straight);
  const SplineCurve now = fit_spline(moved);
  CHECK_THAT(boundary_error(before, now, false, rest, 1.0), WithinRel(5e-3 * std::sqrt(3.0), 1e-12));
  CHECK_THAT(boundary_error(before, now, true, rest, 1.0), WithinRel(4e-3 * std::sqrt(3.0), 1e-12));
  CHECK_THAT(boundary_error(before, now, false, uniform(2.0 * offset, Vec3::Zero()), 0.5), WithinAbs(0.0, 1e-15));
}

TEST_CASE("on a curved piece a roller's error is that across it", "[engine][error_norms]") {
  const ExactSolution rest = uniform(Vec2::Zero(), Vec3::Zero());
  const SplineCurve before = fit_spline(circle(Vec2::Zero(), 1.0, 64, false));
  const SplineCurve now = fit_spline(circle(Vec2(1e-3, 0.0), 1.0, 64, false));
  // |n·e| of a unit offset has mean square ½ around a circle
  CHECK_THAT(boundary_error(before, now, true, rest, 1.0), WithinRel(1e-3 * std::sqrt(std::numbers::pi), 1e-4));
  CHECK_THAT(boundary_error(before, now, false, rest, 1.0), WithinRel(1e-3 * std::sqrt(2.0 * std::numbers::pi), 1e-4));
}
