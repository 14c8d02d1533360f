// Lattices of material points in triangles.
#include <algorithm>
#include <catch2/catch.hpp>

#include "../bases/meshes.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "shoreline/boundary/triangle_moments.hpp"
#include "shoreline/engine/fill.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// A disc with a hole, in a mesh of [0, 6]².
std::vector<SplineCurve> drilled_disc(test::Random& random) {
  const Vec2 centre = random.vector(2.7, 3.3);
  return {fit_spline(circle(centre, random.uniform(1.5, 2.5), 12, false)),
          fit_spline(circle(centre + random.vector(-0.3, 0.3), random.uniform(0.2, 1.0), 9, true))};
}

TriangleGrid whole_triangles(test::Random& random) {
  return TriangleGrid(delaunay(test::jittered_points(6, 6, random)));
}

TriangleGrid split_triangles(test::Random& random) {
  return TriangleGrid(powell_sabin_refinement(delaunay(test::jittered_points(6, 6, random))), powell_sabin_parts);
}

Vec2 centroid(const std::array<Vec2, 3>& p) { return (p[0] + p[1] + p[2]) / 3.0; }

}  // namespace

TEST_CASE("clipped points in triangles sum to the area of the body, about the body's centroid",
          "[engine][fill_triangles]") {
  test::Random random(1);
  for (int draw = 0; draw < 30; ++draw) {
    const std::vector<SplineCurve> curves = drilled_disc(random);
    const double area = Region(curves).area();
    std::vector<Vec2> centre;
    for (const TriangleGrid& grid : {whole_triangles(random), split_triangles(random)})
      for (const int n : {1, 2, 3}) {
        const MaterialPoints points = fill_lattice(curves, grid, {{n, n}, VolumeRule::clipped});
        CHECK(points.volume.minCoeff() > 0.0);
        CHECK_THAT(points.volume.sum(), WithinRel(area, 1e-12));
        centre.emplace_back(points.position * points.volume / area);
        CHECK_THAT((centre.back() - centre.front()).norm(), WithinAbs(0.0, 1e-12));
      }
  }
}

TEST_CASE("a triangle within the body has k² points, or about as many in its six parts", "[engine][fill_triangles]") {
  const std::vector<SplineCurve> all{fit_spline(line({0, 0}, {6, 0})), fit_spline(line({6, 0}, {6, 6})),
                                     fit_spline(line({6, 6}, {0, 6})), fit_spline(line({0, 6}, {0, 0}))};
  test::Random random(2);
  const TriangleMesh mesh = delaunay(test::jittered_points(6, 6, random));
  const auto triangles = static_cast<Index>(mesh.triangle.size());
  for (const int n : {1, 2, 3, 4}) {
    const LatticeFill fill{{n, n}, VolumeRule::clipped};
    CHECK(fill_lattice(all, TriangleGrid(mesh), fill).size() == n * n * triangles);
    const TriangleGrid split(powell_sabin_refinement(mesh), powell_sabin_parts);
    const int half = (n + 1) / 2;
    CHECK(fill_lattice(all, split, fill).size() == 6 * half * half * triangles);
  }
}

TEST_CASE("the lattice rule has the whole sub-cell of a triangle at each centroid inside", "[engine][fill_triangles]") {
  test::Random random(3);
  for (int draw = 0; draw < 10; ++draw) {
    const std::vector<SplineCurve> curves = drilled_disc(random);
    const Region region(curves);
    for (const TriangleGrid& grid : {whole_triangles(random), split_triangles(random)}) {
      const MaterialPoints points = fill_lattice(curves, grid, {{3, 3}, VolumeRule::lattice});
      const int divisions = grid.parts() == 1 ? 3 : 2;
      Index p = 0;
      for (Index number = 0; number < grid.cells() * divisions * divisions; ++number) {
        const auto corner = sub_cell(grid, divisions, number);
        if (!region.contains(centroid(corner))) continue;
        REQUIRE(p < points.size());
        CHECK((points.position.col(p) - centroid(corner)).norm() < 1e-14);
        CHECK_THAT(points.volume[p++], WithinRel(0.5 * twice_area(corner[0], corner[1], corner[2]), 1e-12));
      }
      CHECK(p == points.size());

      const MaterialPoints equal = fill_lattice(curves, grid, {{3, 3}, VolumeRule::equal});
      CHECK(equal.position == points.position);
      CHECK_THAT(equal.volume.sum(), WithinRel(region.area(), 1e-12));
      CHECK(equal.volume.minCoeff() == equal.volume.maxCoeff());
    }
  }
}

TEST_CASE("a lattice that triangles cannot have is refused with what was asked for", "[engine][fill_triangles]") {
  test::Random random(4);
  CHECK_THROWS_WITH(fill_lattice(drilled_disc(random), whole_triangles(random), {{2, 3}, VolumeRule::clipped}),
                    Contains("2 x 3") && Contains("one number"));
}

TEST_CASE("a body that reaches over a hole of its mesh is refused with both areas", "[engine][fill_triangles]") {
  const TriangleMesh holed =
      test::without(test::lattice(6, 6, TrianglePattern::diagonal), [](Index t) { return t / 2 == 14; });
  const std::vector<SplineCurve> disc{fit_spline(circle({2.5, 2.5}, 2.0, 24, false))};
  for (const VolumeRule volumes : {VolumeRule::clipped, VolumeRule::lattice})
    CHECK_THROWS_WITH(fill_lattice(disc, TriangleGrid(holed), {{2, 2}, volumes}),
                      Contains("11.5") && Contains("12.5") && Contains("triangles"));
}
