#include "shoreline/bases/powell_sabin_refinement.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "meshes.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double distance_to_line(const Vec2& a, const Vec2& b, const Vec2& x) { return cross((b - a).normalized(), x - a); }

}  // namespace

TEST_CASE("six sub-triangles fill each triangle, all are counter-clockwise", "[bases][powell_sabin_refinement]") {
  test::Random random(1);
  for (int draw = 0; draw < 5; ++draw)
    for (const auto& [name, main] : test::meshes(random)) {
      CAPTURE(name);
      const TriangleMesh refined = powell_sabin_refinement(main);
      CHECK_NOTHROW(check(refined, 0.0));
      for (Index t = 0; t < static_cast<Index>(main.triangle.size()); ++t) {
        const auto [a, b, c] = corners(main, t);
        double sum = 0.0;
        for (Index part = 6 * t; part < 6 * t + 6; ++part) {
          const auto [p, q, r] = corners(refined, part);
          CHECK(twice_area(p, q, r) > 0.0);
          sum += twice_area(p, q, r);
        }
        CHECK_THAT(sum, WithinRel(twice_area(a, b, c), 1e-10));
      }
    }
}

TEST_CASE("the centre of a triangle is equally far from its edges", "[bases][powell_sabin_refinement]") {
  test::Random random(2);
  for (const auto& [name, main] : test::meshes(random)) {
    const TriangleMesh refined = powell_sabin_refinement(main);
    for (Index t = 0; t < static_cast<Index>(main.triangle.size()); ++t) {
      const auto p = corners(main, t);
      const Vec2& z = refined.vertex[main.vertex.size() + static_cast<std::size_t>(t)];
      const double radius = distance_to_line(p[0], p[1], z);
      CHECK(radius > 0.0);
      CHECK_THAT(distance_to_line(p[1], p[2], z), WithinAbs(radius, 1e-13));
      CHECK_THAT(distance_to_line(p[2], p[0], z), WithinAbs(radius, 1e-13));
    }
  }
}

TEST_CASE("a point on an edge is between its ends and in line with both centres, or the middle of a border edge",
          "[bases][powell_sabin_refinement]") {
  test::Random random(3);
  for (const auto& [name, main] : test::meshes(random)) {
    CAPTURE(name);
    const TriangleMesh refined = powell_sabin_refinement(main);
    const auto neighbour = neighbours(main);
    const auto centre = [&](Index t) { return refined.vertex[main.vertex.size() + static_cast<std::size_t>(t)]; };
    for (Index t = 0; t < static_cast<Index>(main.triangle.size()); ++t)
      for (Index k = 0; k < 3; ++k) {
        const auto side = static_cast<std::size_t>(k);
        const Vec2 a = corners(main, t)[side];
        const Vec2 b = corners(main, t)[(side + 1) % 3];
        const Vec2 r = corners(refined, 6 * t + 2 * k)[1];
        const double along = (r - a).dot(b - a) / (b - a).squaredNorm();
        CHECK_THAT(distance_to_line(a, b, r), WithinAbs(0.0, 1e-14));
        if (const Index other = neighbour[static_cast<std::size_t>(t)][side]; other >= 0) {
          CHECK(along > 0.0);
          CHECK(along < 1.0);
          CHECK_THAT(distance_to_line(centre(t), centre(other), r), WithinAbs(0.0, 1e-12));
        } else {
          CHECK_THAT(along, WithinAbs(0.5, 1e-12));
        }
      }
  }
}

TEST_CASE("sub-triangles are numbered around the corners of their main triangle", "[bases][powell_sabin_refinement]") {
  test::Random random(4);
  for (const auto& [name, main] : test::meshes(random)) {
    const TriangleMesh refined = powell_sabin_refinement(main);
    const auto vertices = static_cast<Index>(main.vertex.size());
    const auto triangles = static_cast<Index>(main.triangle.size());
    CHECK(std::equal(main.vertex.begin(), main.vertex.end(), refined.vertex.begin()));
    REQUIRE(refined.triangle.size() == 6 * main.triangle.size());
    for (Index t = 0; t < triangles; ++t)
      for (Index k = 0; k < 3; ++k) {
        const auto& after = refined.triangle[static_cast<std::size_t>(6 * t + 2 * k)];
        const auto& before = refined.triangle[static_cast<std::size_t>(6 * t + 2 * k + 1)];
        const auto& next = refined.triangle[static_cast<std::size_t>(6 * t + (2 * k + 3) % 6)];
        CHECK(after[0] == main.triangle[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)]);
        CHECK(before[0] == after[0]);
        CHECK(after[2] == vertices + t);
        CHECK(before[1] == vertices + t);
        CHECK(after[1] >= vertices + triangles);
        CHECK(next[2] == after[1]);  // the other half of the edge
      }
  }
}
