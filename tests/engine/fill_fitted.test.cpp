#include <catch2/catch.hpp>
#include <map>

#include "../bases/meshes.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"
#include "shoreline/boundary/body_moments.hpp"
#include "shoreline/boundary/fitted_weights.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "shoreline/engine/fill.hpp"

using namespace shoreline;
using Catch::Matchers::WithinRel;

namespace {

std::vector<SplineCurve> disc(const Vec2& centre, double radius) {
  return {fit_spline(circle(centre, radius, 16, false))};
}

/// How the cells of a filled grid came out.
struct Outcome {
  Index whole = 0;       ///< cells that the body covers whole
  Index cut = 0;         ///< other cells with points
  Index most_whole = 0;  ///< points in a whole cell
  Index least_whole = 1000000;
  int unmet = 0;  ///< cut cells whose points cannot meet all moments
};

Outcome outcome(const std::vector<SplineCurve>& body, const Grid& grid, const MaterialPoints& points, int order) {
  std::map<Index, std::vector<Index>> in;
  for (Index p = 0; p < points.size(); ++p) in[grid.locate(points.position.col(p), 0).value()].push_back(p);
  const BodyMoments moments = body_moments(body, grid, order);
  Outcome found;
  for (std::size_t k = 0; k < moments.cell.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const std::vector<Index>& inside = in[moments.cell[k]];
    const auto n = static_cast<Index>(inside.size());
    if (moments.moment(0, column) > (1.0 - 1e-9) * moments.whole[column]) {
      ++found.whole;
      found.most_whole = std::max(found.most_whole, n);
      found.least_whole = std::min(found.least_whole, n);
      continue;
    }
    ++found.cut;
    Eigen::Matrix2Xd x(2, n);
    Eigen::VectorXd weight(n);
    for (Index p = 0; p < n; ++p) {
      x.col(p) = points.position.col(inside[static_cast<std::size_t>(p)]) - moments.centre.col(column);
      weight[p] = points.volume[inside[static_cast<std::size_t>(p)]];
    }
    if (fit_weights(x, grid.size(moments.cell[k]), moments.moment.col(column), weight) < order) ++found.unmet;
  }
  return found;
}

}  // namespace

TEST_CASE("fitted fill: Gauss points in whole rectangles, and in cut ones as many as their moments take",
          "[engine][fill]") {
  test::Random random(2);
  for (int draw = 0; draw < 6; ++draw)
    for (const int degree : {1, 2, 3}) {
      const Vec2 spacing = random.vector(0.15, 0.4);
      const QuadrilateralGrid grid(random.vector(-1.6, -1.3), spacing, {30, 30});
      const std::vector<SplineCurve> body = disc(random.vector(-0.1, 0.1), 1.1);
      const MaterialPoints points = fill_fitted(body, grid, {degree + 1, degree + 1}, degree);
      CAPTURE(draw, degree, spacing.transpose());
      CHECK_THAT(points.volume.sum(), WithinRel(Region(body).area(), 1e-10));
      const Outcome found = outcome(body, grid, points, 2 * degree);
      CHECK(found.whole > 5);
      CHECK(found.cut > 10);
      CHECK(found.least_whole == (degree + 1) * (degree + 1));
      CHECK(found.most_whole == (degree + 1) * (degree + 1));
      CHECK(found.unmet == 0);
    }
}

TEST_CASE("fitted fill: three points in whole triangles", "[engine][fill]") {
  test::Random random(3);
  TriangleMesh mesh = delaunay(test::jittered_points(6, 6, random));
  const std::vector<SplineCurve> body = disc({3.1, 2.9}, 2.2);
  for (const TriangleGrid& grid :
       {TriangleGrid(mesh), TriangleGrid(powell_sabin_refinement(mesh), powell_sabin_parts)}) {
    const MaterialPoints points = fill_fitted(body, grid, {2, 2}, 2);
    CHECK_THAT(points.volume.sum(), WithinRel(Region(body).area(), 1e-10));
    const Outcome found = outcome(body, grid, points, 2);
    CHECK(found.whole > 10);
    CHECK(found.least_whole == 3);
    CHECK(found.most_whole == 3);
  }
}

TEST_CASE("fitted fill: slivers of rectangles get points, too", "[engine][fill]") {
  for (const double sliver : {1e-2, 1e-4, 1e-5}) {
    const QuadrilateralGrid grid({0.0, 0.0}, {1.0, 1.0}, {4, 4});
    std::vector<SplineCurve> body;
    const std::vector<Vec2> x{{1.0, 1.0}, {2.0 + sliver, 1.0}, {2.0 + sliver, 2.0 + 0.5 * sliver}, {1.0, 2.0}};
    for (std::size_t k = 0; k < 4; ++k) body.push_back(fit_spline(line(x[k], x[(k + 1) % 4])));
    const MaterialPoints points = fill_fitted(body, grid, {3, 3}, 2);
    CAPTURE(sliver);
    CHECK_THAT(points.volume.sum(), WithinRel(Region(body).area(), 1e-12));
    const Outcome found = outcome(body, grid, points, 4);
    CHECK(found.unmet == 0);
    CHECK(found.cut == 3);
  }
}
