#include "shoreline/bases/triangle_grid.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "meshes.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& x) {
  const Vec2 edge = b - a;
  return (x - a - std::clamp(edge.dot(x - a) / edge.squaredNorm(), 0.0, 1.0) * edge).norm();
}

/// How far a place is outside a cell, by looking at its edges; 0 inside.
double distance(const TriangleGrid& grid, Index cell, const Vec2& x) {
  const std::vector<Vec2> p = grid.polygon(cell);
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    inside = inside && cross(p[(k + 1) % 3] - p[k], x - p[k]) >= 0.0;
    nearest = std::min(nearest, distance_to_segment(p[k], p[(k + 1) % 3], x));
  }
  return inside ? 0.0 : nearest;
}

/// The smallest distance to any cell in units of its size.
double cells_away(const TriangleGrid& grid, const Vec2& x) {
  double least = std::numeric_limits<double>::infinity();
  for (Index cell = 0; cell < grid.cells(); ++cell) least = std::min(least, distance(grid, cell, x) / grid.size(cell));
  return least;
}

/// Each mesh as it is and as a Powell-Sabin refinement.
std::vector<std::pair<std::string, TriangleGrid>> grids(test::Random& random) {
  std::vector<std::pair<std::string, TriangleGrid>> all;
  for (const auto& [name, mesh] : test::meshes(random)) {
    all.emplace_back(name, TriangleGrid(mesh));
    all.emplace_back(name + ", refined", TriangleGrid(powell_sabin_refinement(mesh), powell_sabin_parts));
  }
  return all;
}

}  // namespace

TEST_CASE("every place in a triangle, on an edge or a vertex has a cell that holds it, whatever the hint",
          "[bases][triangle_grid]") {
  test::Random random(1);
  for (const auto& [name, grid] : grids(random)) {
    CAPTURE(name);
    for (Index cell = 0; cell < grid.cells(); ++cell) {
      const auto p = corners(grid.mesh(), cell);
      const double s = random.uniform(0.0, 1.0);
      for (const Vec2& x : {test::inside(p, random), p[0], Vec2(p[0] + s * (p[1] - p[0])), Vec2(0.5 * (p[1] + p[2]))}) {
        const auto found = grid.locate(x, random.whole(0, grid.cells() - 1));
        REQUIRE(found);
        CHECK(distance(grid, *found, x) <= 1e-14 * (1.0 + x.norm()));
        CHECK(grid.locate(x, cell) == found);
        for (const Face& face : grid.faces(cell)) CHECK(grid.locate(x, face.neighbour) == found);
      }
    }
  }
}

TEST_CASE("what is farther than the slack from every triangle has no cell, what is nearer has one",
          "[bases][triangle_grid]") {
  test::Random random(2);
  for (const auto& [name, grid] : grids(random)) {
    CAPTURE(name);
    const Vec2 margin = 0.2 * (grid.bounds().upper - grid.bounds().lower);
    for (int draw = 0; draw < 100; ++draw) {
      const Vec2 x = random.in({grid.bounds().lower - margin, grid.bounds().upper + margin});
      CHECK(grid.locate(x, 0).has_value() == (cells_away(grid, x) <= border_slack));
    }
    CHECK_FALSE(grid.locate({NAN, 0.0}, 0));
    CHECK_FALSE(grid.locate({0.0, INFINITY}, 0));
    CHECK_FALSE(grid.locate({1e300, -1e300}, 0));
  }
}

