#include "shoreline/boundary/body_moments.hpp"

#include <catch2/catch.hpp>

#include "../bases/meshes.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"
#include "shoreline/bases/quadrilateral_grid.hpp"
#include "shoreline/bases/triangle_grid.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "shoreline/boundary/trace.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

std::vector<SplineCurve> drilled_disc() {
  return {fit_spline(circle({2.1, 1.9}, 1.4, 200, false)), fit_spline(circle({2.3, 1.7}, 0.6, 200, true))};
}

/// ∫ {1, x, y, x², xy, y²} of all cells together, about the origin.
Eigen::Vector<double, 6> total(const BodyMoments& moments) {
  Eigen::Vector<double, 6> sum = Eigen::Vector<double, 6>::Zero();
  for (Eigen::Index k = 0; k < moments.moment.cols(); ++k) {
    const Vec2 c = moments.centre.col(k);
    const auto m = moments.moment.col(k);
    Eigen::Vector<double, 6> moved;
    moved << m[0], m[1] + m[0] * c.x(), m[2] + m[0] * c.y(), m[3] + 2.0 * m[1] * c.x() + m[0] * c.x() * c.x(),
        m[4] + m[1] * c.y() + m[2] * c.x() + m[0] * c.x() * c.y(), m[5] + 2.0 * m[2] * c.y() + m[0] * c.y() * c.y();
    sum += moved;
  }
  return sum;
}

/// The same of a disc by its closed form.
Eigen::Vector<double, 6> disc(const Vec2& c, double radius) {
  const double area = std::numbers::pi * radius * radius;
  const double own = 0.25 * radius * radius;
  Eigen::Vector<double, 6> m;
  m << 1.0, c.x(), c.y(), own + c.x() * c.x(), c.x() * c.y(), own + c.y() * c.y();
  return area * m;
}

}  // namespace

TEST_CASE("moments of cells sum to those of the body on every kind of grid", "[boundary][body_moments]") {
  const Eigen::Vector<double, 6> expected = disc({2.1, 1.9}, 1.4) - disc({2.3, 1.7}, 0.6);
  test::Random random(4);
  const TriangleMesh mesh = delaunay(test::jittered_points(4, 4, random));
  const QuadrilateralGrid rectangles({0.0, 0.0}, {0.31, 0.27}, {14, 16});
  const TriangleGrid triangles(mesh);
  const TriangleGrid parts(powell_sabin_refinement(mesh), powell_sabin_parts);
  for (const Grid* grid : {static_cast<const Grid*>(&rectangles), static_cast<const Grid*>(&triangles),
                           static_cast<const Grid*>(&parts)}) {
    const BodyMoments moments = body_moments(drilled_disc(), *grid, 2);
    CHECK((total(moments) - expected).norm() < 1e-6);  // a spline through 200 points of a circle
    for (Eigen::Index k = 0; k < moments.moment.cols(); ++k)
      CHECK(moments.moment(0, k) <= moments.whole[k] * (1.0 + 1e-12));
  }
}

TEST_CASE("a cell that the body covers whole has the moments of the cell", "[boundary][body_moments]") {
  const TriangleGrid triangles(test::lattice(16, 16, TrianglePattern::four, {0.25, 0.25}));
  const BodyMoments moments = body_moments(drilled_disc(), triangles, 2);
  int whole = 0;
  for (std::size_t k = 0; k < moments.cell.size(); ++k) {
    const auto m = moments.moment.col(static_cast<Eigen::Index>(k));
    if (m[0] < moments.whole[static_cast<Eigen::Index>(k)] * (1.0 - 1e-12)) continue;
    ++whole;
    const auto p = corners(triangles.mesh(), moments.cell[k]);
    const Vec2 c = moments.centre.col(static_cast<Eigen::Index>(k));
    Mat2 second = Mat2::Zero();  // about the centroid: area/12 Σ r rᵀ
    for (const Vec2& v : p) second += m[0] / 12.0 * (v - c) * (v - c).transpose();
    CHECK_THAT(m.segment<2>(1).norm(), WithinAbs(0.0, 1e-15));
    CHECK_THAT((Vec3(m[3], m[4], m[5]) - Vec3(second(0, 0), second(0, 1), second(1, 1))).norm(), WithinAbs(0.0, 1e-14));
  }
  CHECK(whole > 2);
}

TEST_CASE("what bulges out of a grid of rectangles counts for the cells at its border", "[boundary][body_moments]") {
  const std::vector<SplineCurve> body{
      fit_spline(line({0.5, 0.5}, {3.0, 0.5})),
      fit_spline({.name = "right", .points = {Vec2(3.0, 0.5), Vec2(3.008, 1.7), Vec2(3.0, 3.0)}}),
      fit_spline({.name = "top", .points = {Vec2(3.0, 3.0), Vec2(1.6, 3.006), Vec2(0.5, 3.0)}}),
      fit_spline(line({0.5, 3.0}, {0.5, 0.5}))};
  const QuadrilateralGrid wide({0.0, 0.0}, {1.0, 1.0}, {5, 5});
  const QuadrilateralGrid tight({0.0, 0.0}, {1.0, 1.0}, {3, 3});
  const BodyMoments moments = body_moments(body, tight, 2);
  CHECK(moments.cell.size() == 9);
  CHECK((total(moments) - total(body_moments(body, wide, 2))).norm() < 1e-13);
}

TEST_CASE("body moments refuse an order beyond the grid's highest, and a curve outside", "[boundary][body_moments]") {
  const TriangleGrid triangles(test::lattice(4, 4, TrianglePattern::diagonal));
  const QuadrilateralGrid rectangles({0.0, 0.0}, {1.0, 1.0}, {2, 4});
  CHECK(highest_order(triangles) == 2);
  CHECK(highest_order(rectangles) == 8);
  CHECK_THROWS_WITH(body_moments(drilled_disc(), triangles, 3), Contains("0 to 2") && Contains("3"));
  CHECK_THROWS_AS(body_moments(drilled_disc(), rectangles, 9), InvalidArgument);
  CHECK_THROWS_AS(body_moments(drilled_disc(), rectangles, 2), OutsideGrid);
}
