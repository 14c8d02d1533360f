#include "shoreline/bases/mesh_generators.hpp"

#include <catch2/catch.hpp>

#include "meshes.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

double area(const TriangleMesh& mesh) {
  double twice = 0.0;
  for (Index t = 0; t < static_cast<Index>(mesh.triangle.size()); ++t) {
    const auto [a, b, c] = corners(mesh, t);
    twice += twice_area(a, b, c);
  }
  return 0.5 * twice;
}

/// Above zero if x is inside the circle through a, b, c; in units of its radius, as far as x is near it.
double inside_circle(const std::array<Vec2, 3>& p, const Vec2& x) {
  const Vec2 b = p[1] - p[0];
  const Vec2 c = p[2] - p[0];
  const Vec2 to_centre =
      Vec2(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(), b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) /
      (2.0 * cross(b, c));
  return 1.0 - (x - p[0] - to_centre).norm() / to_centre.norm();
}

}  // namespace

TEST_CASE("rectangles are cut into triangles that cover them and nothing else", "[bases][mesh_generators]") {
  test::Random random(1);
  for (const auto& [pattern, per_cell] : {std::pair(TrianglePattern::diagonal, 2), std::pair(TrianglePattern::four, 4)})
    for (int draw = 0; draw < 20; ++draw) {
      const QuadrilateralGrid grid = random.grid();
      const TriangleMesh mesh = triangulate(grid, pattern);
      CHECK_NOTHROW(check(mesh));
      REQUIRE(mesh.triangle.size() == static_cast<std::size_t>(per_cell * grid.cells()));
      for (Index node = 0; node < grid.nodes(); ++node)
        CHECK(mesh.vertex[static_cast<std::size_t>(node)] == grid.node(node));
      for (Index t = 0; t < static_cast<Index>(mesh.triangle.size()); ++t) {
        const auto [a, b, c] = corners(mesh, t);
        CHECK_THAT(twice_area(a, b, c), WithinRel(2.0 * grid.spacing().prod() / per_cell, 1e-11));
        CHECK(grid.locate((a + b + c) / 3.0, 0) == t / per_cell);
      }
    }
}

TEST_CASE("all diagonals go one way: up to the right", "[bases][mesh_generators]") {
  const TriangleMesh mesh = test::lattice(3, 2, TrianglePattern::diagonal);
  const auto neighbour = neighbours(mesh);
  for (std::size_t t = 0; t < mesh.triangle.size(); t += 2) {
    const auto side =
        static_cast<std::size_t>(std::ranges::find(neighbour[t], static_cast<Index>(t) + 1) - neighbour[t].begin());
    REQUIRE(side < 3);
    const auto p = corners(mesh, static_cast<Index>(t));
    const Vec2 diagonal = p[(side + 1) % 3] - p[side];
    CHECK(diagonal.prod() > 0.0);
  }
}

TEST_CASE("four triangles of a rectangle meet at its centre", "[bases][mesh_generators]") {
  const TriangleMesh mesh = test::lattice(3, 2, TrianglePattern::four);
  for (Index cell = 0; cell < 6; ++cell)
    for (Index t = 4 * cell; t < 4 * cell + 4; ++t) CHECK(corners(mesh, t)[2] == Vec2(cell % 3 + 0.5, cell / 3 + 0.5));
}

TEST_CASE("no point is in the circumcircle of a Delaunay triangle", "[bases][mesh_generators]") {
  test::Random random(2);
  for (int draw = 0; draw < 40; ++draw) {
    const double most = draw % 2 == 0 ? 0.35 : 1e-5;  // the latter: four points are nearly on one circle
    const std::vector<Vec2> points = test::jittered_points(random.whole(2, 9), random.whole(2, 9), random, most);
    const TriangleMesh mesh = delaunay(points);
    CHECK(mesh.vertex == points);
    for (Index t = 0; t < static_cast<Index>(mesh.triangle.size()); ++t)
      for (const Vec2& x : points) CHECK(inside_circle(corners(mesh, t), x) < 1e-7);
  }
}

TEST_CASE("Delaunay triangles fill the hull: a turned rectangle with points on its sides", "[bases][mesh_generators]") {
  test::Random random(3);
  for (int draw = 0; draw < 20; ++draw) {
    const Index columns = random.whole(1, 20);
    const Index rows = random.whole(1, 20);
    TriangleMesh lattice = test::lattice(columns, rows, TrianglePattern::diagonal);
    test::place(lattice, random);
    const TriangleMesh mesh = delaunay(lattice.vertex);
    CHECK_THAT(area(mesh), WithinRel(1.0 * columns * rows, 1e-12));
    CHECK(mesh.triangle.size() == lattice.triangle.size());
  }
}

TEST_CASE("points that have no Delaunay triangulation are refused", "[bases][mesh_generators]") {
  const std::vector<Vec2> square{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.5, 0.1}};
  CHECK_THROWS_WITH(delaunay(square, {0, 1, 2, 7}), Contains("names point 7, expected 0 to 4"));
  CHECK_THROWS_WITH(delaunay(square, {0, 3, 2, 1}), Contains("counter-clockwise"));
  CHECK_THROWS_WITH(delaunay({{0.0, 0.0}, {1.0, 0.0}, {0.5, 1.0}, {0.5, 3.0}}, {0, 1, 2}), Contains("vertex 3"));
  CHECK_THROWS_WITH(delaunay({{0.0, 0.0}, {4.0, 0.0}, {2.0, 1.0}, {2.0, -1.0}}, {0, 1, 2}),
                    Contains("from point 0 to point 1 is no edge"));
  CHECK_THROWS_WITH(delaunay({{0.0, 0.0}, {1.0, 0.0}}), Contains("at least 3 points, got 2"));
  CHECK_THROWS_WITH(delaunay({{0.0, 0.0}, {1.0, 0.0}, {0.0, NAN}}), Contains("point 2 is not finite"));
  CHECK_THROWS_WITH(delaunay({{0.0, 0.0}, {1.0, 2.0}, {2.0, 4.0}, {3.0, 6.0}}), Contains("one line"));
  CHECK_THROWS_WITH(delaunay({{1.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}}), Contains("one line"));
  CHECK_THROWS_WITH(delaunay({{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}}), Contains("vertex 1 and vertex 3"));
}

TEST_CASE("a Delaunay triangulation within an outline covers what that bounds", "[bases][mesh_generators]") {
  // An L of unit squares, with points at all corners of quarters; its re-entrant corner is at (1, 1).
  std::vector<Vec2> points;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i)
      if (i <= 2 || j <= 2) points.emplace_back(0.5 * i, 0.5 * j);
  const auto number = [&](double x, double y) {
    return static_cast<Index>(std::ranges::find(points, Vec2(x, y)) - points.begin());
  };
  std::vector<Index> outline;
  for (const Vec2& corner :
       {Vec2(0, 0), Vec2(0.5, 0), Vec2(1, 0), Vec2(1.5, 0), Vec2(2, 0), Vec2(2, 0.5), Vec2(2, 1), Vec2(1.5, 1),
        Vec2(1, 1), Vec2(1, 1.5), Vec2(1, 2), Vec2(0.5, 2), Vec2(0, 2), Vec2(0, 1.5), Vec2(0, 1), Vec2(0, 0.5)})
    outline.push_back(number(corner.x(), corner.y()));
  CHECK(area(delaunay(points, outline)) == Approx(3.0).epsilon(1e-12));
  CHECK(area(delaunay(points)) == Approx(3.5).epsilon(1e-12));
}
