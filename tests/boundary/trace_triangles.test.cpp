// Curves in triangle meshes and their Powell-Sabin refinements.
#include <algorithm>
#include <catch2/catch.hpp>

#include "../bases/meshes.hpp"
#include "random_pieces.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"
#include "shoreline/bases/triangle_grid.hpp"
#include "traced.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using test::cells_of;
using test::fault;
using test::outside;
using test::straight;

namespace {

/// A mesh of any kind on [0, 6]², and its Powell-Sabin refinement.
std::vector<TriangleGrid> triangle_grids(test::Random& random) {
  const TriangleMesh meshes[] = {test::lattice(6, 6, TrianglePattern::diagonal),
                                 test::lattice(6, 6, TrianglePattern::four),
                                 delaunay(test::jittered_points(6, 6, random))};
  std::vector<TriangleGrid> grids;
  for (const TriangleMesh& mesh : meshes) {
    grids.emplace_back(mesh);
    grids.emplace_back(powell_sabin_refinement(mesh), powell_sabin_parts);
  }
  return grids;
}

/// Whether segments, but for those around vertices that are shorter than 1e-8, lie in the cells on their left.
bool on_the_left(const SplineCurve& curve, const Grid& grid, const std::vector<Segment>& segments) {
  return std::ranges::all_of(segments, [&](const Segment& s) {
    const CubicSpan& span = curve.spans[static_cast<std::size_t>(s.span)];
    const Vec2 along = span.derivative(0.5 * (s.begin + s.end));
    if ((s.end - s.begin) * along.norm() < 1e-8) return true;
    const Vec2 left = Vec2(-along.y(), along.x()).normalized();
    return outside(grid, s.cell, span.position(0.5 * (s.begin + s.end)) + 2e-9 * left) <= 0.0;
  });
}

}  // namespace

TEST_CASE("segments tile random closed curves in triangles, each within its cell", "[boundary][trace]") {
  test::Random random(5);
  test::RandomPieces pieces(5);
  for (int draw = 0; draw < 60; ++draw)
    for (const TriangleGrid& grid : triangle_grids(random)) {
      Piece piece = draw % 2 == 0 ? pieces.star() : pieces.wild();
      for (Vec2& x : piece.points) x = 1.5 * x + Vec2(3, 3);
      const SplineCurve curve = fit_spline(piece);
      const std::string found = fault(curve, grid, trace(curve, grid, "loop"));
      if (!found.empty()) FAIL("draw " << draw << ", " << grid.cells() << " cells: " << found);
    }
}

TEST_CASE("long spans in many triangles miss no cell", "[boundary][trace]") {
  test::Random random(6);
  const TriangleMesh mesh = delaunay(test::jittered_points(40, 40, random));
  const SplineCurve long_spans{
      .spans = {{{Vec2(0.3, 0.2), Vec2(13, 14), Vec2(26, 27), Vec2(39.5, 39.7)}},  // almost straight
                {{Vec2(39.5, 39.7), Vec2(-30, 30), Vec2(60, 20), Vec2(1.2, 1.3)}}},
      .knots = {0, 1, 2}};
  for (const TriangleGrid& grid :
       {TriangleGrid(mesh), TriangleGrid(powell_sabin_refinement(mesh), powell_sabin_parts)}) {
    const std::vector<Segment> segments = trace(long_spans, grid, "long");
    CHECK(segments.size() > 200);
    CHECK(fault(long_spans, grid, segments) == "");
  }
}

TEST_CASE("along edges of triangles a curve belongs to the cells on its left", "[boundary][trace]") {
  test::Random random(7);
  const double beside = GENERATE(0.0, 4e-16, -4e-16, 3e-10, -3e-10);
  for (const TriangleGrid& grid : triangle_grids(random))
    for (Index cell = 0; cell < grid.cells(); ++cell)
      for (const Face& face : grid.faces(cell)) {
        const Vec2 off = beside * Vec2(face.b.y() - face.a.y(), face.a.x() - face.b.x()).normalized();
        const SplineCurve along = straight(face.a + off, face.b + off);
        const std::vector<Segment> segments = trace(along, grid, "edge");
        CHECK(fault(along, grid, segments) == "");
        CHECK(std::ranges::any_of(segments, [&](const Segment& s) { return s.cell == cell && s.end - s.begin > 0.9; }));
      }
}

