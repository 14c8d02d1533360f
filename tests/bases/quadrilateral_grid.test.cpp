#include "shoreline/bases/quadrilateral_grid.hpp"

#include <catch2/catch.hpp>

#include "../random.hpp"
#include "shoreline/bases/error.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

TEST_CASE("the area of a cell is the product of the spacings", "[bases][quadrilateral_grid]") {
  test::Random random(1);
  for (int draw = 0; draw < 20; ++draw) {
    const QuadrilateralGrid grid = random.grid();
    for (Index cell = 0; cell < grid.cells(); ++cell) {
      const std::vector<Vec2> p = grid.polygon(cell);
      REQUIRE(p.size() == 4);
      CHECK_THAT(cross(p[2] - p[0], p[3] - p[1]) / 2.0, WithinRel(grid.spacing().prod(), 1e-12));
      CHECK_THAT(grid.size(cell), WithinRel(std::sqrt(grid.spacing().prod()), 1e-15));
    }
  }
}

TEST_CASE("cells run along rows, nodes too, neighbours share their nodes to the last digit",
          "[bases][quadrilateral_grid]") {
  const QuadrilateralGrid grid(Vec2(0.1, -0.7), Vec2(0.1, 0.3), {3, 2});
  CHECK(grid.cells() == 6);
  CHECK(grid.nodes() == 12);
  for (Index cell = 0; cell < grid.cells(); ++cell) {
    const Index node = cell % 3 + 4 * (cell / 3);
    CHECK(grid.polygon(cell)[0] == grid.node(node));
    CHECK(grid.polygon(cell)[1] == grid.node(node + 1));
    CHECK(grid.polygon(cell)[2] == grid.node(node + 5));
    CHECK(grid.polygon(cell)[3] == grid.node(node + 4));
    CHECK(grid.corner(cell) == grid.node(node));
  }
  CHECK(grid.bounds().lower == grid.node(0));
  CHECK(grid.bounds().upper == grid.node(11));
}

TEST_CASE("points on an inner grid line belong to the upper cell, on the upper border to the last",
          "[bases][quadrilateral_grid]") {
  const QuadrilateralGrid grid(Vec2::Zero(), Vec2(0.5, 0.25), {4, 3});
  CHECK(grid.locate({0.5, 0.25}, 0) == Index{1 + 4});
  CHECK(grid.locate({0.0, 0.0}, 0) == Index{0});
  CHECK(grid.locate({2.0, 0.75}, 0) == Index{11});
  CHECK(grid.locate({2.0, 0.1}, 0) == Index{3});
  CHECK(grid.locate({0.1, 0.75}, 0) == Index{8});
}

TEST_CASE("inner edges are faces and border edges are not", "[bases][quadrilateral_grid]") {
  test::Random random(2);
  for (int draw = 0; draw < 20; ++draw) {
    const QuadrilateralGrid grid = random.grid();
    std::size_t count = 0;
    for (Index cell = 0; cell < grid.cells(); ++cell) count += grid.faces(cell).size();
    const Index inner = (grid.columns() - 1) * grid.rows() + grid.columns() * (grid.rows() - 1);
    CHECK(count == 2 * static_cast<std::size_t>(inner));
  }
}

TEST_CASE("lines near a small box are few", "[bases][quadrilateral_grid]") {
  const QuadrilateralGrid grid(Vec2::Zero(), Vec2::Ones(), {1000, 1000});
  CHECK(grid.lines_near({Vec2(500.2, 500.2), Vec2(500.8, 500.8)}).size() <= 4);
  CHECK(grid.lines_near({Vec2(-1e30, -1e30), Vec2(1e30, 1e30)}).size() == 2002);
}

TEST_CASE("a grid that cannot be is refused with the value", "[bases][quadrilateral_grid]") {
  const auto grid = [](double x, double spacing, Index columns, Index rows) {
    return QuadrilateralGrid(Vec2(x, 0.0), Vec2(1.0, spacing), {columns, rows});
  };
  CHECK_THROWS_AS(grid(0.0, 0.0, 1, 1), InvalidArgument);
  CHECK_THROWS_AS(grid(NAN, 1.0, 1, 1), InvalidArgument);
  CHECK_THROWS_AS(grid(0.0, INFINITY, 1, 1), InvalidArgument);
  CHECK_THROWS_AS(grid(0.0, NAN, 1, 1), InvalidArgument);
  CHECK_THROWS_WITH(grid(0.0, -0.25, 1, 1), Contains("positive spacing") && Contains("-0.25"));
  CHECK_THROWS_WITH(grid(0.0, 1.0, 0, 7), Contains("got 0 x 7"));
  CHECK_THROWS_WITH(grid(0.0, 1.0, 7, -2), Contains("got 7 x -2"));
  CHECK_THROWS_WITH(grid(0.0, 1.0, 100000, 100000), Contains("got 100000 x 100000"));
  CHECK_NOTHROW(grid(0.0, 1.0, 1000, 1000000));
}
