// The plate with a hole (Bing et al. 2019, §4.4), whose outer boundary is a spline through 11 points.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "../example_run.hpp"

using namespace shoreline;
using test::ExampleRun;

namespace {

std::string cell_size(int exponent) { return test::power_of_two("grid.cell_size", exponent); }

ErrorNorms errors(const std::string& file, int exponent, std::vector<std::string> overrides = {}) {
  overrides.push_back(cell_size(exponent));
  return test::errors_of_example("plate_with_hole/" + file + ".json", overrides);
}

double mean_u(const ErrorNorms& norms) { return norms.displacement[0].mean_absolute; }
double mean_v(const ErrorNorms& norms) { return norms.displacement[1].mean_absolute; }

double rate(double coarse, double fine, int halvings) { return std::log2(coarse / fine) / halvings; }

const std::string lattice = "material_points.volumes=lattice";

}  // namespace

TEST_CASE("plate under tractions, clipped points: orders two and one", "[verification][plate]") {
  const ErrorNorms coarse = errors("neumann", -3);
  const ErrorNorms fine = errors("neumann", -5);
  CHECK(mean_u(fine) <= 6.2e-5);
  CHECK(mean_v(fine) <= 6.2e-5);
  CHECK(fine.stress_l2_relative.value() <= 1.25e-2);
  CHECK(rate(mean_u(coarse), mean_u(fine), 2) >= 1.8);
  CHECK(rate(mean_v(coarse), mean_v(fine), 2) >= 1.8);
  CHECK(rate(*coarse.stress_l2_relative, *fine.stress_l2_relative, 2) >= 0.9);
}

TEST_CASE("plate under tractions, points of a lattice", "[verification][plate]") {
  const ErrorNorms coarse = errors("neumann", -1, {lattice});
  const ErrorNorms fine = errors("neumann", -5, {lattice});
  CHECK(mean_u(fine) <= 6e-5);
  CHECK(mean_v(fine) <= 6e-5);
  CHECK(fine.stress_l2_relative.value() <= 1.5e-2);
  CHECK(rate(mean_u(coarse), mean_u(fine), 4) >= 1.6);
  CHECK(rate(mean_v(coarse), mean_v(fine), 4) >= 1.6);
}

TEST_CASE("plate, prescribed displacement: the fit on its boundary is of order two", "[verification][plate]") {
  std::vector<FitError> fit;
  for (int k = -1; k >= -6; --k) {
    ExampleRun run("plate_with_hole/dirichlet.json", {cell_size(k), "material_points.per_cell=1", "ghost=0.001"});
    fit.push_back(run.compute().record.fit_errors.at("outer"));
  }
  CHECK(rate(fit.front().mean, fit.back().mean, 5) >= 2.2);
  CHECK(rate(fit.front().l2, fit.back().l2, 5) >= 2.0);
  CHECK(fit.back().mean <= 1e-6);
}

TEST_CASE("plate, prescribed displacement: errors of displacement and stress", "[verification][plate]") {
  const ErrorNorms coarse = errors("dirichlet", -2);
  const ErrorNorms fine = errors("dirichlet", -5);
  CHECK(mean_u(fine) <= 1.3e-5);
  CHECK(mean_v(fine) <= 1e-5);
  CHECK(fine.stress_l2_relative.value() <= 1.35e-2);
  CHECK(rate(mean_u(coarse), mean_u(fine), 3) >= 1.7);
  CHECK(rate(mean_v(coarse), mean_v(fine), 3) >= 1.7);

  std::vector<std::string> narrow;
  for (const char* piece : {"outer", "left", "bottom"})
    narrow.push_back(std::string("boundaries.") + piece + ".condition.band=1e-6");
  CHECK(mean_u(errors("dirichlet", -5, narrow)) <= 4e-5);
  narrow.push_back(lattice);
  CHECK(mean_u(errors("dirichlet", -5, narrow)) <= 4e-5);
}

TEST_CASE("plate, prescribed displacement: the error is least along the outer boundary", "[verification][plate]") {
  ExampleRun run("plate_with_hole/dirichlet.json", {cell_size(-4)});
  run.compute();
  const SplineCurve& outer = *run.scene.boundary[0].original;
  double at_edge = 0.0, edge_volume = 0.0, all = 0.0;
  for (Index p = 0; p < run.scene.points.size(); ++p) {
    const Vec2 origin = run.scene.points.position.col(p) - run.scene.points.displacement.col(p);
    const double volume = run.scene.points.volume[p];
    const double error = (run.scene.points.displacement.col(p) - run.scene.exact->displacement(origin, 1.0)).norm();
    double distance = INFINITY;
    for (const CubicSpan& span : outer.spans)
      for (int k = 0; k <= 50; ++k) distance = std::min(distance, (span.position(k / 50.0) - origin).norm());
    all += volume * error;
    if (distance > 1.0 / 64.0) continue;
    at_edge += volume * error;
    edge_volume += volume;
  }
  CHECK(at_edge / edge_volume <= 0.25 * all / run.scene.points.volume.sum());
}

TEST_CASE("plate, prescribed displacement: Nitsche's method beside the implicit boundary", "[verification][plate]") {
  std::vector<std::string> nitsche;
  for (const char* piece : {"outer", "left", "bottom"})
    nitsche.push_back(std::string("boundaries.") + piece + ".condition.method=nitsche");
  const ErrorNorms coarse = errors("dirichlet", -3, nitsche);
  const ErrorNorms fine = errors("dirichlet", -5, nitsche);
  CHECK(mean_u(fine) <= 1.3e-5);
  CHECK(rate(mean_u(coarse), mean_u(fine), 2) >= 1.8);
  CHECK(rate(*coarse.stress_l2_relative, *fine.stress_l2_relative, 2) >= 0.9);
}
