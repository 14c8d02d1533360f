#include "shoreline/boundary/cut_fractions.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "shoreline/bases/linear_triangle.hpp"
#include "shoreline/bases/mesh_generators.hpp"
#include "shoreline/bases/powell_sabin.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const QuadrilateralGrid lattice({-2.0, -2.0}, {1.0, 1.0}, {4, 4});

std::vector<SplineCurve> box(const Vec2& a, const Vec2& b) {
  return {fit_spline(
      {.name = "box", .points = {a, {b.x(), a.y()}, b, {a.x(), b.y()}}, .corners = {0, 1, 2, 3}, .closed = true})};
}

CutFraction smallest(const std::vector<CutFraction>& cuts) {
  return *std::ranges::min_element(cuts, {}, &CutFraction::fraction);
}

}  // namespace

TEST_CASE("the smallest cut of rectangles is found with its cell, down to 1e-9", "[boundary][cut_fractions]") {
  const double depth = GENERATE(4e-3, 4e-9);
  const CutFraction found = smallest(cut_fractions(box({-1.5, -1.5}, {depth, 1.25}), lattice));
  CHECK_THAT(found.fraction, WithinRel(0.25 * depth, 1e-6));
  CHECK(found.element == 2 + 3 * 4);
  CHECK((element_centre(lattice, found.element) - Vec2(0.5, 1.5)).norm() <= 1e-15);
}

TEST_CASE("the smallest cut of triangles is found, of Powell-Sabin triangles over their six parts",
          "[boundary][cut_fractions]") {
  const double depth = GENERATE(std::pow(10.0, -1.5), std::pow(10.0, -4.5));
  const TriangleMesh mesh = triangulate(lattice, TrianglePattern::diagonal);
  const LinearTriangleBasis linear(mesh);
  const PowellSabinBasis smooth(mesh);
  for (const Grid* grid : {&linear.grid(), &smooth.grid()}) {
    CAPTURE(depth, grid->parts());
    const CutFraction found = smallest(cut_fractions(box({-depth, -0.5}, {1.5, 0.5}), *grid));  // a corner of it
    CHECK_THAT(found.fraction, WithinRel(depth * depth, 1e-6));
    CHECK((element_centre(*grid, found.element) - Vec2(-2.0 / 3.0, -1.0 / 3.0)).norm() <= 1e-14);
  }
}

TEST_CASE("cut fractions sum to the area of the body, also where it bulges out of the grid",
          "[boundary][cut_fractions]") {
  const double radius = GENERATE(1.3, 2.005);
  Piece rim = circle({0.0, 0.0}, radius, 32, false);
  const std::vector<SplineCurve> curves{fit_spline(rim)};
  const TriangleGrid triangles(triangulate(lattice, TrianglePattern::four));
  for (const auto& [grid, size] : {std::pair<const Grid*, double>(&lattice, 1.0), {&triangles, 0.25}}) {
    double sum = 0.0;
    for (const CutFraction& cut : cut_fractions(curves, *grid)) sum += cut.fraction * size;
    CHECK_THAT(sum, WithinRel(Region(curves).area(), 1e-12));
  }
}
