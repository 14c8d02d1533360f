#include "shoreline/boundary/triangle_moments.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "../bases/meshes.hpp"
#include "random_pieces.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "shoreline/boundary/trace.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

using Vec6 = Eigen::Vector<double, 6>;

std::vector<SplineCurve> fit(const std::vector<Piece>& pieces) {
  std::vector<SplineCurve> curves;
  for (const Piece& piece : pieces) curves.push_back(fit_spline(piece));
  return curves;
}

/// A closed polygon, one straight piece a side.
std::vector<SplineCurve> polygon(const std::vector<Vec2>& corner) {
  std::vector<SplineCurve> curves;
  for (std::size_t k = 0; k < corner.size(); ++k)
    curves.push_back(fit_spline(line(corner[k], corner[(k + 1) % corner.size()])));
  return curves;
}

Piece moved(Piece piece, double scale, const Vec2& shift) {
  for (Vec2& x : piece.points) x = scale * x + shift;
  return piece;
}

/// ∫ {1, x, y} dA of a region, as 1/(d + 2) ∮ f (x dy − y dx) over its outline.
Vec6 moments_of(const std::vector<SplineCurve>& curves) {
  const QuadratureRule rule = gauss(6);
  Vec6 sum = Vec6::Zero();
  for (const SplineCurve& curve : curves)
    for (const CubicSpan& span : curve.spans)
      for (Eigen::Index q = 0; q < rule.point.size(); ++q) {
        const Vec2 x = span.position(rule.point[q]);
        Vec6 part;
        part << 1.0 / 2.0, x.x() / 3.0, x.y() / 3.0, x.x() * x.x() / 4.0, x.x() * x.y() / 4.0, x.y() * x.y() / 4.0;
        sum += rule.weight[q] * cross(x, span.derivative(rule.point[q])) * part;
      }
  return sum;
}

Vec2 centroid(const std::array<Vec2, 3>& p) { return (p[0] + p[1] + p[2]) / 3.0; }

/// The sums of all sub-cells, in the coordinates of the curves.
Vec6 total(const TriangleMoments& moments, const TriangleGrid& grid, int divisions) {
  Vec6 sum = Vec6::Zero();
  for (std::size_t k = 0; k < moments.sub_cell.size(); ++k) {
    const Vec6 m = moments.moment.col(static_cast<Eigen::Index>(k));
    const Vec2 c = centroid(sub_cell(grid, divisions, moments.sub_cell[k]));
    Vec6 moved;
    moved << m[0], m[1] + m[0] * c.x(), m[2] + m[0] * c.y(), m[3] + 2.0 * m[1] * c.x() + m[0] * c.x() * c.x(),
        m[4] + m[1] * c.y() + m[2] * c.x() + m[0] * c.x() * c.y(), m[5] + 2.0 * m[2] * c.y() + m[0] * c.y() * c.y();
    sum += moved;
  }
  return sum;
}

/// What is wrong with moments; empty if nothing is.
std::string fault(const std::vector<SplineCurve>& curves, const TriangleGrid& grid, int divisions) {
  const TriangleMoments moments = triangle_moments(curves, grid, divisions);
  const Vec6 expected = moments_of(curves);
  const double extent =
      std::max(1.0, grid.bounds().lower.cwiseAbs().cwiseMax(grid.bounds().upper.cwiseAbs()).maxCoeff());
  const Vec6 error = total(moments, grid, divisions) - expected;
  if (std::abs(error[0]) > 1e-12 * expected[0]) return "area";
  if (error.segment<2>(1).norm() > 1e-12 * expected[0] * extent) return "first moments";
  if (error.tail<3>().norm() > 1e-12 * expected[0] * extent * extent) return "second moments";
  if (std::ranges::adjacent_find(moments.sub_cell, std::greater_equal{}) != moments.sub_cell.end()) return "order";
  for (std::size_t k = 0; k < moments.sub_cell.size(); ++k) {
    const Vec6 m = moments.moment.col(static_cast<Eigen::Index>(k));
    const auto p = sub_cell(grid, divisions, moments.sub_cell[k]);
    if (m[0] > 0.5 * twice_area(p[0], p[1], p[2]) * (1 + 1e-6)) return "more than whole";
    if (m[0] < 1e-6 * twice_area(p[0], p[1], p[2])) continue;  // of a sliver the centroid has fewer digits
    const Vec2 at = centroid(p) + m.segment<2>(1) / m[0];
    for (std::size_t i = 0; i < 3; ++i)
      if (twice_area(p[i], p[(i + 1) % 3], at) < -1e-6 * twice_area(p[0], p[1], p[2])) return "centroid outside";
  }
  return "";
}

