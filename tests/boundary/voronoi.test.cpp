#include "shoreline/boundary/voronoi.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "../random.hpp"
#include "random_pieces.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::vector<SplineCurve> rectangle(const Vec2& lower, const Vec2& upper) {
  const Vec2 right(upper.x(), lower.y());
  const Vec2 left(lower.x(), upper.y());
  return {fit_spline(line(lower, right)), fit_spline(line(right, upper)), fit_spline(line(upper, left)),
          fit_spline(line(left, lower))};
}

/// A ring with an eccentric hole.
std::vector<SplineCurve> drilled_disc() {
  return {fit_spline(circle({0.3, -0.2}, 1.0, 12, false)), fit_spline(circle({0.5, -0.1}, 0.4, 9, true))};
}

/// Sites anywhere in a region.
Eigen::Matrix2Xd sites_in(const Region& region, Eigen::Index count, test::Random& random) {
  Eigen::Matrix2Xd sites(2, count);
  for (Eigen::Index p = 0; p < count;)
    if (const Vec2 x = random.in(region.bounds()); region.contains(x)) sites.col(p++) = x;
  return sites;
}

Eigen::Index nearest(const Eigen::Matrix2Xd& sites, const Vec2& x) {
  Eigen::Index site = 0;
  (sites.colwise() - x).colwise().squaredNorm().minCoeff(&site);
  return site;
}

}  // namespace

TEST_CASE("areas of Voronoi cells sum to the area of the body, for any body and sites", "[boundary][voronoi]") {
  test::Random random(1);
  test::RandomPieces pieces(1);
  for (int draw = 0; draw < 300; ++draw) {
    const std::vector<SplineCurve> curves =
        draw % 3 == 0 ? drilled_disc() : std::vector<SplineCurve>{fit_spline(pieces.star())};
    const Region region(curves);
    const Eigen::Matrix2Xd sites = sites_in(region, random.whole(1, 60), random);
    const Eigen::VectorXd areas = voronoi_areas(curves, sites);
    CAPTURE(draw, sites.cols());
    REQUIRE(areas.minCoeff() > 0.0);
    REQUIRE_THAT(areas.sum(), WithinRel(region.area(), 1e-12));
  }
}

TEST_CASE("every place counts for the site that is nearest to it", "[boundary][voronoi]") {
  test::Random random(2);
  const std::vector<SplineCurve> curves = drilled_disc();
  const Region region(curves);
  const Eigen::Matrix2Xd sites = sites_in(region, 40, random);
  const Eigen::VectorXd areas = voronoi_areas(curves, sites);
  const Box box = region.bounds();
  constexpr int rows = 1000;
  const Vec2 step = (box.upper - box.lower) / rows;
  Eigen::VectorXd counted = Eigen::VectorXd::Zero(areas.size());
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j)
      if (const Vec2 x = box.lower + step.cwiseProduct(Vec2(i + 0.5, j + 0.5)); region.contains(x))
        counted[nearest(sites, x)] += step.prod();
  // a sum over squares errs by at most those along the border of a cell; by about their square root, as signs differ
  for (Eigen::Index p = 0; p < areas.size(); ++p)
    CHECK_THAT(counted[p], WithinAbs(areas[p], 10.0 * std::sqrt(rows * std::sqrt(areas[p])) * step.prod()));
}

TEST_CASE("the Voronoi cell on a regular lattice is the lattice cell", "[boundary][voronoi]") {
  const Vec2 lower(-0.4, 2.0);
  const Vec2 spacing(0.3, 0.2);
  constexpr Index columns = 12;
  constexpr Index rows = 9;
  const std::vector<SplineCurve> body = rectangle(lower, lower + spacing.cwiseProduct(Vec2(columns, rows)));
  Eigen::Matrix2Xd sites(2, columns * rows);
  for (Index k = 0; k < columns * rows; ++k)
    sites.col(k) = lower + spacing.cwiseProduct(Vec2(k % columns + 0.5, k / columns + 0.5));
  const Eigen::VectorXd areas = voronoi_areas(body, sites);
  CHECK((areas.array() - spacing.prod()).abs().maxCoeff() < 1e-7 * spacing.prod());  // the raster's step: 1e-9 of 3.6 m
  CHECK_THAT(areas.sum(), WithinRel(spacing.prod() * columns * rows, 1e-12));
}

