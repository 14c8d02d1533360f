// Weights fitted to the outline: smooth bases keep their orders under a cut boundary, with few points.
#include <catch2/catch.hpp>

#include "../example_run.hpp"
#include "../plate_on_basis.hpp"
#include "shoreline/boundary/voronoi.hpp"

using namespace shoreline;

namespace {

struct Plate {
  double displacement;  ///< relative L2
  double stress;        ///< relative L2
  Index points;
};

/// The plate with points by `volumes: fitted`, all supports by Nitsche's method.
Plate plate(const std::string& file, Case::Grid grid, double h) {
  const Case example = read_case(std::string(SHORELINE_EXAMPLES) + "/plate_with_hole/" + file, {});
  grid.lower = example.grid.lower;
  grid.upper = example.grid.upper;
  Case problem = test::plate_on("plate_with_hole/" + file, grid, h, 10.0);
  const int n = grid.basis == Case::BasisType::bspline ? grid.degree + 1 : 2;
  problem.material_points = LatticeFill{{n, n}, VolumeRule::fitted};
  problem.fitted = true;
  Scene scene = build_scene(problem);
  const test::PlateResult result = test::compute(scene);
  CHECK(result.record.warnings.empty());
  return {result.displacement, result.stress, scene.points.size()};
}

Case::Grid grid_of(Case::BasisType basis, TrianglePattern pattern = TrianglePattern::diagonal) {
  Case::Grid grid;
  grid.basis = basis;
  grid.pattern = pattern;
  return grid;
}

double rate(double coarse, double fine, double halvings = 1.0) { return std::log2(coarse / fine) / halvings; }

}  // namespace

TEST_CASE("plate with fitted weights on quadratic B-splines: orders three and two with a fifth of the points",
          "[verification][fitted]") {
  const Case::Grid grid = grid_of(Case::BasisType::bspline);
  const Plate coarse = plate("neumann.json", grid, 0.125);
  const Plate middle = plate("neumann.json", grid, 0.0625);
  const Plate fine = plate("neumann.json", grid, 0.03125);
  CHECK(middle.points <= 10000);
  CHECK(middle.displacement <= 3e-5);
  CHECK(middle.stress <= 2.5e-3);
  CHECK(fine.points <= 35000);
  CHECK(fine.displacement <= 8e-6);
  CHECK(fine.stress <= 9e-4);
  CHECK(rate(coarse.displacement, fine.displacement, 2.0) >= 2.6);
  CHECK(rate(coarse.stress, fine.stress, 2.0) >= 1.7);
}

TEST_CASE("plate with fitted weights on Powell-Sabin splines: orders three and two on diagonal triangles",
          "[verification][fitted]") {
  const Case::Grid grid = grid_of(Case::BasisType::powell_sabin);
  const Plate middle = plate("neumann.json", grid, 0.0625);
  const Plate fine = plate("neumann.json", grid, 0.03125);
  CHECK(middle.displacement <= 6e-5);
  CHECK(middle.stress <= 3e-3);
  CHECK(fine.points <= 100000);
  CHECK(fine.displacement <= 6e-6);
  CHECK(fine.stress <= 8e-4);
  CHECK(rate(middle.displacement, fine.displacement) >= 2.8);
  CHECK(rate(middle.stress, fine.stress) >= 1.8);

  const Plate moved_middle = plate("dirichlet.json", grid, 0.0625);
  const Plate moved_fine = plate("dirichlet.json", grid, 0.03125);
  CHECK(moved_middle.displacement <= 4e-5);
  CHECK(moved_fine.displacement <= 5e-6);
  CHECK(rate(moved_middle.displacement, moved_fine.displacement) >= 2.8);
}

TEST_CASE("plate with fitted weights on Powell-Sabin splines: four triangles a square, and Delaunay triangles",
          "[verification][fitted]") {
  const Plate four = plate("neumann.json", grid_of(Case::BasisType::powell_sabin, TrianglePattern::four), 0.0625);
  CHECK(four.displacement <= 1.2e-4);
  CHECK(four.stress <= 6e-3);
  Case::Grid delaunay = grid_of(Case::BasisType::powell_sabin);
  delaunay.mesh = test::jittered_square({0.0, 0.0}, 2.25, 36);
  const Plate unstructured = plate("neumann.json", delaunay, 0.0625);
  CHECK(unstructured.displacement <= 1.2e-4);
  CHECK(unstructured.stress <= 6e-3);
}

namespace {

/// The smooth square on Powell-Sabin splines of 16 squares a side, with 4² points a square and their Voronoi areas.
/// @param jitter  of the points, in parts of their spacing
ErrorNorms smooth_square(double jitter, bool fitted) {
  Case problem = read_case(std::string(SHORELINE_EXAMPLES) + "/smooth_square/square.json", {"grid.basis=powell_sabin"});
  constexpr int side = 64;
  test::Random random(6);
  Eigen::Matrix2Xd sites(2, side * side);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      sites.col(i * side + j) = (Vec2(i + 0.5, j + 0.5) + random.vector(-jitter, jitter)) / side;
  std::vector<SplineCurve> curves;
  for (const Case::Boundary& piece : problem.boundaries) curves.push_back(fit_spline(piece.piece));
  const Eigen::VectorXd area = voronoi_areas(curves, sites);
  std::vector<Case::ListedPoint> points;
  for (Eigen::Index p = 0; p < area.size(); ++p) points.push_back({sites.col(p), area[p]});
  problem.material_points = points;
  problem.fitted = fitted;
  Scene scene = build_scene(problem);
  RunRecord record;
  run_load_steps(scene, {}, record);
  return error_norms(scene.points, *scene.exact, 1.0);
}

}  // namespace

TEST_CASE("smooth square: consistent weights give few points the accuracy of exact integrals",
          "[verification][fitted]") {
  const ErrorNorms regular = smooth_square(0.0, true);
  CHECK(regular.displacement_l2_relative.value() <= 3e-4);
  CHECK(regular.stress_l2_relative.value() <= 5e-3);
  const ErrorNorms jittered = smooth_square(0.25, true);
  CHECK(jittered.displacement_l2_relative.value() <= 6e-4);
  CHECK(jittered.stress_l2_relative.value() <= 1e-2);
  const ErrorNorms equal = smooth_square(0.0, false);
  CHECK(equal.displacement_l2_relative.value() >= 1e-2);
  CHECK(equal.stress_l2_relative.value() >= 0.1);
}