/// The mesh, and its Powell-Sabin refinement.
std::vector<TriangleGrid> grids(const TriangleMesh& mesh) {
  std::vector<TriangleGrid> both;
  both.emplace_back(mesh);
  both.emplace_back(powell_sabin_refinement(mesh), powell_sabin_parts);
  return both;
}

/// The largest circle about the middle of a mesh's bounds that these hold.
std::pair<Vec2, double> middle_and_reach(const TriangleMesh& mesh) {
  const Box box = bounds(mesh);
  return {0.5 * (box.lower + box.upper), 0.5 * (box.upper - box.lower).minCoeff()};
}

/// Meshes that fill a rectangle, whose sides are parallel to the axes.
std::vector<TriangleMesh> filled(test::Random& random) {
  std::vector<TriangleMesh> all;
  for (const TrianglePattern pattern : {TrianglePattern::diagonal, TrianglePattern::four}) {
    all.push_back(test::lattice(random.whole(2, 9), random.whole(2, 9), pattern, random.vector(0.05, 2.0)));
    all.push_back(test::lattice(5, 6, pattern));
    test::jitter(all.back(), random);
  }
  all.push_back(delaunay(test::jittered_points(random.whole(3, 9), random.whole(3, 9), random)));
  const Vec2 shift = random.vector(-5.0, 5.0);
  for (TriangleMesh& mesh : all)
    for (Vec2& v : mesh.vertex) v += shift;
  return all;
}

}  // namespace

TEST_CASE("sub-cells tile their cell, each alike and counter-clockwise", "[boundary][triangle_moments]") {
  test::Random random(1);
  const TriangleGrid grid(test::lattice(2, 2, TrianglePattern::four, {1.3, 0.4}));
  for (const int divisions : {1, 2, 3, 8})
    for (Index cell = 0; cell < grid.cells(); ++cell) {
      const auto whole = corners(grid.mesh(), cell);
      const double share = twice_area(whole[0], whole[1], whole[2]) / (divisions * divisions);
      std::vector<std::array<Vec2, 3>> all;
      for (Index k = 0; k < divisions * divisions; ++k) {
        all.push_back(sub_cell(grid, divisions, cell * divisions * divisions + k));
        CHECK_THAT(twice_area(all.back()[0], all.back()[1], all.back()[2]), WithinAbs(share, 1e-14));
      }
      for (int draw = 0; draw < 20; ++draw) {
        const Vec2 x = test::inside(whole, random);
        CHECK(std::ranges::count_if(all, [&](const auto& p) {
                return twice_area(p[0], p[1], x) > 0 && twice_area(p[1], p[2], x) > 0 && twice_area(p[2], p[0], x) > 0;
              }) == 1);
      }
    }
}

TEST_CASE("sub-cells sum to the moments of random smooth loops", "[boundary][triangle_moments]") {
  test::Random random(2);
  test::RandomPieces pieces(2);
  for (int draw = 0; draw < 60; ++draw)
    for (const TriangleMesh& mesh : filled(random)) {
      const auto [middle, reach] = middle_and_reach(mesh);
      const std::vector<SplineCurve> loop = fit({moved(pieces.star(), random.uniform(0.2, 0.8) * reach, middle)});
      const int divisions = random.whole(1, 4);
      for (const TriangleGrid& grid : grids(mesh)) {
        const std::string found = fault(loop, grid, divisions);
        if (!found.empty()) FAIL("draw " << draw << ", " << grid.cells() << " cells: " << found);
      }
    }
}

