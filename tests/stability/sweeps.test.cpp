// What must hold in every sweep over hard cases, on fewer places of the grid than docs/stability.md shows.
#include "sweeps.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <map>

using namespace shoreline;
using Catch::Matchers::Contains;
using test::Row;

namespace {

constexpr double rounding = 1e-10;  ///< below it an error is rounding, and its spread means nothing

std::string name(const Row& row) {
  return row.label + ", " + test::basis_name(row.on) + ", " + test::method_name(row.on.method) + ", grid at " +
         row.worst + ": " + row.said;
}

/// Every run went to its end with a positive definite matrix.
void check_sound(const Row& row) {
  CHECK(row.failures == 0);
  CHECK(row.singular == 0);
  CHECK(row.indefinite == 0);
}

/// Largest over median of the displacement error.
void check_spread(const Row& row, double bound) {
  if (row.displacement.largest > rounding) CHECK(row.displacement.ratio() <= bound);
}

}  // namespace

TEST_CASE("with ghost penalty nothing depends on where the grid lies", "[stability][offsets]") {
  for (const Row& row : test::offset_sweep({.offsets = 12})) {
    CAPTURE(name(row), row.condition.median, row.displacement.median, row.stress.median);
    check_sound(row);
    CHECK(row.condition.ratio() <= 10.0);
    check_spread(row, 2.5);
    if (row.stress.largest > rounding) CHECK(row.stress.ratio() <= 5.0);
  }
}

TEST_CASE("with fitted weights the error of quadratic bases does not depend on where the grid lies",
          "[stability][offsets]") {
  constexpr double fit = 1e-7;  // of stresses: to which weights meet moments
  for (const Row& row : test::offset_sweep({.offsets = 12, .fitted = true})) {
    CAPTURE(name(row), row.condition.median, row.displacement.median, row.stress.median);
    check_sound(row);
    CHECK(row.condition.ratio() <= 10.0);
    const bool quadratic = test::basis_name(row.on) == "bspline 2" || test::basis_name(row.on) == "powell_sabin";
    check_spread(row, quadratic ? 1.5 : 2.5);
    if (row.stress.largest > fit) CHECK(row.stress.ratio() <= 5.0);
  }
}

TEST_CASE("without ghost penalty places of the grid are singular, indefinite, or have wild stresses in slivers",
          "[stability][offsets]") {
  std::map<std::string, int> spoilt;
  for (const Row& row : test::offset_sweep({.offsets = 12, .ghost = false})) {
    const bool wild = row.stress.largest > rounding && row.stress.ratio() > 5.0;
    if (row.failures + row.singular + row.indefinite > 0 || wild) ++spoilt[test::basis_name(row.on)];
  }
  CHECK(spoilt.size() == 5);  // every basis
  CHECK(spoilt["powell_sabin"] == 8);
}

TEST_CASE("on every band a solution is usable, or it is said that it is not", "[stability][band]") {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  const std::vector<Row> rows = test::band_sweep(3);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Row& row = rows[k];
    const Row& usual = rows[k - k % 12 + 2];  // a band of 1e-3
    CAPTURE(name(row), row.on.band, row.condition.median, usual.displacement.median);
    CHECK(row.failures == 0);
    if (row.on.band <= 1e-3) CHECK(row.indefinite == 0);
    CHECK(row.displacement.largest <= 3.0 * usual.displacement.largest + row.on.band + eps * row.condition.largest);
  }
}

TEST_CASE("a corner may graze a cell by 1e-12 of it", "[stability][corner]") {
  for (const Row& row : test::grazing_corner_sweep(true)) {
    CAPTURE(name(row));
    REQUIRE(row.runs == 11);
    check_sound(row);
    CHECK(row.condition.ratio() <= 2.0);
    check_spread(row, 1.1);
    CHECK(row.stress.ratio() <= 2.0);
  }
}

