#include "shoreline/bases/triangle_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "meshes.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;

namespace {

/// Two triangles of a unit square: vertices 0, 1, 2, 3 counter-clockwise from the origin.
TriangleMesh square() { return {{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {{0, 1, 2}, {0, 2, 3}}}; }

}  // namespace

TEST_CASE("meshes of all kinds pass the check", "[bases][triangle_mesh]") {
  test::Random random(1);
  for (int draw = 0; draw < 10; ++draw)
    for (const auto& [name, mesh] : test::meshes(random)) {
      CAPTURE(name);
      CHECK_NOTHROW(check(mesh));
    }
}

TEST_CASE("neighbours see each other across the same two vertices, Euler's formula counts the edges",
          "[bases][triangle_mesh]") {
  test::Random random(2);
  for (const auto& [name, mesh] : test::meshes(random)) {
    CAPTURE(name);
    const auto neighbour = neighbours(mesh);
    REQUIRE(neighbour.size() == mesh.triangle.size());
    long sides = 0;
    long border = 0;
    for (std::size_t t = 0; t < neighbour.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        ++sides;
        if (neighbour[t][k] < 0) ++border;
        if (neighbour[t][k] < 0) continue;
        const auto other = static_cast<std::size_t>(neighbour[t][k]);
        const auto back = std::ranges::find(neighbour[other], static_cast<Index>(t)) - neighbour[other].begin();
        REQUIRE(back < 3);
        CHECK(mesh.triangle[other][static_cast<std::size_t>(back)] == mesh.triangle[t][(k + 1) % 3]);
        CHECK(mesh.triangle[other][static_cast<std::size_t>(back + 1) % 3] == mesh.triangle[t][k]);
      }
    const long edges = (sides + border) / 2;
    const long holes = name.starts_with("hole") ? 1 : 0;
    CHECK(static_cast<long>(mesh.vertex.size()) - edges + static_cast<long>(mesh.triangle.size()) == 1 - holes);
  }
}

TEST_CASE("the bounds touch a vertex on each side and hold all", "[bases][triangle_mesh]") {
  test::Random random(3);
  for (const auto& [name, mesh] : test::meshes(random)) {
    const Box box = bounds(mesh);
    for (int axis = 0; axis < 2; ++axis) {
      const auto coordinate = [axis](const Vec2& v) { return v[axis]; };
      CHECK(std::ranges::min(mesh.vertex, {}, coordinate)[axis] == box.lower[axis]);
      CHECK(std::ranges::max(mesh.vertex, {}, coordinate)[axis] == box.upper[axis]);
    }
  }
}

TEST_CASE("bad lists are refused", "[bases][triangle_mesh]") {
  CHECK_THROWS_WITH(check(TriangleMesh{}), Contains("got 0 and 0"));
  TriangleMesh mesh = square();
  mesh.triangle[1][2] = 4;
  CHECK_THROWS_WITH(check(mesh), Contains("triangle 1") && Contains("vertex 4") && Contains("0 to 3"));
  mesh.triangle[1][2] = -1;
  CHECK_THROWS_WITH(check(mesh), Contains("vertex -1"));
  mesh = square();
  mesh.vertex[2].y() = NAN;
  CHECK_THROWS_WITH(check(mesh), Contains("vertex 2") && Contains("finite"));
}

TEST_CASE("vertices in one place are named, however close", "[bases][triangle_mesh]") {
  for (const double gap : {0.0, 1e-12, 1e-11}) {
    TriangleMesh mesh = square();
    mesh.vertex.emplace_back(1.0, 1.0 + gap);
    mesh.triangle[1][1] = 4;
    CHECK_THROWS_AS(check(mesh), MeshError);
    CHECK_THROWS_WITH(check(mesh), Contains("vertex 2 and vertex 4 at (1, 1)") && Contains("same place"));
  }
}

TEST_CASE("a vertex without a triangle is named, and how many there are", "[bases][triangle_mesh]") {
  TriangleMesh mesh = square();
  mesh.vertex.emplace_back(0.25, 2.0);
  mesh.vertex.emplace_back(0.5, 2.0);
  mesh.vertex.emplace_back(0.75, 2.0);
  CHECK_THROWS_WITH(check(mesh), Contains("vertex 4 at (0.25, 2)") && Contains("no triangle") && Contains("2 more"));
}

TEST_CASE("inverted and flat triangles are named with their place", "[bases][triangle_mesh]") {
  TriangleMesh mesh = square();
  std::swap(mesh.triangle[1][0], mesh.triangle[1][1]);
  CHECK_THROWS_WITH(check(mesh), Contains("triangle 1 (vertices 2, 0, 3) at (0.333333, 0.666667) is inverted") &&
                                     Contains("counter-clockwise"));
  mesh = square();
  mesh.vertex[3] = Vec2(0.5, 0.5);
  CHECK_THROWS_WITH(check(mesh), Contains("triangle 1") && Contains("flat"));
}

TEST_CASE("the smallest angle is the limit, wherever it is in the triangle", "[bases][triangle_mesh]") {
  for (const double angle : {0.999, 1.001})
    for (std::size_t first = 0; first < 3; ++first) {
      TriangleMesh mesh{{{0.0, 0.0}, {1.0, 0.0}, {1.0, std::tan(angle * test::degree)}}, {{0, 1, 2}}};
      std::rotate(mesh.triangle[0].begin(), mesh.triangle[0].begin() + static_cast<std::ptrdiff_t>(first),
                  mesh.triangle[0].end());
      if (angle > 1.0)
        CHECK_NOTHROW(check(mesh));
      else
        CHECK_THROWS_WITH(check(mesh), Contains("triangle 0") && Contains("sliver") && Contains("0.999 degrees"));
      CHECK_THROWS_AS(check(mesh, 2.0 * test::degree), MeshError);
      CHECK_NOTHROW(check(mesh, 0.0));
    }
}

TEST_CASE("triangles on the same side of an edge are named", "[bases][triangle_mesh]") {
  TriangleMesh mesh = square();
  mesh.vertex.emplace_back(0.75, 0.125);
  SECTION("two triangles, one upon the other") {
    mesh = {{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.75, 0.5}}, {{0, 1, 2}, {0, 1, 3}}};
    CHECK_THROWS_WITH(check(mesh), Contains("vertex 0") && Contains("vertex 1") && Contains("triangle 0") &&
                                       Contains("triangle 1") && Contains("among its 2"));
  }
  SECTION("a third at an edge that two share") {
    mesh.triangle.push_back({0, 4, 2});
    CHECK_THROWS_WITH(check(mesh), Contains("vertex 0 at (0, 0) to vertex 2 at (1, 1)") && Contains("among its 3"));
  }
}

