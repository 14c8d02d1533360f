// What a grid promises, whatever its cells: tested on the grids that there are.
#include "shoreline/bases/grid.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "meshes.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"
#include "shoreline/bases/triangle_grid.hpp"

using namespace shoreline;
using Catch::Matchers::WithinRel;

namespace {

/// Rectangles, triangles, or the sub-triangles of a Powell-Sabin refinement.
std::unique_ptr<const Grid> any_grid(test::Random& random) {
  const std::vector<test::NamedMesh> meshes = test::meshes(random);
  const TriangleMesh& mesh = meshes[static_cast<std::size_t>(random.whole(0, 14))].mesh;
  const Index kind = random.whole(0, 2);
  if (kind == 0) return std::make_unique<QuadrilateralGrid>(random.grid());
  if (kind == 1) return std::make_unique<TriangleGrid>(mesh);
  return std::make_unique<TriangleGrid>(powell_sabin_refinement(mesh), powell_sabin_parts);
}

double area(const std::vector<Vec2>& polygon) {
  double twice = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) twice += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  return 0.5 * twice;
}

bool inside(const std::vector<Vec2>& polygon, const Vec2& x) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 edge = polygon[(k + 1) % polygon.size()] - polygon[k];
    if (cross(edge, x - polygon[k]) < -1e-12 * edge.norm()) return false;
  }
  return true;
}

Vec2 centre(const std::vector<Vec2>& polygon) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& vertex : polygon) sum += vertex;
  return sum / static_cast<double>(polygon.size());
}

/// Whether a segment meets a box, by clipping it to the box.
bool meets(const Box& box, const Vec2& a, const Vec2& b) {
  double begin = 0.0;
  double end = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double rise = b[axis] - a[axis];
    double first = (box.lower[axis] - a[axis]) / rise;
    double last = (box.upper[axis] - a[axis]) / rise;
    if (rise == 0.0) {
      if (a[axis] < box.lower[axis] || a[axis] > box.upper[axis]) return false;
      continue;
    }
    if (first > last) std::swap(first, last);
    begin = std::max(begin, first);
    end = std::min(end, last);
  }
  return begin <= end;
}

}  // namespace

TEST_CASE("cells are counter-clockwise and tile the bounds, size follows from area", "[bases][grid]") {
  test::Random random(1);
  for (int draw = 0; draw < 20; ++draw) {
    const auto quadrilaterals = random.grid();
    const Grid& grid = quadrilaterals;
    double sum = 0.0;
    for (Index cell = 0; cell < grid.cells(); ++cell) {
      const double a = area(grid.polygon(cell));
      CHECK(a > 0.0);
      CHECK_THAT(grid.size(cell) * grid.size(cell), WithinRel(a, 1e-12));
      sum += a;
    }
    CHECK_THAT(sum, WithinRel((grid.bounds().upper - grid.bounds().lower).prod(), 1e-12));
  }
}

TEST_CASE("the polygon of the located cell holds the point, whatever the hint", "[bases][grid]") {
  test::Random random(2);
  for (int draw = 0; draw < 500; ++draw) {
    const auto drawn = any_grid(random);
    const Grid& grid = *drawn;
    const std::vector<Vec2> polygon = grid.polygon(random.whole(0, grid.cells() - 1));
    const Vec2 x = test::inside({polygon[0], polygon[1], polygon[2]}, random);
    const auto cell = grid.locate(x, random.whole(0, grid.cells() - 1));
    REQUIRE(cell);
    CHECK(inside(grid.polygon(*cell), x));
  }
}

TEST_CASE("every vertex, also on the border, is in some cell, nothing outside is in any", "[bases][grid]") {
  test::Random random(3);
  for (int draw = 0; draw < 20; ++draw) {
    const auto quadrilaterals = random.grid();
    const Grid& grid = quadrilaterals;
    for (Index cell = 0; cell < grid.cells(); ++cell)
      for (const Vec2& vertex : grid.polygon(cell)) {
        const auto found = grid.locate(vertex, 0);
        REQUIRE(found);
        CHECK(inside(grid.polygon(*found), vertex));
      }
    const Box box = grid.bounds();
    const Vec2 x = random.in(box);
    for (const double cells : {0.99 * border_slack, 1.01 * border_slack, 1.0, 1e12}) {
      const Vec2 beyond = cells * quadrilaterals.spacing();
      const bool held = cells < border_slack;
      CHECK(grid.locate({box.upper.x() + beyond.x(), x.y()}, 0).has_value() == held);
      CHECK(grid.locate({box.lower.x() - beyond.x(), x.y()}, 0).has_value() == held);
      CHECK(grid.locate({x.x(), box.upper.y() + beyond.y()}, 0).has_value() == held);
      CHECK(grid.locate({x.x(), box.lower.y() - beyond.y()}, 0).has_value() == held);
    }
    CHECK_FALSE(grid.locate({std::nan(""), x.y()}, 0));
    CHECK_FALSE(grid.locate({x.x(), INFINITY}, 0));
  }
}

TEST_CASE("a face has its cell on the left, its neighbour on the right, and both see it with ends swapped",
          "[bases][grid]") {
  test::Random random(4);
  for (int draw = 0; draw < 20; ++draw) {
    const auto drawn = any_grid(random);
    const Grid& grid = *drawn;
    for (Index cell = 0; cell < grid.cells(); ++cell)
      for (const Face& face : grid.faces(cell)) {
        CHECK(face.cell == cell);
        CHECK(cross(face.b - face.a, centre(grid.polygon(face.cell)) - face.a) > 0.0);
        CHECK(cross(face.b - face.a, centre(grid.polygon(face.neighbour)) - face.a) < 0.0);
        const std::vector<Face> back = grid.faces(face.neighbour);
        const auto same = [&](const Face& f) { return f.neighbour == cell && f.a == face.b && f.b == face.a; };
        CHECK(std::ranges::count_if(back, same) == 1);
      }
  }
}

TEST_CASE("every edge of a cell that meets a box lies on one of the lines near the box", "[bases][grid]") {
  test::Random random(5);
  for (int draw = 0; draw < 200; ++draw) {
    const auto drawn = any_grid(random);
    const Grid& grid = *drawn;
    const Vec2 x = random.in(grid.bounds());
    const Vec2 y = draw % 2 == 0 ? random.in(grid.bounds()) : x;
    const Box box{x.cwiseMin(y), x.cwiseMax(y)};
    const std::vector<Line> lines = grid.lines_near(box);
    for (Index cell = 0; cell < grid.cells(); ++cell) {
      const std::vector<Vec2> polygon = grid.polygon(cell);
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2& a = polygon[k];
        const Vec2& b = polygon[(k + 1) % polygon.size()];
        const auto holds = [&](const Line& line) {
          return std::abs(line.normal.dot(a) - line.offset) + std::abs(line.normal.dot(b) - line.offset) < 1e-12;
        };
        if (meets(box, a, b)) CHECK(std::ranges::any_of(lines, holds));
      }
    }
  }
}

TEST_CASE("lines that run through a grid meet few boxes: no more than its columns and rows have", "[bases][grid]") {
  test::Random random(6);
  for (int draw = 0; draw < 20; ++draw) {
    const QuadrilateralGrid grid = random.grid();
    CHECK(grid.lines_run_through());
    CHECK(static_cast<Index>(grid.lines_near(grid.bounds()).size()) == grid.columns() + grid.rows() + 2);
  }
}
