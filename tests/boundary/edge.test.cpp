#include "shoreline/boundary/edge.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "../random.hpp"
#include "random_pieces.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::vector<char> all_active(const Grid& grid) { return std::vector<char>(static_cast<std::size_t>(grid.cells()), 1); }

/// Faces between two cells of a regular grid.
Index faces_between(const QuadrilateralGrid& grid, Index a, Index b) {
  return std::abs(a % grid.columns() - b % grid.columns()) + std::abs(a / grid.columns() - b / grid.columns());
}

/// Nearest centre among the active cells that are at most one face farther away than the fewest faces.
double smallest_distance(const QuadrilateralGrid& grid, const std::vector<char>& active, Index cell, const Vec2& x) {
  const auto distance = [&](Index c) { return (grid.corner(c) + 0.5 * grid.spacing() - x).norm(); };
  Index fewest = grid.cells();
  for (Index c = 0; c < grid.cells(); ++c)
    if (active[static_cast<std::size_t>(c)]) fewest = std::min(fewest, faces_between(grid, cell, c));
  double smallest = INFINITY;
  for (Index c = 0; c < grid.cells(); ++c)
    if (active[static_cast<std::size_t>(c)] && faces_between(grid, cell, c) <= fewest + 1)
      smallest = std::min(smallest, distance(c));
  return smallest;
}

double length_of(const SplineCurve& curve) {
  double sum = 0.0;
  for (const CubicSpan& span : curve.spans) sum += span.length();
  return sum;
}

}  // namespace

TEST_CASE("the nearest active cell is the cell itself where it is active", "[boundary][edge]") {
  test::Random random(1);
  const QuadrilateralGrid grid = random.grid();
  for (Index cell = 0; cell < grid.cells(); ++cell)
    CHECK(nearest_active_cell(grid, all_active(grid), cell, random.vector()) == cell);
}

TEST_CASE("the nearest active cell is what a search of all cells finds", "[boundary][edge]") {
  test::Random random(2);
  for (int draw = 0; draw < 300; ++draw) {
    const QuadrilateralGrid grid = random.grid(12);
    std::vector<char> active(static_cast<std::size_t>(grid.cells()));
    const double share = random.uniform(0.01, 0.5);
    for (char& a : active) a = random.uniform(0.0, 1.0) < share ? 1 : 0;
    active[static_cast<std::size_t>(random.whole(0, grid.cells() - 1))] = 1;
    const Vec2 x = random.in(grid.bounds());
    const Index cell = grid.locate(x, 0).value();
    if (active[static_cast<std::size_t>(cell)]) continue;
    const Index found = nearest_active_cell(grid, active, cell, x);
    CHECK(active[static_cast<std::size_t>(found)]);
    const double distance = (grid.corner(found) + 0.5 * grid.spacing() - x).norm();
    CHECK_THAT(distance, WithinRel(smallest_distance(grid, active, cell, x), 1e-12));
  }
}

TEST_CASE("a grid without active cells has no nearest one", "[boundary][edge]") {
  const QuadrilateralGrid grid(Vec2::Zero(), Vec2::Ones(), {3, 3});
  CHECK_THROWS_WITH(nearest_active_cell(grid, std::vector<char>(9, 0), 4, Vec2(1.5, 1.5)),
                    Contains("no cell holds a material point"));
}

TEST_CASE("the weights of an edge sum to its length, and its points know their segment", "[boundary][edge]") {
  test::RandomPieces random(3);
  for (int draw = 0; draw < 20; ++draw) {
    const Piece piece = random.star();
    const QuadrilateralGrid grid = random.grid_around(fit_spline(piece));
    const Edge edge = make_edge(piece, grid, all_active(grid), gauss(40));
    double length = 0.0;
    for (std::size_t k = 0; k < edge.points.size(); ++k) {
      length += edge.points[k].weight;
      const Segment& segment = edge.segments[edge.segment_of(k)];
      CHECK(segment.span == edge.points[k].span);
      CHECK((segment.begin < edge.points[k].u && edge.points[k].u < segment.end));
    }
    CHECK(edge.points.size() == 40 * edge.segments.size());
    CHECK_THAT(length, WithinRel(length_of(edge.curve), 1e-9));
    CHECK(edge.extended_share == 0.0);
  }
}

