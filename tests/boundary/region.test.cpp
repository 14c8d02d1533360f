#include "shoreline/boundary/region.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "random_pieces.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "shoreline/boundary/trace.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

std::vector<SplineCurve> fit(const std::vector<Piece>& pieces) {
  std::vector<SplineCurve> curves;
  for (const Piece& piece : pieces) curves.push_back(fit_spline(piece));
  return curves;
}

std::vector<SplineCurve> rectangle(const Vec2& low, const Vec2& high) {
  const Vec2 right(high.x(), low.y());
  const Vec2 left(low.x(), high.y());
  return fit({line(low, right), line(right, high), line(high, left), line(left, low)});
}

/// A quarter of a ring with a drilled hole, in open pieces and a closed one.
std::vector<SplineCurve> drilled_quarter_ring() {
  return fit({line({1, 0}, {3, 0}), arc({0, 0}, 3.0, 0.0, 90.0, 65), line({0, 3}, {0, 1}),
              arc({0, 0}, 1.0, 90.0, 0.0, 65), circle({1.4, 1.4}, 0.5, 128, true)});
}

double sum_of(const CellMoments& moments, Eigen::Index monomial) { return moments.moment.row(monomial).sum(); }

}  // namespace

TEST_CASE("a point is inside a circle exactly if it is nearer than the radius", "[boundary][region]") {
  const std::vector<SplineCurve> curves = fit({circle({0.2, -0.1}, 1.0, 256, false)});  // 1e-9 from a circle
  const Region region(curves);
  test::RandomPieces random(4);
  for (int draw = 0; draw < 20000; ++draw) {
    const Vec2 x(random.uniform(-1.3, 1.5), random.uniform(-1.5, 1.3));
    const double r = (x - Vec2(0.2, -0.1)).norm();
    if (std::abs(r - 1.0) > 2e-9) REQUIRE(region.contains(x) == (r < 1.0));
  }
  for (int k = -120; k <= 120; ++k) {  // rows through the ends of spans and the centre
    const Vec2 x(0.2 + k / 100.0, -0.1);
    if (std::abs(k) != 100) CHECK(region.contains(x) == (std::abs(k) < 100));
  }
}

TEST_CASE("a region has the holes and the area of its outline", "[boundary][region]") {
  const std::vector<SplineCurve> curves = drilled_quarter_ring();
  const Region region(curves);
  CHECK(region.contains({2.5, 0.5}));
  CHECK_FALSE(region.contains({1.4, 1.4}));
  CHECK_FALSE(region.contains({0.5, 0.5}));
  CHECK_FALSE(region.contains({2.2, -1e-9}));
  CHECK_FALSE(region.contains({10.0, 1.0}));
  CHECK_THAT(region.area(), WithinAbs(std::numbers::pi * (2.0 - 0.25), 1e-7));
}

TEST_CASE("corners of a box in lattice rows are no trouble to the inside test", "[boundary][region]") {
  const std::vector<SplineCurve> curves = rectangle({0, 0}, {2, 1});
  const Region region(curves);
  for (const double y : {0.0, 0.5, 1.0}) {
    CHECK_FALSE(region.contains({-1, y}));
    CHECK_FALSE(region.contains({3, y}));
  }
  CHECK(region.contains({1, 0.5}));
  CHECK_THAT(region.area(), WithinAbs(2.0, 1e-15));
}

TEST_CASE("a small gap between pieces leaves no leak", "[boundary][region]") {
  std::vector<SplineCurve> curves = rectangle({0, 0}, {1, 1});
  curves[1].spans[0].control[0] += Vec2(0, 1e-5);
  const Region region(curves);
  CHECK(region.contains({0.5, 5e-6}));
  CHECK_FALSE(region.contains({-0.5, 5e-6}));
  CHECK_THAT(region.area(), WithinAbs(1.0, 1e-12));
  const CellMoments moments = cell_moments(curves, {{-1, -1}, {0.3, 0.3}, {10, 10}}, 0);
  CHECK_THAT(sum_of(moments, 0), WithinAbs(1.0, 1e-12));
}

