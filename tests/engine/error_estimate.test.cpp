#include "shoreline/engine/error_estimate.hpp"

#include <omp.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../../engine/src/threads.hpp"
#include "../every_grid.hpp"
#include "../scenes.hpp"
#include "output_folder.hpp"
#include "results_files.hpp"
#include "shoreline/engine/run.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const std::vector<Vec2> body{{0.11, 0.07}, {0.93, 0.2}, {0.78, 0.91}, {0.05, 0.83}};  ///< cuts cells at any place

/// Points that integrate the products of a grid's functions over the body, with a stress of each.
MaterialPoints points_on(const test::NamedGrid& named, const Basis& basis,
                         const std::function<Vec3(const Vec2&)>& stress) {
  const int degree = named.grid.basis == Case::BasisType::bspline ? named.grid.degree : 2;
  const std::vector<Case::ListedPoint> listed = test::exact_points(basis.grid(), body, degree + 2);
  Eigen::Matrix2Xd position(2, listed.size());
  Eigen::VectorXd volume(listed.size());
  for (std::size_t p = 0; p < listed.size(); ++p) {
    position.col(static_cast<Eigen::Index>(p)) = listed[p].position;
    volume[static_cast<Eigen::Index>(p)] = listed[p].volume;
  }
  MaterialPoints points = points_at(position, volume);
  for (Index p = 0; p < points.size(); ++p) points.stress.col(p).head<3>() = stress(points.position.col(p));
  return points;
}

std::vector<test::NamedGrid> grids() { return test::every_grid(Vec2::Zero(), 1.0, 5); }

Vec3 wavy(const Vec2& x) { return 1e5 * Vec3(std::sin(9.0 * x.x()), std::cos(7.0 * x.y()), std::sin(8.0 * x.sum())); }

ErrorEstimate estimate_of(const Basis& basis, const MaterialPoints& points) {
  return error_estimate(basis, points, locate_points(basis, points));
}

double norm(const MaterialPoints& points) {
  return std::sqrt(points.stress.topRows<3>().colwise().squaredNorm().dot(points.volume));
}

Case square(bool estimate) {
  Case problem = test::compression_case({.angle = 0.2, .cells = 4, .per_cell = 2, .steps = 2});
  problem.threads = 1;
  problem.output.pictures = false;
  problem.error_estimate = estimate;
  return problem;
}

bool timed(const Summary& summary, const std::string& phase) {
  return std::ranges::any_of(summary.timings, [&](const auto& entry) { return entry.first == phase; });
}

}  // namespace

