// Random points in the body.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "../bases/meshes.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "shoreline/engine/fill.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;
using Volumes = RandomFill::Volumes;

namespace {

std::vector<SplineCurve> rectangle(const Vec2& lower, const Vec2& upper) {
  const Vec2 right(upper.x(), lower.y());
  const Vec2 left(lower.x(), upper.y());
  return {fit_spline(line(lower, right)), fit_spline(line(right, upper)), fit_spline(line(upper, left)),
          fit_spline(line(left, lower))};
}

/// A disc with a hole, in a grid of [0, 6]².
std::vector<SplineCurve> drilled_disc() {
  return {fit_spline(circle({3.1, 2.9}, 2.3, 12, false)), fit_spline(circle({3.0, 3.2}, 0.7, 9, true))};
}

QuadrilateralGrid rectangles() { return {{0, 0}, {0.5, 0.75}, {12, 8}}; }
TriangleMesh mesh() {
  test::Random random(1);
  return delaunay(test::jittered_points(6, 6, random));
}
TriangleGrid triangles() { return TriangleGrid(mesh()); }
TriangleGrid split_triangles() { return TriangleGrid(powell_sabin_refinement(mesh()), powell_sabin_parts); }

/// Points in each element.
std::vector<int> counts(const MaterialPoints& points, const Grid& grid) {
  std::vector<int> count(static_cast<std::size_t>(grid.cells() / grid.parts()), 0);
  for (Index p = 0; p < points.size(); ++p)
    ++count[static_cast<std::size_t>(grid.locate(points.position.col(p), 0).value() / grid.parts())];
  return count;
}

template <class Use>
void on_every_grid(Use&& use) {
  use(rectangles());
  use(triangles());
  use(split_triangles());
}

}  // namespace

TEST_CASE("random points lie inside, and their volumes sum to the area of the body", "[engine][fill_random]") {
  const std::vector<SplineCurve> curves = drilled_disc();
  const Region region(curves);
  on_every_grid([&](const auto& grid) {
    for (const int n : {1, 2, 7}) {
      const MaterialPoints points = fill_random(curves, grid, {.per_element = n});
      for (Index p = 0; p < points.size(); ++p) CHECK(region.contains(points.position.col(p)));
      CHECK(points.volume.minCoeff() > 0.0);
      CHECK_THAT(points.volume.sum(), WithinRel(region.area(), 1e-12));
      const MaterialPoints equal = fill_random(curves, grid, {.per_element = n, .volumes = Volumes::equal});
      CHECK(equal.position == points.position);
      CHECK(equal.volume.minCoeff() == equal.volume.maxCoeff());
      CHECK_THAT(equal.volume.sum(), WithinRel(region.area(), 1e-12));
    }
  });
}

TEST_CASE("the same seed gives the same points, another one others", "[engine][fill_random]") {
  on_every_grid([&](const auto& grid) {
    const auto position = [&](int seed) -> Eigen::Matrix2Xd {
      return fill_random(drilled_disc(), grid, {.per_element = 2, .seed = seed}).position;
    };
    CHECK(position(1) == position(1));
    const Eigen::Matrix2Xd one = position(1);
    const Eigen::Matrix2Xd other = position(2);
    REQUIRE(one.cols() == other.cols());
    CHECK((one - other).colwise().norm().minCoeff() > 0.0);
  });
}

TEST_CASE("random points are those that the standard's generator gives", "[engine][fill_random]") {
  // element 0 with seed 1: mt19937_64 of seed_seq{1, 0}, its upper 53 bits
  std::seed_seq sequence{1, 0};
  std::mt19937_64 engine(sequence);
  const QuadrilateralGrid cell({0, 0}, {1, 1}, {1, 1});
  const MaterialPoints points = fill_random(rectangle({0, 0}, {1, 1}), cell, {.per_element = 3});
  REQUIRE(points.size() == 3);
  for (Index p = 0; p < 3; ++p) {
    engine();  // the choice of a part
    const double x = static_cast<double>(engine() >> 11U) / 9007199254740992.0;
    const double y = static_cast<double>(engine() >> 11U) / 9007199254740992.0;
    CHECK(points.position.col(p) == Vec2(x, y));
  }
}

TEST_CASE("an element's points depend on its number, and on nothing beside it", "[engine][fill_random]") {
  const QuadrilateralGrid grid({0, 0}, {1, 1}, {4, 4});
  const MaterialPoints all = fill_random(rectangle({0, 0}, {4, 4}), grid, {.per_element = 3});
  for (Index p = 3; p < all.size(); ++p)  // three to a cell, none as in the first
    CHECK((all.position.col(p) - grid.corner(p / 3) - all.position.col(p % 3)).norm() > 1e-6);
  const MaterialPoints some = fill_random(rectangle({2, 1}, {4, 3}), grid, {.per_element = 3});
  REQUIRE(some.size() == 12);
  for (Index p = 0; p < some.size(); ++p)
    CHECK((all.position.colwise() - some.position.col(p)).colwise().norm().minCoeff() == 0.0);
}

