#include "shoreline/engine/fill.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "../random.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// The sides of a square, counter-clockwise.
std::vector<SplineCurve> square(const Vec2& centre, double side, double angle) {
  std::vector<SplineCurve> curves;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Rotation2Dd quarter(angle + k * std::numbers::pi / 2.0);
    curves.push_back(
        fit_spline(line(centre + quarter * Vec2(-side / 2, -side / 2), centre + quarter * Vec2(side / 2, -side / 2))));
  }
  return curves;
}

/// An axis-parallel rectangle with exact coordinates.
std::vector<SplineCurve> rectangle(const Vec2& lower, const Vec2& upper) {
  const Vec2 right(upper.x(), lower.y());
  const Vec2 left(lower.x(), upper.y());
  return {fit_spline(line(lower, right)), fit_spline(line(right, upper)), fit_spline(line(upper, left)),
          fit_spline(line(left, lower))};
}

std::vector<SplineCurve> disc(const Vec2& centre, double radius) {
  return {fit_spline(circle(centre, radius, 12, false))};
}

/// A grid with any origin and spacing that holds the circle of radius 1 about the origin.
QuadrilateralGrid grid_around(test::Random& random) {
  const Vec2 spacing = random.vector(0.1, 0.7);
  const Vec2 lower = Vec2(-1.05, -1.05) - random.vector(0.0, 1.0).cwiseProduct(spacing);
  return {lower, spacing, {static_cast<Index>(2.2 / spacing.x()) + 3, static_cast<Index>(2.2 / spacing.y()) + 3}};
}

std::vector<SplineCurve> random_body(test::Random& random) {
  if (random.whole(0, 1) == 0) return disc(random.vector(-0.3, 0.3), random.uniform(0.3, 0.7));
  return square(random.vector(-0.2, 0.2), random.uniform(0.4, 1.0), random.uniform(0.0, 3.0));
}

}  // namespace

TEST_CASE("clipped volumes sum to the area of the body, and their centroid is the body's", "[engine][fill]") {
  test::Random random(1);
  for (int draw = 0; draw < 100; ++draw) {
    const std::vector<SplineCurve> curves = random_body(random);
    const QuadrilateralGrid grid = grid_around(random);
    const int n = random.whole(1, 3);
    const MaterialPoints points = fill_lattice(curves, grid, {{n, 4 - n}, VolumeRule::clipped});
    const double area = Region(curves).area();
    CHECK(points.volume.minCoeff() > 0.0);
    CHECK_THAT(points.volume.sum(), WithinRel(area, 1e-12));

    const MaterialPoints finer = fill_lattice(curves, grid, {{n + 1, n + 2}, VolumeRule::clipped});
    const Vec2 centroid = points.position * points.volume / area;
    CHECK_THAT((centroid - finer.position * finer.volume / area).norm(), WithinAbs(0.0, 1e-12));
  }
}

TEST_CASE("where the outline runs along sides of sub-cells, rounding leaves no points", "[engine][fill]") {
  const QuadrilateralGrid grid(Vec2(0.0, 0.0), Vec2(0.01, 0.01), {125, 125});
  for (const double start : {0.1, 0.07, 0.03}) {  // no binary fractions: lines and outline differ by rounding
    const std::vector<Vec2> corner{
        {start, start}, {start + 1.0, start}, {start + 1.0, start + 1.0}, {start, start + 1.0}};
    std::vector<SplineCurve> curves;
    for (std::size_t k = 0; k < 4; ++k)
      curves.push_back(fit_spline({.name = "side", .points = {corner[k], corner[(k + 1) % 4]}}));
    const MaterialPoints points = fill_lattice(curves, grid, {.per_cell = {3, 3}});
    CHECK(points.size() == 90000);
    CHECK(points.volume.minCoeff() > 0.99 * 1e-4 / 9.0);
  }
}

TEST_CASE("each clipped point lies in its own sub-cell", "[engine][fill]") {
  test::Random random(2);
  for (int draw = 0; draw < 50; ++draw) {
    const std::vector<SplineCurve> curves = random_body(random);
    const QuadrilateralGrid grid = grid_around(random);
    const int n = random.whole(1, 3);
    const MaterialPoints points = fill_lattice(curves, grid, {{n, n}, VolumeRule::clipped});
    const QuadrilateralGrid lattice(grid.bounds().lower, grid.spacing() / n, {grid.columns() * n, grid.rows() * n});
    std::vector<Index> taken;
    for (Index p = 0; p < points.size(); ++p) {
      taken.push_back(lattice.locate(points.position.col(p), 0).value());
      CHECK(points.volume[p] <= lattice.spacing().prod() * (1.0 + 1e-12));
    }
    std::ranges::sort(taken);
    CHECK(std::ranges::adjacent_find(taken) == taken.end());
  }
}