TEST_CASE("segments in cells without material points are served by the nearest active cell", "[boundary][edge]") {
  const QuadrilateralGrid grid(Vec2::Zero(), Vec2::Ones(), {4, 1});
  const Edge edge = make_edge(line({0.5, 0.5}, {3.5, 0.5}), grid, {1, 1, 0, 0}, gauss(2));
  REQUIRE(edge.segments.size() == 4);
  CHECK(edge.support_cell == std::vector<Index>{0, 1, 1, 1});
  CHECK_THAT(edge.extended_share, WithinAbs(1.5 / 3.0, 1e-14));
}

TEST_CASE("a rigid motion moves tracking points and turns end tangents exactly", "[boundary][edge]") {
  test::Random random(4);
  for (int draw = 0; draw < 50; ++draw) {
    const Mat2 turn = Eigen::Rotation2Dd(random.uniform(-3.0, 3.0)).toRotationMatrix();
    const Vec2 shift = random.vector();
    const Piece before = arc(random.vector(), random.uniform(0.5, 2.0), random.uniform(50.0, 350.0), 400.0, 6);
    const QuadrilateralGrid grid(Vec2(-4.0, -4.0), random.vector(0.3, 1.0), {30, 30});
    Piece after = before;
    move_piece(after, make_edge(before, grid, all_active(grid), gauss(2)), [&](Index, const Vec2& x) -> Motion {
      return {turn * x + shift - x, turn - Mat2::Identity()};
    });
    for (std::size_t k = 0; k < before.points.size(); ++k)
      CHECK_THAT((after.points[k] - turn * before.points[k] - shift).norm(), WithinAbs(0.0, 1e-14));
    CHECK_THAT((*after.start_tangent - turn * *before.start_tangent).norm(), WithinAbs(0.0, 1e-14));
    CHECK_THAT((*after.end_tangent - turn * *before.end_tangent).norm(), WithinAbs(0.0, 1e-14));
  }
}

TEST_CASE("an end tangent follows the material and stays a direction", "[boundary][edge]") {
  const QuadrilateralGrid grid(Vec2(-2.0, -2.0), Vec2::Ones(), {4, 4});
  Piece piece = arc(Vec2::Zero(), 1.0, 0.0, 90.0, 4);
  const Edge edge = make_edge(piece, grid, all_active(grid), gauss(2));
  Mat2 gradient;
  gradient << 1.0, 0.5, 1.0, 2.0;  // (I + ∇u) = [2 ½; 1 3] where the arc starts, the identity where it ends
  move_piece(piece, edge, [&](Index, const Vec2& x) -> Motion {
    return {gradient * x, x.x() > 0.5 ? gradient : Mat2(Mat2::Zero())};
  });
  CHECK_THAT((*piece.start_tangent - Vec2(0.5, 3.0).normalized()).norm(), WithinAbs(0.0, 1e-14));
  CHECK_THAT((*piece.end_tangent - Vec2(-1.0, 0.0)).norm(), WithinAbs(0.0, 1e-14));
}

TEST_CASE("each tracking point moves with the cell of a segment that touches it", "[boundary][edge]") {
  test::RandomPieces random(5);
  for (int draw = 0; draw < 20; ++draw) {
    Piece piece = random.star();
    piece.closed = draw % 2 == 0;
    const QuadrilateralGrid grid = random.grid_around(fit_spline(piece));
    const std::size_t points = piece.points.size();
    std::size_t calls = 0;
    const Edge edge = make_edge(piece, grid, all_active(grid), gauss(1));
    move_piece(piece, edge, [&](Index cell, const Vec2& x) -> Motion {
      const Vec2 inside = (x - grid.corner(cell)).cwiseQuotient(grid.spacing());
      CHECK(inside.minCoeff() >= -1e-9);
      CHECK(inside.maxCoeff() <= 1.0 + 1e-9);
      ++calls;
      return {Vec2::Zero(), Mat2::Zero()};
    });
    CHECK(calls == points);
  }
}