TEST_CASE("a straight curve through vertices of triangles has each cell once", "[boundary][trace]") {
  test::Random random(8);
  for (int draw = 0; draw < 20; ++draw)
    for (const TriangleGrid& grid : triangle_grids(random)) {
      const auto& vertex = grid.mesh().vertex;
      const auto any = [&] {
        return vertex[static_cast<std::size_t>(random.whole(0, static_cast<Index>(vertex.size()) - 1))];
      };
      const Vec2 from = any();
      const Vec2 to = any();
      if ((to - from).norm() < 0.1) continue;
      const SplineCurve curve = straight(from, to);
      const std::vector<Segment> segments = trace(curve, grid, "through");
      CHECK(fault(curve, grid, segments) == "");
      CHECK(on_the_left(curve, grid, segments));
      std::vector<Index> cells = cells_of(segments);
      std::ranges::sort(cells);
      CHECK(std::ranges::adjacent_find(cells) == cells.end());
    }
}

TEST_CASE("a curve that touches an edge of a triangle stays in its cell", "[boundary][trace]") {
  const TriangleGrid grid(test::lattice(4, 4, TrianglePattern::diagonal));
  const Vec2 across = Vec2(1, -1).normalized();  // away from the diagonal y = x
  const auto place = [&](double along, double away) -> Vec2 { return Vec2(along, along) + away * across; };
  const CubicSpan touch{{place(1.4, 0.15), place(1.5, -0.05), place(1.6, -0.05), place(1.7, 0.15)}};  // at u = ½
  REQUIRE_THAT(cross(touch.position(0.5), Vec2(1, 1)), WithinAbs(0.0, 1e-15));
  const std::vector<Segment> segments = trace({.spans = {touch}, .knots = {0, 1}}, grid, "touch");
  const Index cell = grid.locate(place(1.55, 0.01), 0).value();
  CHECK(segments.front().cell == cell);
  CHECK(segments.back().cell == cell);
  for (const Segment& s : segments) CHECK((s.cell == cell || s.end - s.begin < 1e-7));
}

TEST_CASE("along the border of triangles a curve has the cells inside, also a little beyond it", "[boundary][trace]") {
  test::Random random(9);
  const double beyond = GENERATE(0.0, 4e-16, -4e-16, 1e-10, -1e-10, 0.1 * border_slack);
  const double low = -beyond;
  const double high = 6.0 + beyond;
  const Piece square{.name = "square",
                     .points = {Vec2(low, low), Vec2(high, low), Vec2(high, high), Vec2(low, high)},
                     .corners = {0, 1, 2, 3},
                     .closed = true};
  const SplineCurve curve = fit_spline(square);
  for (const TriangleGrid& grid : triangle_grids(random)) {
    const std::vector<Segment> segments = trace(curve, grid, "square");
    for (const Segment& s : segments)
      for (const double u : {0.25, 0.5, 0.75}) {  // no segment reaches past its cell's side
        const Vec2 x = curve.spans[static_cast<std::size_t>(s.span)].position(s.begin + u * (s.end - s.begin));
        CHECK(outside(grid, s.cell, x.cwiseMax(0.0).cwiseMin(6.0)) < 1e-9 + 30.0 * std::max(beyond, 0.0));
      }
    Index on_border = 0;
    for (Index cell = 0; cell < grid.cells(); ++cell) on_border += 3 - static_cast<Index>(grid.faces(cell).size());
    const auto long_ones = std::ranges::count_if(segments, [](const Segment& s) { return s.end - s.begin > 0.02; });
    CHECK(long_ones == on_border);
  }
  CHECK_THROWS_AS(trace(straight({-1.0, 1.0}, {5.0, 1.0}), triangle_grids(random).back(), "shore"), OutsideGrid);
}