TEST_CASE("an edge may run beside a grid line by 1e-12 of a cell", "[stability][edge]") {
  for (const Row& row : test::grazing_edge_sweep(true)) {
    CAPTURE(name(row));
    REQUIRE(row.runs == 12);
    check_sound(row);
    CHECK(row.condition.ratio() <= 10.0);
    check_spread(row, 1.5);
    CHECK(row.stress.ratio() <= 5.0);
  }
}

TEST_CASE("holes within a cell and thin walls are sound, a thin body is, or says that it is not",
          "[stability][slivers]") {
  for (const Row& row : test::sliver_sweep(4)) {
    CAPTURE(name(row), row.displacement.largest);
    if (row.label == "body 1e-3 h thick") {
      CHECK((row.displacement.largest <= 0.02 || row.indefinite == row.runs));
      if (row.failures > 0) CHECK_THAT(row.said, Contains("of which the body covers") && Contains("ghost penalty"));
      continue;
    }
    check_sound(row);
    CHECK(row.condition.ratio() <= 10.0);
    check_spread(row, 1.5);
  }
}

TEST_CASE("triangles may be as flat as 1 degree, flatter ones are refused", "[stability][triangles]") {
  for (const Row& row : test::sliver_triangle_sweep(1)) {
    CAPTURE(name(row));
    if (row.label == "smallest angle 0.9°") {
      CHECK(row.failures == row.runs);
      CHECK_THAT(row.said, Contains("the limit is 1"));
      continue;
    }
    check_sound(row);
    CHECK(row.condition.largest <= 1e7);  // of which 1/angle² is its share
  }
}

TEST_CASE("edges may curve within a quarter of a cell", "[stability][curvature]") {
  double straight = 0.0;
  for (const Row& row : test::curvature_sweep(3)) {
    if (row.label == "bow of radius 100 h") straight = row.displacement.median;
    CAPTURE(name(row), straight);
    check_sound(row);
    check_spread(row, 1.5);
    CHECK(row.displacement.largest <= 5.0 * straight);
  }
}

TEST_CASE("with as many points as a basis wants, more of them make nothing worse", "[stability][points]") {
  for (const Row& row : test::point_number_sweep({6, 8}, false, 3)) {
    CAPTURE(name(row), row.on.per_cell);
    check_sound(row);
    check_spread(row, 2.5);
    CHECK(row.condition.ratio() <= 10.0);
  }
}

TEST_CASE("the cantilever bends alike on all layouts with points in every cell", "[stability][cantilever]") {
  for (const double ghost : {1e-4, 1e-3}) {
    std::map<double, std::vector<double>> tips;
    for (const test::CantileverRow& row : test::cantilever_sweep({ghost})) {
      CAPTURE(row.ghost, row.h, row.across, row.failure);
      const bool sparse = row.across == 28;  // hardly a point in a cell of 0.375 m
      if (sparse && !row.failure.empty()) CHECK_THAT(row.failure, Contains("use more points per cell"));
      if (sparse) continue;
      CHECK(row.failure.empty());
      tips[row.h].push_back(row.tip);
    }
    for (const auto& [h, of_h] : tips) {
      CAPTURE(ghost, h, of_h);
      CHECK(of_h.size() == 3);
      CHECK(std::ranges::max(of_h) <= 1.01 * std::ranges::min(of_h));
    }
  }
}

TEST_CASE("a point that crosses an edge changes stress and energy on linear bases, and nothing on smooth ones",
          "[stability][crossing]") {
  for (const test::CrossingRow& row : test::crossing_sweep()) {
    CAPTURE(row.basis, row.quasi_static_stress, row.dynamic_stress);
    const std::array jumps{row.quasi_static_stress, row.quasi_static_energy, row.dynamic_stress, row.dynamic_energy};
    const bool linear = row.basis == "bilinear" || row.basis == "linear";
    if (linear) CHECK(std::ranges::min(jumps) >= 1e-5);
    if (!linear) CHECK(std::ranges::max(jumps) <= 1e-7);
  }
}
