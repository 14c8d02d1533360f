// Errors of the plate with a hole at sample points: the same device for every basis and every set of points.

#include <catch2/catch.hpp>

#include "../plate_on_basis.hpp"

using namespace shoreline;
using Catch::Matchers::WithinRel;

namespace {

Case::Grid splines(int degree) {
  Case::Grid grid;
  grid.basis = Case::BasisType::bspline;
  grid.degree = degree;
  return grid;
}

/// The plate with a hole under tractions, with points of fitted weights, and sample points.
Case plate(const Case::Grid& grid, double h, int per_cell, int across) {
  Case problem = test::plate_on("plate_with_hole/neumann.json", grid, h, 10.0);
  problem.material_points = LatticeFill{{per_cell, per_cell}, VolumeRule::fitted};
  problem.fitted = true;
  problem.samples = across;
  return problem;
}

struct Measured {
  double displacement;  ///< relative L2
  double stress;        ///< relative L2
};

Measured measured(const ErrorNorms& norms) {
  return {norms.displacement_l2_relative.value(), norms.stress_l2_relative.value()};
}

double difference(double a, double b) { return std::abs(a - b) / std::max(a, b); }

/// Computes a scene.
Measured at_samples(Scene& scene) {
  test::compute(scene);
  return measured(error_norms(scene.samples.value(), scene.exact.value(), 1.0));
}

}  // namespace

TEST_CASE("samples depend on the outline alone and their areas sum to the body's", "[engine][samples]") {
  const Scene coarse = build_scene(plate(splines(2), 0.25, 3, 50));
  Case other = plate({}, 0.125, 2, 50);
  other.material_points = AcrossFill{.across = {30, 30}};
  other.fitted = false;
  const Scene fine = build_scene(other);
  REQUIRE(coarse.samples);
  CHECK(coarse.samples->position == fine.samples.value().position);
  CHECK(coarse.samples->volume == fine.samples.value().volume);

  std::vector<SplineCurve> curves;
  for (const BoundaryPiece& b : coarse.boundary) curves.push_back(*b.original);
  CHECK_THAT(coarse.samples->volume.sum(), WithinRel(Region(curves).area(), 1e-12));
  const double spacing = 2.0 / 50;  // the plate is 2 wide, and a little less high
  CHECK(coarse.samples->volume.maxCoeff() <= spacing * spacing * (1.0 + 1e-12));
  CHECK(coarse.samples->volume.maxCoeff() >= 0.97 * spacing * spacing);
}

TEST_CASE("few points and many with the same integrals have the same errors at samples", "[engine][samples]") {
  const auto errors = [](const Case::Grid& grid, int per_cell) {
    Scene scene = build_scene(plate(grid, 0.125, per_cell, 100));
    const Measured samples = at_samples(scene);
    return std::pair(measured(error_norms(scene.points, *scene.exact, 1.0)), samples);
  };
  {
    const auto [own_of_few, few] = errors({}, 2);  // the weights integrate the stiffness exactly
    const auto [own_of_many, many] = errors({}, 8);
    CHECK(difference(few.displacement, many.displacement) <= 1e-10);
    CHECK(difference(few.stress, many.stress) <= 1e-10);
    CHECK(difference(own_of_few.displacement, own_of_many.displacement) >= 2e-3);
    CHECK(difference(own_of_few.stress, own_of_many.stress) >= 1e-2);
  }
  const auto [own_of_few, few] = errors(splines(2), 3);  // here, all but the highest mixed monomials
  const auto [own_of_many, many] = errors(splines(2), 8);
  CHECK(difference(few.displacement, many.displacement) <=
        0.3 * difference(own_of_few.displacement, own_of_many.displacement));
  CHECK(difference(few.stress, many.stress) <= 0.05 * difference(own_of_few.stress, own_of_many.stress));
}

TEST_CASE("plate with a hole: errors at samples fall with the order of the basis", "[engine][samples]") {
  struct Expected {
    Case::Grid grid;
    int order;  ///< of the displacement; the stress has one less
    Measured at_finest;
  };
  Case::Grid powell_sabin;
  powell_sabin.basis = Case::BasisType::powell_sabin;
  for (const auto& [grid, order, bound] :
       {Expected{Case::Grid{}, 2, {3e-3, 2.4e-2}}, Expected{splines(2), 3, {3.5e-5, 1.9e-3}},
        Expected{powell_sabin, 3, {4.2e-5, 2.5e-3}}}) {
    const auto errors = [&, g = grid, n = order](double h) {
      Scene scene = build_scene(plate(g, h, n, 150));
      return at_samples(scene);
    };
    const Measured coarse = errors(0.125);
    const Measured fine = errors(0.0625);
    CHECK(std::log2(coarse.displacement / fine.displacement) >= order - 0.2);
    CHECK(std::log2(coarse.stress / fine.stress) >= order - 1.15);
    CHECK(fine.displacement <= bound.displacement);
    CHECK(fine.stress <= bound.stress);
  }
}
