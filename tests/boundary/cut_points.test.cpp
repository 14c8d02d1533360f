#include "shoreline/boundary/cut_points.hpp"

#include <catch2/catch.hpp>

#include "../random.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::vector<SplineCurve> polygon(const std::vector<Vec2>& x) {
  std::vector<SplineCurve> curves;
  for (std::size_t k = 0; k < x.size(); ++k) curves.push_back(fit_spline(line(x[k], x[(k + 1) % x.size()])));
  return curves;
}

const Box unit{Vec2(0.0, 0.0), Vec2(1.0, 1.0)};

}  // namespace

TEST_CASE("points of a cut rectangle have area and centroid of the part inside, however small",
          "[boundary][cut_points]") {
  for (const double size : {0.8, 0.1, 1e-3, 1e-5}) {
    const CutPoints cut(polygon({{-1.0, -1.0}, {size + 1.0, -1.0}, {-1.0, size + 1.0}}));  // x + y < size in the cell
    const AreaPoints points = cut.in(unit, {6, 6});
    CAPTURE(size);
    CHECK(points.area.size() >= 9);
    CHECK((points.area.array() > 0.0).all());
    CHECK_THAT(points.area.sum(), WithinRel(0.5 * size * size, 1e-9));
    const Vec2 centroid = points.position * points.area / points.area.sum();
    CHECK((centroid - Vec2(size / 3.0, size / 3.0)).norm() < 1e-9 * size);
    CHECK(((points.position.colwise().sum()).array() < size).all());
  }
}

TEST_CASE("a rectangle inside has a point in each sub-rectangle, one outside has none", "[boundary][cut_points]") {
  const CutPoints cut(polygon({{-1.0, -1.0}, {3.0, -1.0}, {3.0, 3.0}, {-1.0, 3.0}}));
  const AreaPoints points = cut.in(unit, {3, 4});
  CHECK(points.area.size() == 12);
  CHECK((points.area.array() - 1.0 / 12.0).abs().maxCoeff() < 1e-15);
  CHECK(cut.in({Vec2(4.0, 0.0), Vec2(5.0, 1.0)}, {3, 4}).area.size() == 0);
}

TEST_CASE("points have the areas and centroids of all covered sub-rectangles, whatever runs through them",
          "[boundary][cut_points]") {
  test::Random random(7);
  constexpr int n = 6;  // sub-rectangles a side
  for (int draw = 0; draw < 40; ++draw) {
    const double radius = random.uniform(0.2, 1.2);  // from a disc within the unit square to one cut by it
    std::vector<SplineCurve> body{fit_spline(circle(random.vector(0.3, 0.7), radius, 12, false))};
    if (draw % 2 == 0) body = polygon({{-1.0, 0.5}, {0.5, 0.5}, {0.5, -1.0}, {1.5, -1.0}, {1.5, 2.0}, {-1.0, 2.0}});
    if (draw % 4 == 0) body.push_back(fit_spline(circle({0.75, 0.75}, 0.3 * radius, 8, true)));  // a hole, or a bay
    const AreaPoints points = CutPoints(body).in(unit, {n, n});
    const QuadrilateralGrid lattice({-1.0, -1.0}, {1.0 / n, 1.0 / n}, {4 * n, 4 * n});
    const CellMoments expected = cell_moments(body, lattice, 1);
    CAPTURE(draw, radius);
    Eigen::Index p = 0;
    for (std::size_t k = 0; k < expected.cell.size(); ++k) {
      const Vec2 centre = lattice.corner(expected.cell[k]) + 0.5 * lattice.spacing();
      if (centre.minCoeff() < 0.0 || centre.maxCoeff() > 1.0) continue;
      const Vec3 m = expected.moment.col(static_cast<Eigen::Index>(k));
      REQUIRE(p < points.area.size());
      CHECK_THAT(points.area[p], WithinAbs(m[0], 1e-14));
      CHECK((points.area[p] * (points.position.col(p) - centre) - m.tail<2>()).norm() < 1e-14);
      ++p;
    }
    CHECK(p == points.area.size());
  }
}