TEST_CASE("the lattice rule has the whole sub-cell at each centre inside", "[engine][fill]") {
  test::Random random(3);
  for (int draw = 0; draw < 30; ++draw) {
    const std::vector<SplineCurve> curves = random_body(random);
    const QuadrilateralGrid grid = grid_around(random);
    const int n = random.whole(1, 3);
    const MaterialPoints points = fill_lattice(curves, grid, {{n, n}, VolumeRule::lattice});
    const QuadrilateralGrid lattice(grid.bounds().lower, grid.spacing() / n, {grid.columns() * n, grid.rows() * n});
    const Region region(curves);
    Index inside = 0;
    for (Index cell = 0; cell < lattice.cells(); ++cell)
      if (region.contains(lattice.corner(cell) + 0.5 * lattice.spacing())) ++inside;
    CHECK(points.size() == inside);
    for (Index p = 0; p < points.size(); ++p) {
      CHECK(region.contains(points.position.col(p)));
      CHECK_THAT(points.volume[p], WithinRel(lattice.spacing().prod(), 1e-12));
    }
  }
}

TEST_CASE("a vertex lattice has halves on edges and quarters at corners", "[engine][fill]") {
  const std::vector<SplineCurve> body = rectangle({0.1, 0.3}, {1.1, 0.9});
  const Vec2 cell_size(0.4, 0.4);  // sub-cells of 0.2: 6 × 4 points
  const MaterialPoints points = fill_vertex(body, cell_size, {.count = {2, 2}});
  const MaterialPoints whole = fill_vertex(body, cell_size, {.count = {2, 2}, .volumes = VolumeRule::lattice});
  REQUIRE(points.size() == 24);
  REQUIRE(whole.size() == 24);
  CHECK_THAT(points.volume.sum(), WithinRel(0.6, 1e-12));
  CHECK_THAT(whole.volume.sum(), WithinRel(24 * 0.04, 1e-12));
  for (Index p = 0; p < 24; ++p) {
    const Vec2 x = points.position.col(p);
    const bool left_or_right = std::abs(x.x() - 0.1) < 1e-9 || std::abs(x.x() - 1.1) < 1e-9;
    const bool low_or_high = std::abs(x.y() - 0.3) < 1e-9 || std::abs(x.y() - 0.9) < 1e-9;
    const double share = (left_or_right ? 0.5 : 1.0) * (low_or_high ? 0.5 : 1.0);
    CHECK_THAT(points.volume[p], WithinAbs(0.04 * share, 1e-14));
    CHECK_THAT(((x - Vec2(0.1, 0.3)) / 0.2 - ((x - Vec2(0.1, 0.3)) / 0.2).array().round().matrix()).norm(),
               WithinAbs(0.0, 1e-12));
  }
}

TEST_CASE("a body that no vertex lattice fits is refused with its measures", "[engine][fill]") {
  CHECK_THROWS_WITH(fill_vertex(rectangle({0.0, 0.0}, {1.0, 0.7}), {0.4, 0.4}, {.count = {2, 2}}),
                    Contains("5 x 3.5 sub-cells") && Contains("0.2 m"));
  CHECK_THROWS_WITH(fill_vertex(disc(Vec2::Zero(), 1.0), {0.5, 0.5}, {.count = {1, 1}}),
                    Contains("outline along the lattice") && Contains("m²"));
}

TEST_CASE("a vertex lattice that is given across the body has its number of points from side to side",
          "[engine][fill]") {
  const std::vector<SplineCurve> cantilever = rectangle({0.25, 3.5}, {10.25, 5.5});  // 10 m x 2 m, off the grid's nodes
  const VertexFill across{.count = {28, 8}, .across = true};
  const MaterialPoints points = fill_vertex(cantilever, {0.75, 0.75}, across);
  REQUIRE(points.size() == 28 * 8);
  CHECK_THAT(points.volume.sum(), WithinRel(20.0, 1e-12));
  CHECK((points.position.rowwise().minCoeff() - Vec2(0.25, 3.5)).norm() < 1e-12);
  CHECK((points.position.rowwise().maxCoeff() - Vec2(10.25, 5.5)).norm() < 1e-12);
  CHECK((points.position * points.volume / 20.0 - Vec2(5.25, 4.5)).norm() < 1e-12);
  const double whole = 10.0 / 27.0 * 2.0 / 7.0;
  CHECK_THAT(points.volume.maxCoeff(), WithinRel(whole, 1e-9));
  CHECK_THAT(points.volume.minCoeff(), WithinRel(whole / 4.0, 1e-9));
  CHECK(fill_vertex(cantilever, {3.0, 0.1}, across).position == points.position);  // whatever the grid
  CHECK_THROWS_WITH(fill_vertex(cantilever, {0.75, 0.75}, {.count = {28, 1}, .across = true}),
                    Contains("at least 2 points across") && Contains("28 x 1"));
}