TEST_CASE("a stress that the basis holds has no error, on every grid and however small the cuts",
          "[engine][estimate]") {
  for (const test::NamedGrid& named : grids()) {
    CAPTURE(named.name);
    const std::unique_ptr<const Basis> basis = test::basis_of(named.grid);
    const MaterialPoints points = points_on(named, *basis, [](const Vec2& x) {
      return Vec3(1e6 + 2e6 * x.x(), 3e6 * x.y() - 1e6 * x.x(), 2e6 - 1e6 * x.y());
    });
    const ErrorEstimate estimate = estimate_of(*basis, points);
    CHECK(estimate.stress_l2 <= 1e-10 * norm(points));
    CHECK(estimate.stress_at_point.maxCoeff() <= 1e-8 * points.stress.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("recovery is an orthogonal projection: squares of estimate and recovered stress add up to the stress's",
          "[engine][estimate]") {
  for (const test::NamedGrid& named : grids()) {
    CAPTURE(named.name);
    const std::unique_ptr<const Basis> basis = test::basis_of(named.grid);
    const MaterialPoints points = points_on(named, *basis, wavy);
    const ErrorEstimate estimate = estimate_of(*basis, points);
    CHECK_THAT(estimate.stress_l2,
               WithinRel(std::sqrt(estimate.stress_at_point.cwiseAbs2().dot(points.volume)), 1e-12));
    const double recovered = estimate.stress_l2 / estimate.stress_l2_relative.value();
    CHECK_THAT(std::hypot(estimate.stress_l2, recovered), WithinRel(norm(points), 1e-8));
    CHECK(estimate.stress_l2 > 1e-3 * norm(points));
  }
}

TEST_CASE("a sawtooth of the grid's period, the error of a gradient, is seen whole", "[engine][estimate]") {
  const int degree = GENERATE(1, 2, 3);
  Case::Grid grid{.lower = Vec2(0, 0), .upper = Vec2(12, 12), .cell_size = Vec2(1, 1)};
  grid.basis = Case::BasisType::bspline;
  grid.degree = degree;
  const std::unique_ptr<const Basis> basis = test::basis_of(grid);
  const auto bernoulli = [degree](double x) {
    const double s = x - std::floor(x);
    if (degree == 1) return s - 0.5;
    return degree == 2 ? s * s - s + 1.0 / 6.0 : s * (s - 0.5) * (s - 1.0);
  };
  const test::NamedGrid named{"", grid};
  MaterialPoints points = points_at(Eigen::Matrix2Xd(2, 48 * 48), Eigen::VectorXd::Constant(48 * 48, 1.0 / 16.0));
  for (Index p = 0; p < points.size(); ++p) {
    points.position.col(p) = Vec2((p % 48 + 0.5) / 4.0, (p / 48 + 0.5) / 4.0);
    points.stress(0, p) = bernoulli(points.position(0, p));
  }
  const double mean = points.stress.row(0).mean();  // of equal points, which see a period at its 4 midpoints
  points.stress.row(0).array() -= mean;
  const ErrorEstimate estimate = estimate_of(*basis, points);
  for (Index p = 0; p < points.size(); ++p)
    if ((points.position.col(p) - Vec2(6, 6)).cwiseAbs().maxCoeff() < 1.0)  // what ends bring in dies off from there
      CHECK_THAT(estimate.stress_at_point[p], WithinAbs(std::abs(points.stress(0, p)), 0.02));
  CHECK_THAT(estimate.stress_l2, WithinRel(norm(points), 0.1));
}

TEST_CASE("the estimate scales with stress and length, its relative form with neither", "[engine][estimate]") {
  const auto grid = GENERATE(from_range(grids()));
  CAPTURE(grid.name);
  const std::unique_ptr<const Basis> basis = test::basis_of(grid.grid);
  const MaterialPoints points = points_on(grid, *basis, wavy);
  const ErrorEstimate estimate = estimate_of(*basis, points);

  MaterialPoints stronger = points;
  stronger.stress *= 1e7;
  const ErrorEstimate strong = estimate_of(*basis, stronger);
  CHECK_THAT(strong.stress_l2, WithinRel(1e7 * estimate.stress_l2, 1e-9));
  CHECK_THAT(strong.stress_l2_relative.value(), WithinRel(estimate.stress_l2_relative.value(), 1e-9));

  MaterialPoints heavier = points;
  heavier.volume *= 1e-6;
  const ErrorEstimate light = estimate_of(*basis, heavier);
  CHECK_THAT(light.stress_l2, WithinRel(1e-3 * estimate.stress_l2, 1e-9));
  CHECK_THAT(light.stress_l2_relative.value(), WithinRel(estimate.stress_l2_relative.value(), 1e-9));
}

TEST_CASE("a body without stress has an error of zero, and no relative one", "[engine][estimate]") {
  const test::NamedGrid named = grids().front();
  const std::unique_ptr<const Basis> basis = test::basis_of(named.grid);
  const ErrorEstimate estimate =
      estimate_of(*basis, points_on(named, *basis, [](const Vec2&) -> Vec3 { return Vec3::Zero(); }));
  CHECK(estimate.stress_l2 == 0.0);
  CHECK_FALSE(estimate.stress_l2_relative);
}

TEST_CASE("one point alone, and points on vertices, are recovered as they are", "[engine][estimate]") {
  for (const test::NamedGrid& named : grids()) {
    CAPTURE(named.name);
    const std::unique_ptr<const Basis> basis = test::basis_of(named.grid);
    for (const Vec2& x : {Vec2(0.4, 0.4), Vec2(0.0, 0.0), Vec2(0.437, 0.311)}) {
      MaterialPoints points = points_at(x, Eigen::VectorXd::Constant(1, 0.3));
      points.stress.col(0) = Stress(1.0, -2.0, 3.0, 0.0);
      CHECK(estimate_of(*basis, points).stress_l2 <= 1e-9);
    }
  }
}

TEST_CASE("the estimate does not depend on the number of threads", "[engine][estimate]") {
  const test::NamedGrid named{"", {.lower = Vec2(0, 0), .upper = Vec2(1, 1), .cell_size = Vec2(0.02, 0.02)}};
  const std::unique_ptr<const Basis> basis = test::basis_of(named.grid);
  const MaterialPoints points = points_on(named, *basis, wavy);
  REQUIRE(worth_threads(static_cast<std::size_t>(points.size())));
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const ErrorEstimate one = estimate_of(*basis, points);
  for (const int threads : {2, 3}) {
    omp_set_num_threads(threads);
    CHECK(estimate_of(*basis, points).stress_at_point == one.stress_at_point);
  }
  omp_set_num_threads(before);
}

TEST_CASE("a run that does not name the estimate neither computes nor times nor writes it", "[engine][estimate]") {
  const test::OutputFolder folder;
  const Summary without = run(square(false), {.output = folder.path, .quiet = true});
  CHECK_FALSE(without.error_estimate);
  CHECK_FALSE(timed(without, "estimate"));
  CHECK_THAT(test::text_of(folder.path / "summary.json"), !Contains("estimate\""));
  CHECK_THAT(test::text_of(folder.path / "results.xdmf"), !Contains("estimate"));
  CHECK_THAT(plan(square(false)), Contains("diagnostics.error_estimate is false"));

  const Summary with = run(square(true), {.output = folder.path, .quiet = true});
  CHECK(timed(with, "estimate"));
  for (const auto& [name, times] : without.counters) {
    CAPTURE(name);
    const bool of_the_estimate =
        name == "evaluations" || name == "solves" || name == "factorisations" || name == "analyses";
    CHECK((with.counters.at(name) > times) == of_the_estimate);
  }
  CHECK(with.counters.at("factorisations") == without.counters.at("factorisations") + 1);
  CHECK_THAT(plan(square(true)), !Contains("diagnostics.error_estimate is false") && Contains("  error_estimate  "));
}

TEST_CASE("where points are fewer than two a function, a run says that its estimate is worth nothing",
          "[engine][estimate]") {
  const test::OutputFolder folder;
  const auto warned = [&](int per_cell) {
    Case problem = square(true);
    problem.material_points = LatticeFill{{per_cell, per_cell}, VolumeRule::clipped};
    const Summary summary = run(problem, {.output = folder.path, .quiet = true});
    return std::ranges::any_of(
        summary.warnings, [](const std::string& w) { return w.find("cannot be estimated from") != std::string::npos; });
  };
  CHECK(warned(1));
  CHECK_FALSE(warned(4));
}

TEST_CASE("a run that names the estimate writes it, at the points with the last step alone", "[engine][estimate]") {
  const test::OutputFolder folder;
  const Summary summary = run(square(true), {.output = folder.path, .quiet = true});
  const ErrorEstimate& estimate = summary.error_estimate.value();
  const nlohmann::json json = nlohmann::json::parse(std::ifstream(folder.path / "summary.json"));
  CHECK(json["error_estimate"]["stress"]["l2"] == estimate.stress_l2);
  CHECK(json["error_estimate"]["stress"]["l2_relative"] == estimate.stress_l2_relative.value());
  const test::Dataset at_points = test::read(folder.path, "steps/000002/points/stress_error_estimate");
  CHECK(at_points.unit == "Pa");
  CHECK(at_points.values == std::vector<double>(estimate.stress_at_point.begin(), estimate.stress_at_point.end()));
  const std::string xdmf = test::text_of(folder.path / "results.xdmf");
  CHECK(xdmf.find("stress_error_estimate") != std::string::npos);
  CHECK(xdmf.find("000001/points/stress_error_estimate") == std::string::npos);
  CHECK(test::check_shapes(folder.path) > 0);
}