TEST_CASE("an element has as many points as its covered part has of it, and one at least", "[engine][fill_random]") {
  const std::vector<SplineCurve> body = rectangle({0.0, 0.0}, {3.2, 1.0 + 1e-5});
  const QuadrilateralGrid grid({0, 0}, {1, 1}, {4, 2});
  const std::vector<int> count = counts(fill_random(body, grid, {.per_element = 10}), grid);
  CHECK(count == std::vector<int>{10, 10, 10, 2, 1, 1, 1, 1});  // slivers above, of 1e-5 of their cells
  const std::vector<SplineCurve> corner = rectangle({0.0, 0.0}, {3.0 + 9e-5, 1.0 + 9e-5});  // 8e-9 of the last cell
  CHECK(counts(fill_random(corner, grid, {.per_element = 10}), grid) == std::vector<int>{10, 10, 10, 1, 1, 1, 1, 0});

  const std::vector<SplineCurve> all = rectangle({0, 0}, {6, 6});
  for (const int n : {1, 5}) {
    const std::vector<int> whole(mesh().triangle.size(), n);
    CHECK(counts(fill_random(all, triangles(), {.per_element = n}), triangles()) == whole);
    CHECK(counts(fill_random(all, split_triangles(), {.per_element = n}), split_triangles()) == whole);
  }
}

TEST_CASE("a hole that leaves only the corners of an element leaves its points there", "[engine][fill_random]") {
  std::vector<SplineCurve> body = rectangle({0, 0}, {3, 3});
  body.push_back(fit_spline(circle({1.5, 1.5}, 0.7035, 64, true)));  // corners of the middle cell are 0.7071 off
  const QuadrilateralGrid grid({0, 0}, {1, 1}, {3, 3});
  const CellMoments covered = cell_moments(body, grid, 0);
  REQUIRE(covered.moment(0, 4) < 1e-4);  // its centroid is the centre of the hole
  REQUIRE(covered.moment(0, 4) > 2e-5);
  const MaterialPoints points = fill_random(body, grid, {.per_element = 4});
  CHECK(counts(points, grid)[4] == 1);
  const Region region(body);
  for (Index p = 0; p < points.size(); ++p) CHECK(region.contains(points.position.col(p)));
}

TEST_CASE("random points are uniform in the covered part of each element, to the error of a sample",
          "[engine][fill_random]") {
  const std::vector<SplineCurve> curves = drilled_disc();
  on_every_grid([&](const auto& grid) {
    const auto element = [&](const MaterialPoints& points, Index p) {
      return static_cast<std::size_t>(grid.locate(points.position.col(p), 0).value() / grid.parts());
    };
    std::vector<Vec3> exact(static_cast<std::size_t>(grid.cells() / grid.parts()), Vec3::Zero());  // ∫ {1, x, y} dA
    const MaterialPoints clipped = fill_lattice(curves, grid, LatticeFill{{1, 1}, VolumeRule::clipped});
    for (Index p = 0; p < clipped.size(); ++p)
      exact[element(clipped, p)] += clipped.volume[p] * Vec3(1.0, clipped.position(0, p), clipped.position(1, p));
    std::vector<Vec3> drawn(exact.size(), Vec3::Zero());
    const MaterialPoints points = fill_random(curves, grid, {.per_element = 1000});
    for (Index p = 0; p < points.size(); ++p)
      drawn[element(points, p)] += Vec3(1.0, points.position(0, p), points.position(1, p));
    for (std::size_t e = 0; e < exact.size(); ++e)
      if (drawn[e][0] > 5.0) {  // a coordinate deviates from its mean by a third of the size, at most
        const Vec2 error = drawn[e].tail<2>() / drawn[e][0] - exact[e].tail<2>() / exact[e][0];
        CHECK(error.norm() < 5.0 * 0.35 * 1.2 / std::sqrt(drawn[e][0]));
      }
  });
}

TEST_CASE("a body that reaches over a hole of its mesh holds no random points", "[engine][fill_random]") {
  const TriangleMesh holed =
      test::without(test::lattice(6, 6, TrianglePattern::diagonal), [](Index t) { return t / 2 == 14; });
  const std::vector<SplineCurve> disc{fit_spline(circle({2.5, 2.5}, 2.0, 24, false))};
  CHECK_THROWS_WITH(fill_random(disc, TriangleGrid(holed), {.per_element = 2}),
                    Contains("11.5") && Contains("12.5") && Contains("triangles"));
}
