// Polar lattices of material points.
#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "../random.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "shoreline/engine/fill.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// inner <= r <= outer between two angles [°], or all around.
struct Ring {
  Vec2 centre = Vec2::Zero();
  double inner = 2.0;
  double outer = 5.0;
  double from = 0.0;
  double to = 90.0;
  int points = 17;

  [[nodiscard]] double sweep() const { return (to - from) * std::numbers::pi / 180.0; }
  [[nodiscard]] double area() const { return 0.5 * (outer * outer - inner * inner) * sweep(); }
  [[nodiscard]] std::vector<SplineCurve> curves() const {
    if (to - from == 360.0)
      return {fit_spline(circle(centre, outer, points, false)), fit_spline(circle(centre, inner, points, true))};
    const Piece outside = arc(centre, outer, from, to, points);
    const Piece inside = arc(centre, inner, to, from, points);
    return {fit_spline(outside), fit_spline(line(outside.points.back(), inside.points.front(), 4)), fit_spline(inside),
            fit_spline(line(inside.points.back(), outside.points.front()))};
  }
};

const std::vector<Ring> rings = {{},
                                 {.centre = Vec2(0.3, -0.2), .from = 30.0, .to = 210.0, .points = 33},
                                 {.inner = 0.5, .outer = 0.8, .from = -100.0, .to = 190.0, .points = 40},
                                 {.centre = Vec2(-1.0, 4.0), .to = 360.0, .points = 48}};

}  // namespace

TEST_CASE("volumes of a polar lattice sum to the area of the sector", "[engine][fill]") {
  for (const Ring& ring : rings)
    for (const std::array<int, 2> across : {std::array{2, 3}, std::array{5, 4}, std::array{40, 70}}) {
      const MaterialPoints points = fill_polar(ring.curves(), {ring.centre, across});
      REQUIRE(points.size() == across[0] * across[1]);
      CHECK(points.volume.minCoeff() > 0.0);
      CHECK_THAT(points.volume.sum(), WithinRel(ring.area(), 1e-13));
      const MaterialPoints equal = fill_polar(ring.curves(), {ring.centre, across, VolumeRule::equal});
      CHECK(equal.position == points.position);
      CHECK(equal.volume.minCoeff() == equal.volume.maxCoeff());
      CHECK_THAT(equal.volume.sum(), WithinRel(ring.area(), 1e-13));
    }
}

TEST_CASE("a polar lattice integrates moments with order two", "[engine][fill][convergence]") {
  for (const Ring& ring : rings) {
    const double a = ring.from * std::numbers::pi / 180.0;
    const double b = ring.to * std::numbers::pi / 180.0;
    const double cubes = (std::pow(ring.outer, 3) - std::pow(ring.inner, 3)) / 3.0;
    const Vec2 first = cubes * Vec2(std::sin(b) - std::sin(a), std::cos(a) - std::cos(b)) + ring.area() * ring.centre;
    const double second = (std::pow(ring.outer, 4) - std::pow(ring.inner, 4)) / 4.0 * ring.sweep();  // ∫ r² dA
    std::vector<Vec3> error;
    for (const int n : {23, 45, 89}) {
      const MaterialPoints points = fill_polar(ring.curves(), {ring.centre, {n, 3 * n}});
      const Vec2 sum = points.position * points.volume - first;
      const auto radii = (points.position.colwise() - ring.centre).colwise().squaredNorm();
      error.emplace_back(sum.x(), sum.y(), radii.dot(points.volume) - second);
      CHECK(error.back().norm() < 4.0 / (n * n) * ring.area() * ring.outer * ring.outer);
    }
    CHECK_THAT(std::log2(std::abs(error[1][2] / error[2][2])), WithinAbs(2.0, 0.1));
    if (ring.to - ring.from < 360.0)  // over a full turn sums of sines vanish
      CHECK_THAT(std::log2(error[1].head<2>().norm() / error[2].head<2>().norm()), WithinAbs(2.0, 0.1));
  }
}