TEST_CASE("equal volumes share the area of the body among the points of the lattice", "[engine][fill]") {
  test::Random random(4);
  for (int draw = 0; draw < 20; ++draw) {
    const std::vector<SplineCurve> curves = random_body(random);
    const QuadrilateralGrid grid = grid_around(random);
    const MaterialPoints lattice = fill_lattice(curves, grid, {{2, 3}, VolumeRule::lattice});
    const MaterialPoints equal = fill_lattice(curves, grid, {{2, 3}, VolumeRule::equal});
    CHECK(equal.position == lattice.position);
    CHECK_THAT(equal.volume.sum(), WithinRel(Region(curves).area(), 1e-12));
    CHECK(equal.volume.minCoeff() == equal.volume.maxCoeff());
  }
  const MaterialPoints vertex =
      fill_vertex(rectangle({0.0, 0.0}, {3.0, 2.0}), {1.0, 1.0}, {.count = {1, 1}, .volumes = VolumeRule::equal});
  CHECK(vertex.size() == 12);
  CHECK((vertex.volume.array() - 0.5).abs().maxCoeff() < 1e-15);
}

TEST_CASE("points on the outline are marked with the way in, points inside are not", "[engine][fill]") {
  const std::vector<SplineCurve> body = rectangle({0.0, 0.0}, {1.0, 1.0});
  MaterialPoints points = fill_vertex(body, {0.25, 0.25}, {.count = {1, 1}});
  mark_outline(Region(body), 1e-9, points);
  CHECK(points.on_outline.size() == 16);
  for (const OutlinePoint& edge : points.on_outline) {
    const Vec2 x = points.position.col(edge.point);
    CHECK(((x.array() < 1e-9) || (x.array() > 1.0 - 1e-9)).any());
    CHECK_THAT(edge.inward.norm(), WithinAbs(1.0, 1e-14));
    const Vec2 to_middle(x.x() < 1e-9         ? 1.0
                         : x.x() > 1.0 - 1e-9 ? -1.0
                                              : 0.0,
                         x.y() < 1e-9         ? 1.0
                         : x.y() > 1.0 - 1e-9 ? -1.0
                                              : 0.0);
    CHECK_THAT((edge.inward - to_middle.normalized()).norm(), WithinAbs(0.0, 1e-2));
  }
}

TEST_CASE("sub-cells across the body are those of its box, whatever lies under it", "[engine][fill]") {
  const std::vector<SplineCurve> body = rectangle({0.1, 0.3}, {1.3, 0.9});
  for (const VolumeRule volumes : {VolumeRule::clipped, VolumeRule::lattice, VolumeRule::equal}) {
    const MaterialPoints points = fill_lattice(body, AcrossFill{{6, 2}, volumes});
    REQUIRE(points.size() == 12);
    CHECK((points.volume.array() - 0.06).abs().maxCoeff() < 1e-14);
    for (Index p = 0; p < 12; ++p)
      CHECK((points.position.col(p) - Vec2(0.1 + 0.2 * (p % 6 + 0.5), 0.3 + 0.3 * (p / 6 + 0.5))).norm() < 1e-14);
  }
  // a circle of radius 1 through points that are not its extremes: the box is that of the curve
  Piece turned = circle({0.5, -2.0}, 1.0, 48, false);
  for (Vec2& x : turned.points) x = Vec2(0.5, -2.0) + Eigen::Rotation2Dd(0.03) * (x - Vec2(0.5, -2.0));
  const std::vector<SplineCurve> round{fit_spline(turned)};
  const MaterialPoints clipped = fill_lattice(round, AcrossFill{{9, 7}});
  CHECK_THAT(clipped.volume.sum(), WithinRel(std::numbers::pi, 1e-5));
  CHECK_THAT(clipped.volume.maxCoeff(), WithinRel(2.0 / 9.0 * 2.0 / 7.0, 1e-5));
}