TEST_CASE("sub-cells of any mesh sum to the area of a small hole-free loop in one of its triangles",
          "[boundary][triangle_moments]") {
  test::Random random(3);
  test::RandomPieces pieces(3);
  for (int draw = 0; draw < 20; ++draw)
    for (const auto& [name, mesh] : test::meshes(random)) {
      CAPTURE(draw, name);
      const auto p = corners(mesh, random.whole(0, static_cast<Index>(mesh.triangle.size()) - 1));
      const double perimeter = (p[1] - p[0]).norm() + (p[2] - p[1]).norm() + (p[0] - p[2]).norm();
      const double inradius = twice_area(p[0], p[1], p[2]) / perimeter;
      const Vec2 incentre =
          ((p[2] - p[1]).norm() * p[0] + (p[0] - p[2]).norm() * p[1] + (p[1] - p[0]).norm() * p[2]) / perimeter;
      const std::vector<SplineCurve> loop = fit({moved(pieces.star(), 0.7 * inradius, incentre)});
      for (const TriangleGrid& grid : grids(mesh))
        for (const int divisions : {1, 3}) CHECK(fault(loop, grid, divisions) == "");
    }
}

TEST_CASE("a body as large as its mesh covers every sub-cell whole", "[boundary][triangle_moments]") {
  test::Random random(4);
  for (int draw = 0; draw < 10; ++draw)
    for (const TriangleMesh& mesh : filled(random)) {
      const double rounding = GENERATE(0.0, 4e-16, -4e-16, 1e-10, -1e-10);
      const Box box = bounds(mesh);
      const Vec2 out = Vec2::Constant(rounding);
      const Vec2 low = box.lower - out;
      const Vec2 high = box.upper + out;
      const std::vector<SplineCurve> body = polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
      for (const TriangleGrid& grid : grids(mesh)) {
        const TriangleMoments moments = triangle_moments(body, grid, 2);
        CHECK(static_cast<Index>(moments.sub_cell.size()) == 4 * grid.cells());
        CHECK(fault(body, grid, 2) == "");
      }
    }
}

TEST_CASE("polygons along mesh lines and through vertices cover their triangles whole and no other",
          "[boundary][triangle_moments]") {
  for (const TrianglePattern pattern : {TrianglePattern::diagonal, TrianglePattern::four})
    for (const double rounding : {0.0, 3e-16, -3e-16, 1e-10, -1e-10}) {
      const TriangleMesh mesh = test::lattice(6, 6, pattern);
      const Vec2 off(rounding, -rounding);
      // a diamond along diagonals of the pattern `four`, and a triangle along the one of `diagonal`
      const std::vector<SplineCurve> body = pattern == TrianglePattern::four
                                                ? polygon({Vec2(3, 1) + off, Vec2(5, 3), Vec2(3, 5) - off, Vec2(1, 3)})
                                                : polygon({Vec2(1, 1) + off, Vec2(5, 5), Vec2(1, 5) - off});
      for (const TriangleGrid& grid : grids(mesh))
        for (const int divisions : {1, 2, 3}) {
          const TriangleMoments moments = triangle_moments(body, grid, divisions);
          double whole = 0.0;
          double rest = 0.0;
          for (std::size_t k = 0; k < moments.sub_cell.size(); ++k) {
            const auto p = sub_cell(grid, divisions, moments.sub_cell[k]);
            const double share = moments.moment(0, static_cast<Eigen::Index>(k)) / (0.5 * twice_area(p[0], p[1], p[2]));
            (share > 0.5 ? whole : rest) += moments.moment(0, static_cast<Eigen::Index>(k));
          }
          CHECK_THAT(whole, WithinAbs(8.0, 1e-8));
          CHECK_THAT(rest, WithinAbs(0.0, std::abs(rounding) * 10.0));
          CHECK(fault(body, grid, divisions) == "");
        }
    }
}

