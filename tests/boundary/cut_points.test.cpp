#include "shoreline/boundary/cut_points.hpp"

#include <catch2/catch.hpp>

#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
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