TEST_CASE("the bounds of a region are those of its outline, not of control points", "[boundary][region]") {
  test::RandomPieces random(8);
  for (int draw = 0; draw < 50; ++draw) {
    const std::vector<SplineCurve> curve = fit({random.star()});
    Box sampled{curve[0].spans[0].control[0], curve[0].spans[0].control[0]};
    for (const CubicSpan& span : curve[0].spans)
      for (int k = 0; k <= 1000; ++k) {
        sampled.lower = sampled.lower.cwiseMin(span.position(k / 1000.0));
        sampled.upper = sampled.upper.cwiseMax(span.position(k / 1000.0));
      }
    const Box box = Region(curve).bounds();
    CHECK((sampled.lower - box.lower).minCoeff() >= -1e-15);
    CHECK((box.upper - sampled.upper).minCoeff() >= -1e-15);
    CHECK((sampled.lower - box.lower).maxCoeff() < 1e-5);
    CHECK((box.upper - sampled.upper).maxCoeff() < 1e-5);
  }
}

TEST_CASE("near the outline is what is at most that far from it", "[boundary][region]") {
  const std::vector<SplineCurve> curves = fit({circle({0, 0}, 1.0, 256, false)});
  const Region region(curves);
  test::RandomPieces random(5);
  for (int draw = 0; draw < 2000; ++draw) {
    const Vec2 x(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5));
    const double distance = random.uniform(0.01, 0.3);
    const double gap = std::abs(x.norm() - 1.0);
    if (std::abs(gap - distance) > 2e-9) REQUIRE(region.near_outline(x, distance) == (gap < distance));
  }
}

TEST_CASE("cut cells of random curves sum to the loop's area", "[boundary][region]") {
  test::RandomPieces random(6);
  for (int draw = 0; draw < 10000; ++draw) {
    const bool star = draw % 2 == 0;
    const std::vector<SplineCurve> curve = fit({star ? random.star() : random.wild()});
    const QuadrilateralGrid grid = random.grid_around(curve.front());
    const CellMoments moments = cell_moments(curve, grid, 0);
    const double whole = star ? Region(curve).area() : (grid.bounds().upper - grid.bounds().lower).prod();
    REQUIRE(std::abs(sum_of(moments, 0) - Region(curve).area()) <= 1e-12 * whole);
    REQUIRE(std::ranges::adjacent_find(moments.cell, std::greater_equal{}) == moments.cell.end());
    const double cell = grid.spacing().prod();
    if (star) REQUIRE((moments.moment.minCoeff() >= 0.0 && moments.moment.maxCoeff() <= cell * (1 + 1e-12)));
  }
}

TEST_CASE("cells sum to the first and second moments of a circle", "[boundary][region]") {
  const Vec2 centre(0.3, 0.2);
  const double r = 1.1;
  const std::vector<SplineCurve> curves = fit({circle(centre, r, 2048, false)});  // 3e-13 from a circle
  const QuadrilateralGrid grid({-1, -1}, {0.17, 0.23}, {16, 12});
  const CellMoments moments = cell_moments(curves, grid, 2);
  double area = 0.0;
  Vec2 first = Vec2::Zero();
  Vec3 second = Vec3::Zero();  // xx, yy, xy about the circle's centre
  for (std::size_t k = 0; k < moments.cell.size(); ++k) {
    const Eigen::VectorXd m = moments.moment.col(static_cast<Eigen::Index>(k));
    const Vec2 c = grid.corner(moments.cell[k]) + 0.5 * grid.spacing() - centre;
    area += m[0];
    first += m.segment<2>(1) + m[0] * c;
    second += Vec3(m[3] + 2 * c.x() * m[1] + c.x() * c.x() * m[0], m[5] + 2 * c.y() * m[2] + c.y() * c.y() * m[0],
                   m[4] + c.x() * m[2] + c.y() * m[1] + c.x() * c.y() * m[0]);
  }
  const double disc = std::numbers::pi * r * r;
  CHECK_THAT(area, WithinAbs(disc, 1e-11));
  CHECK(first.norm() <= 1e-11);
  CHECK((second - disc * r * r / 4.0 * Vec3(1, 1, 0)).norm() <= 1e-11);
}