TEST_CASE("a place beside the border belongs to the border's cell up to the slack", "[bases][triangle_grid]") {
  test::Random random(3);
  for (const auto& [name, grid] : grids(random)) {
    CAPTURE(name);
    const auto neighbour = neighbours(grid.mesh());
    for (Index cell = 0; cell < grid.cells(); ++cell) {
      const std::vector<Vec2> p = grid.polygon(cell);
      for (std::size_t k = 0; k < 3; ++k) {
        if (neighbour[static_cast<std::size_t>(cell)][k] >= 0) continue;
        const Vec2 edge = p[(k + 1) % 3] - p[k];
        const Vec2 outward = Vec2(edge.y(), -edge.x()).normalized();
        const Vec2 on_edge = p[k] + random.uniform(0.0, 1.0) * edge;
        const Vec2 beside = on_edge + 0.99 * border_slack * grid.size(cell) * outward;
        CHECK(grid.locate(beside, 0));
        CHECK(std::ranges::any_of(grid.lines_near({beside, beside}), [&](const Line& line) {
          return std::abs(line.normal.dot(on_edge) - line.offset) < 1e-12 && std::abs(line.normal.dot(edge)) < 1e-12;
        }));
        const Vec2 beyond = on_edge + 1.01 * border_slack * grid.size(cell) * outward;
        CHECK(grid.locate(beyond, 0).has_value() == (cells_away(grid, beyond) <= border_slack));
      }
    }
  }
}

TEST_CASE("the size of a triangle follows from the area of its main triangle", "[bases][triangle_grid]") {
  test::Random random(4);
  for (const auto& [name, mesh] : test::meshes(random)) {
    const TriangleGrid main(mesh);
    const TriangleGrid refined(powell_sabin_refinement(mesh), powell_sabin_parts);
    REQUIRE(refined.cells() == 6 * main.cells());
    for (Index cell = 0; cell < main.cells(); ++cell) {
      const auto [a, b, c] = corners(mesh, cell);
      CHECK_THAT(main.size(cell), WithinRel(std::sqrt(twice_area(a, b, c)), 1e-12));
      for (Index part = 6 * cell; part < 6 * cell + 6; ++part)
        CHECK_THAT(refined.size(part), WithinRel(main.size(cell), 1e-9));
    }
  }
}

TEST_CASE("border edges are no faces, all others are", "[bases][triangle_grid]") {
  test::Random random(5);
  for (const auto& [name, grid] : grids(random)) {
    const auto neighbour = neighbours(grid.mesh());
    for (Index cell = 0; cell < grid.cells(); ++cell) {
      const auto& across = neighbour[static_cast<std::size_t>(cell)];
      const std::vector<Face> faces = grid.faces(cell);
      CHECK(static_cast<long>(faces.size()) == 3 - std::ranges::count(across, -1));
      for (const Face& face : faces) CHECK(std::ranges::count(across, face.neighbour) == 1);
    }
  }
}

TEST_CASE("edges on one line give one line, parallel lines stand together, and near a small box there are few",
          "[bases][triangle_grid]") {
  const TriangleGrid grid(test::lattice(30, 20, TrianglePattern::diagonal, {0.1, 0.1}));
  const std::vector<Line> all = grid.lines_near({Vec2::Constant(-1e30), Vec2::Constant(1e30)});
  CHECK(all.size() == 31 + 21 + 49);
  int directions = 1;
  for (std::size_t k = 1; k < all.size(); ++k)
    if ((all[k].normal - all[k - 1].normal).norm() > 1e-9) ++directions;
  CHECK(directions == 3);
  CHECK(grid.lines_near({Vec2(1.52, 1.02), Vec2(1.58, 1.08)}).size() <= 10);
}

TEST_CASE("a mesh that breaks a rule makes no grid, parts may have any angle", "[bases][triangle_grid]") {
  TriangleMesh mesh = test::lattice(2, 2, TrianglePattern::diagonal, {1.0, std::tan(0.9 * test::degree)});
  CHECK_THROWS_AS(TriangleGrid(mesh), MeshError);
  CHECK_NOTHROW(TriangleGrid(mesh, 2));
  CHECK_THROWS_WITH(TriangleGrid(mesh, 3), Contains("divide") && Contains("8, got 3"));
  CHECK_THROWS_WITH(TriangleGrid(mesh, 0), Contains("8, got 0"));
  std::swap(mesh.triangle[0][0], mesh.triangle[0][1]);
  CHECK_THROWS_AS(TriangleGrid(mesh, 2), MeshError);
}