TEST_CASE("lattices in a disc, exact and all but, have cells with sides of any shortness", "[boundary][voronoi]") {
  test::Random random(3);
  for (int draw = 0; draw < 1500; ++draw) {
    const std::vector<SplineCurve> disc{fit_spline(circle(random.vector(0.0, 1.0), 1.0, random.whole(16, 24), false))};
    const Region region(disc);
    const double spacing = 2.0 / random.whole(4, 16);
    const double deviation = draw % 3 == 0 ? 0.0 : std::pow(10.0, random.uniform(-16.0, -6.0));
    std::vector<Vec2> inside;
    for (double y = region.bounds().lower.y() + 0.5 * spacing; y < region.bounds().upper.y(); y += spacing)
      for (double x = region.bounds().lower.x() + 0.5 * spacing; x < region.bounds().upper.x(); x += spacing)
        if (const Vec2 site = Vec2(x, y) + deviation * random.vector(); region.contains(site)) inside.push_back(site);
    Eigen::Matrix2Xd sites(2, static_cast<Eigen::Index>(inside.size()));
    for (std::size_t k = 0; k < inside.size(); ++k) sites.col(static_cast<Eigen::Index>(k)) = inside[k];
    REQUIRE_THAT(voronoi_areas(disc, sites).sum(), WithinRel(region.area(), 1e-12));
  }
}

TEST_CASE("one site has the whole body, two share it along the line half way", "[boundary][voronoi]") {
  const std::vector<SplineCurve> square = rectangle({0, 0}, {2, 2});
  CHECK_THAT(voronoi_areas(square, Vec2(0.3, 1.9))[0], WithinRel(4.0, 1e-12));
  Eigen::Matrix2Xd two(2, 2);
  two << 0.25, 0.75, 1.0, 1.0;
  const Eigen::VectorXd areas = voronoi_areas(square, two);
  CHECK_THAT(areas[0], WithinRel(1.0, 1e-8));
  CHECK_THAT(areas[1], WithinRel(3.0, 1e-8));
  const std::vector<SplineCurve> disc{fit_spline(circle({0, 0}, 1.0, 512, false))};
  two << 0.0, 0.0, -0.2, 0.8;  // a segment of the disc above y = 0.3
  const double angle = 2.0 * std::acos(0.3);
  CHECK_THAT(voronoi_areas(disc, two)[1], WithinAbs(0.5 * (angle - std::sin(angle)), 1e-8));
}

TEST_CASE("sites along one line, and along an outline, have their strips", "[boundary][voronoi]") {
  const std::vector<SplineCurve> body = rectangle({0, 0}, {4, 1});
  for (const double y : {0.0, 0.5, 1.0}) {
    Eigen::Matrix2Xd sites(2, 4);
    for (Eigen::Index k = 0; k < 4; ++k) sites.col(k) = Vec2(static_cast<double>(k) + 0.5, y);
    CHECK((voronoi_areas(body, sites).array() - 1.0).abs().maxCoeff() < 1e-7);
  }
}

TEST_CASE("sites in one place share their cell in equal parts", "[boundary][voronoi]") {
  const std::vector<SplineCurve> square = rectangle({0, 0}, {1, 1});
  Eigen::Matrix2Xd sites(2, 4);
  sites << 0.25, 0.75, 0.25, 0.25, 0.5, 0.5, 0.5, 0.5 + 1e-12;
  const Eigen::VectorXd areas = voronoi_areas(square, sites);
  CHECK_THAT(areas[1], WithinRel(0.5, 1e-8));
  for (const Eigen::Index p : {0, 2, 3}) CHECK_THAT(areas[p], WithinRel(0.5 / 3.0, 1e-8));
  CHECK_THAT(voronoi_areas(square, Eigen::Matrix2Xd::Constant(2, 5, 0.3)).sum(), WithinRel(1.0, 1e-12));
}

TEST_CASE("an outline along the border of Voronoi cells cuts none of them", "[boundary][voronoi]") {
  // a re-entrant corner half way between sites: both of its sides run along borders of cells
  const std::vector<Vec2> corner{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  std::vector<SplineCurve> body;
  for (std::size_t k = 0; k < corner.size(); ++k)
    body.push_back(fit_spline(line(corner[k], corner[(k + 1) % corner.size()])));
  Eigen::Matrix2Xd sites(2, 16);
  for (Eigen::Index k = 0; k < 16; ++k)
    sites.col(k) = Vec2(static_cast<double>(k % 4) + 0.5, static_cast<double>(k / 4) + 0.5);
  const Eigen::VectorXd areas = voronoi_areas(body, sites);
  for (Eigen::Index k = 0; k < 16; ++k)
    CHECK_THAT(areas[k], WithinAbs(k % 4 >= 2 && k / 4 >= 2 ? 0.0 : 1.0, 1e-7));  // sites outside have nothing
}

TEST_CASE("a site beside the body is refused with its number and place", "[boundary][voronoi]") {
  Eigen::Matrix2Xd sites(2, 2);
  sites << 0.5, 3.0, 0.5, 0.5;
  CHECK_THROWS_WITH(voronoi_areas(rectangle({0, 0}, {1, 1}), sites), Contains("site 1 at (3, 0.5)"));
}