TEST_CASE("whole sub-cells of a polar lattice are r Δr Δθ", "[engine][fill]") {
  const Ring ring;
  const MaterialPoints points = fill_polar(ring.curves(), {ring.centre, {4, 4}, VolumeRule::lattice});
  for (Index p = 0; p < points.size(); ++p)
    CHECK_THAT(points.volume[p], WithinRel(points.position.col(p).norm() * 1.0 * std::numbers::pi / 6.0, 1e-12));
}

TEST_CASE("the outer layers of a polar lattice lie on the outline and are marked with the way in", "[engine][fill]") {
  for (const Ring& ring : rings) {
    const bool full = ring.to - ring.from == 360.0;
    const MaterialPoints points = fill_polar(ring.curves(), {ring.centre, {5, 9}});
    CHECK(points.on_outline.size() == (full ? 18U : 45U - 3U * 7U));
    const Ring shrunk{
        ring.centre, ring.inner + 1e-3, ring.outer - 1e-3, ring.from + (full ? 0.0 : 0.1), ring.to - (full ? 0.0 : 0.1),
        400};
    const Region inside(shrunk.curves());
    Index marked = 0;
    for (Index p = 0; p < points.size(); ++p) {
      const Vec2 x = points.position.col(p);
      const auto found = std::ranges::find(points.on_outline, p, &OutlinePoint::point);
      CHECK((found == points.on_outline.end()) == inside.contains(x));
      if (found == points.on_outline.end()) continue;
      ++marked;
      CHECK_THAT(found->inward.norm(), WithinAbs(1.0, 1e-14));
      CHECK(inside.contains(x + 0.05 * found->inward));
      CHECK_FALSE(inside.contains(x - 0.01 * found->inward));
    }
    CHECK(marked == static_cast<Index>(points.on_outline.size()));
  }
}

TEST_CASE("a body that is no sector of a ring about the centre is refused with what was found", "[engine][fill]") {
  const Ring ring;
  const auto polar = [](const std::vector<SplineCurve>& curves, const Vec2& centre = Vec2::Zero()) {
    return fill_polar(curves, {centre, {4, 4}});
  };
  CHECK_THROWS_WITH(polar(ring.curves(), {0.1, 0.0}), Contains("sector of a ring") && Contains("(0.1, 0)"));
  CHECK_THROWS_WITH(polar({fit_spline(circle({1.0, 1.0}, 0.5, 12, false))}, {1.0, 1.0}),
                    Contains("the radii of the outline go from 0.5 m to 0.5 m"));
  CHECK_THROWS_WITH(polar({fit_spline(line({0.0, 0.0}, {1.0, 0.0})), fit_spline(arc({0.0, 0.0}, 1.0, 0.0, 90.0, 5)),
                           fit_spline(line({0.0, 1.0}, {0.0, 0.0}))}),
                    Contains("from 0 m to 1 m"));

  std::vector<SplineCurve> bulged = ring.curves();
  bulged[1] = fit_spline({.name = "side", .points = {{0.0, 5.0}, {0.2, 3.0}, {0.0, 2.0}}});
  CHECK_THROWS_WITH(polar(bulged), Contains("(0.2, 3)") && Contains("radii 2 m and 5 m") && Contains("0° and 90°"));

  Ring coarse;
  coarse.points = 2;
  std::vector<SplineCurve> chords = coarse.curves();
  chords[0] = fit_spline(line({5.0, 0.0}, {0.0, 5.0}));  // the chord instead of the arc
  CHECK_THROWS_WITH(polar(chords), Contains("bounds") && Contains("16.4934 m²"));

  CHECK_THROWS_AS(fill_polar(ring.curves(), {Vec2::Zero(), {1, 4}}), InvalidArgument);
  CHECK_THROWS_WITH(fill_polar(rings.back().curves(), {rings.back().centre, {2, 2}}), Contains("3 along the angle"));
}