TEST_CASE("loops through vertices, along edges and with holes have their moments", "[boundary][triangle_moments]") {
  test::Random random(5);
  for (int draw = 0; draw < 40; ++draw) {
    const TriangleMesh mesh = delaunay(test::jittered_points(9, 9, random));
    const auto vertex = [&](Index i, Index j) { return mesh.vertex[static_cast<std::size_t>(i + 10 * j)]; };
    Piece smooth{.name = "loop", .closed = true};  // tracking points on vertices
    for (const auto& [i, j] : std::vector<std::pair<Index, Index>>{{2, 2}, {5, 1}, {7, 3}, {7, 6}, {4, 7}, {2, 5}})
      smooth.points.push_back(vertex(i, j));
    std::vector<Vec2> edges;  // an outline of whole triangles
    for (std::size_t t = 0; t < mesh.triangle.size() && edges.empty(); ++t)
      if (const auto p = corners(mesh, static_cast<Index>(t)); (p[0] - Vec2(4.5, 4.5)).norm() < 1.5)
        edges = {p[0], p[1], p[2]};
    const std::vector<SplineCurve> drilled = fit({smooth, circle(vertex(4, 4), random.uniform(0.1, 0.9), 9, true)});
    for (const TriangleGrid& grid : grids(mesh))
      for (const int divisions : {1, 2, 5}) {
        CAPTURE(draw, divisions);
        CHECK(fault(fit({smooth}), grid, divisions) == "");
        CHECK(fault(polygon(edges), grid, divisions) == "");
        CHECK(fault(drilled, grid, divisions) == "");
      }
    const TriangleGrid grid(mesh);
    CHECK(triangle_moments(polygon(edges), grid, 3).sub_cell.size() == 9);
  }
}

TEST_CASE("a loop that touches a line of sub-cells in the middle of a span", "[boundary][triangle_moments]") {
  const bool hole = GENERATE(false, true);
  const Vec2 centre(2.25, 2.95);
  Piece round = circle({0, 0}, 1.0, 4, hole);
  for (Vec2& x : round.points) x = Eigen::Rotation2Dd(0.25 * std::numbers::pi) * x;
  SplineCurve loop = fit_spline(round);  // its highest point is the middle of a span
  const double radius = loop.spans[0].position(0.5).norm() * (1.0 + 1e-14);
  for (CubicSpan& span : loop.spans)
    for (Vec2& x : span.control) x = centre + 0.05 / radius * x;  // touches y = 3
  std::vector<SplineCurve> body{loop};
  if (hole)
    for (const SplineCurve& side : polygon({{0.1, 0.1}, {3.9, 0.1}, {3.9, 3.9}, {0.1, 3.9}})) body.push_back(side);
  for (const TriangleGrid& grid : grids(test::lattice(2, 2, TrianglePattern::diagonal, {2, 2})))
    for (const int divisions : {1, 2, 4}) CHECK(fault(body, grid, divisions) == "");
}

TEST_CASE("what bulges out of the grid belongs to the cells on its border", "[boundary][triangle_moments]") {
  test::Random random(6);
  const TriangleMesh mesh = delaunay(test::jittered_points(5, 5, random));
  const double bulge = GENERATE(0.2, 0.7);
  const double rise = bulge * border_slack;
  const Piece top{.name = "top", .points = {Vec2(5, 5), Vec2(2.5, 5 + rise), Vec2(0, 5)}};
  std::vector<SplineCurve> body = polygon({{0, 1}, {5, 1}, {5, 5}, {0, 5}});
  body[2] = fit_spline(top);
  for (const TriangleGrid& grid : grids(mesh))
    for (const int divisions : {1, 3}) {
      const Vec6 expected = moments_of(body);
      CHECK(expected[0] > 20.0 + 2.0 * rise);
      CHECK((total(triangle_moments(body, grid, divisions), grid, divisions) - expected).norm() < 1e-11);
    }
}

TEST_CASE("triangle moments refuse a curve that leaves the grid, and no divisions", "[boundary][triangle_moments]") {
  const TriangleGrid grid(test::lattice(3, 3, TrianglePattern::diagonal));
  CHECK_THROWS_AS(triangle_moments(polygon({{1, 1}, {3.5, 1}, {1, 2}}), grid, 1), OutsideGrid);
  CHECK_THROWS_WITH(triangle_moments(polygon({{1, 1}, {2, 1}, {1, 2}}), grid, 0),
                    Contains("divisions") && Contains("0"));
}