TEST_CASE("a vertex that hangs on an edge is named, in any direction", "[bases][triangle_mesh]") {
  test::Random random(4);
  for (int draw = 0; draw < 20; ++draw) {
    TriangleMesh mesh = square();
    mesh.vertex.emplace_back(0.25, 0.25);  // in the middle of the diagonal, as two smaller triangles see it
    mesh.triangle = {{0, 1, 4}, {1, 2, 4}, {0, 2, 3}};
    test::place(mesh, random);
    CHECK_THROWS_WITH(check(mesh), Contains("vertex 4") && Contains("hangs") && Contains("vertex 0") &&
                                       Contains("vertex 2") && Contains("triangle 2") && Contains("split"));
  }
}

TEST_CASE("parts that share no edge are refused, also if they share a vertex", "[bases][triangle_mesh]") {
  TriangleMesh mesh = square();
  mesh.vertex.insert(mesh.vertex.end(), {Vec2(3.0, 3.0), Vec2(4.0, 3.0), Vec2(4.0, 4.0)});
  mesh.triangle.push_back({4, 5, 6});
  CHECK_THROWS_WITH(check(mesh), Contains("triangle 2") && Contains("(3.66667, 3.33333)") && Contains("several parts"));
  mesh.vertex.erase(mesh.vertex.begin() + 4);
  mesh.triangle[2] = {2, 4, 5};
  CHECK_THROWS_WITH(check(mesh), Contains("several parts"));
}