TEST_CASE("moments of high order are those of a rectangle in a cell", "[boundary][region]") {
  const std::vector<SplineCurve> curves = rectangle({0.1, 0.3}, {0.7, 0.8});
  const QuadrilateralGrid cell({0, 0}, {1, 1}, {1, 1});
  const CellMoments moments = cell_moments(curves, cell, max_moment_order);
  REQUIRE(moments.cell == std::vector<Index>{0});
  const auto integral = [](double from, double to, int power) {
    return (std::pow(to, power + 1) - std::pow(from, power + 1)) / (power + 1);
  };
  for (int degree = 0, m = 0; degree <= max_moment_order; ++degree)
    for (int b = 0; b <= degree; ++b, ++m)
      CHECK_THAT(moments.moment(m, 0), WithinAbs(integral(-0.4, 0.2, degree - b) * integral(-0.2, 0.3, b), 1e-16));
}

TEST_CASE("a cell's moments do not depend on the cells around it", "[boundary][region]") {
  test::RandomPieces random(7);
  for (int draw = 0; draw < 50; ++draw) {
    const std::vector<SplineCurve> curve = fit({random.star()});
    const QuadrilateralGrid fine({-2, -2}, {0.25, 0.25}, {16, 16});
    const QuadrilateralGrid coarse({-2, -2}, {0.5, 0.5}, {8, 8});
    std::map<Index, Vec3> sum;  // area and first moments about (0, 0), of the four cells in each coarse one
    const auto add = [&](const CellMoments& moments, const QuadrilateralGrid& grid, double sign) {
      for (std::size_t k = 0; k < moments.cell.size(); ++k) {
        const Vec3 m = moments.moment.col(static_cast<Eigen::Index>(k)).head<3>();
        const Vec2 centre = grid.corner(moments.cell[k]) + 0.5 * grid.spacing();
        Vec3& total = sum.try_emplace(*coarse.locate(centre, 0), Vec3::Zero()).first->second;
        total += sign * Vec3(m[0], m[1] + centre.x() * m[0], m[2] + centre.y() * m[0]);
      }
    };
    add(cell_moments(curve, fine, 1), fine, 1.0);
    add(cell_moments(curve, coarse, 1), coarse, -1.0);
    for (const auto& [cell, difference] : sum) REQUIRE(difference.norm() <= 1e-14);
  }
}

TEST_CASE("cells that no curve meets are full, exactly, and edges on grid lines leave nothing beside them",
          "[boundary]") {
  const QuadrilateralGrid grid({-1, -1}, {0.1, 0.1}, {40, 40});
  const CellMoments moments = cell_moments(rectangle({0, 0}, {1.0, 1.5}), grid, 2);
  CHECK(moments.cell.size() == 150);
  for (Eigen::Index k = 0; k < moments.moment.cols(); ++k) {
    const Index cell = moments.cell[static_cast<std::size_t>(k)];
    const bool inner = cell % 40 > 10 && cell % 40 < 19 && cell / 40 > 10 && cell / 40 < 24;
    const double tolerance = inner ? 1e-17 : 1e-15;
    CHECK_THAT(moments.moment(0, k), WithinAbs(0.01, tolerance));
    CHECK_THAT(moments.moment(1, k), WithinAbs(0.0, inner ? 0.0 : 1e-16));
    CHECK_THAT(moments.moment(3, k), WithinAbs(0.0001 / 12, inner ? 1e-20 : 1e-16));
  }
}

TEST_CASE("moments refuse a lattice that does not hold the curve, and an order out of range", "[boundary][region]") {
  const std::vector<SplineCurve> curves = rectangle({0, 0}, {1, 1});
  CHECK_THROWS_AS(cell_moments(curves, {{0, 0}, {0.3, 0.3}, {3, 4}}, 0), OutsideGrid);
  CHECK_THROWS_WITH(cell_moments(curves, {{0, 0}, {0.5, 0.5}, {2, 2}}, 9), Contains("0 to 8") && Contains("9"));
  CHECK_THAT(sum_of(cell_moments(curves, {{0, 0}, {0.5, 0.5}, {2, 2}}, 0), 0), WithinAbs(1.0, 1e-15));
}
