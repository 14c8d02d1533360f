#include "shoreline/boundary/displacement_fit.hpp"

#include <catch2/catch.hpp>

#include "../every_grid.hpp"
#include "../plate.hpp"
#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/powell_sabin.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

namespace {

Edge edge_of(const Piece& piece, const Grid& grid) {
  return make_edge(piece, grid, std::vector<char>(static_cast<std::size_t>(grid.cells()), 1), gauss(4));
}

template <class Field>
HeldEdge held(const Edge& edge, bool normal_only, Field&& field) {
  HeldEdge result{edge, normal_only, Eigen::Matrix2Xd(2, static_cast<Eigen::Index>(edge.points.size()))};
  for (std::size_t k = 0; k < edge.points.size(); ++k)
    result.value.col(static_cast<Eigen::Index>(k)) = field(edge.points[k].x);
  return result;
}

Vec2 wave(const Vec2& x) { return {std::sin(2.0 * x.x()) * std::exp(x.y()), std::cos(x.x() - 3.0 * x.y())}; }

double length_of(const Edge& edge) {
  double length = 0.0;
  for (const BoundaryPoint& p : edge.points) length += p.weight;
  return length;
}

}  // namespace

TEST_CASE("a linear field is reproduced along any curve", "[boundary][displacement_fit]") {
  test::Random random(5);
  for (int draw = 0; draw < 50; ++draw) {
    const BilinearBasis basis({random.vector(-2.0, -1.0) * 1.7, random.vector(0.05, 0.5), {80, 80}});
    const Vec2 centre = random.vector(-0.2, 0.2);
    const Edge edge = edge_of(circle(centre, random.uniform(0.2, 0.6), 12, false), basis.grid());
    const Mat2 gradient = (Mat2() << random.vector(), random.vector()).finished();
    const auto field = [&](const Vec2& x) -> Vec2 { return gradient * x + Vec2(0.3, -0.1); };
    const DisplacementFit fit = fit_displacement(basis, std::vector{held(edge, false, field)});
    CHECK(fit.error[0].l2 <= 1e-8);
    CHECK(fit.error[0].mean <= 1e-8);
  }
}

TEST_CASE("the fit converges with order two", "[boundary][displacement_fit]") {
  std::vector<double> mean;
  std::vector<double> rms;
  for (const double h : {0.125, 0.0625, 0.03125, 0.015625}) {
    const auto cells = static_cast<Index>(2.5 / h);
    const BilinearBasis basis({Vec2(-0.25, -0.25), Vec2(h, h), {cells, cells}});
    const Edge edge = edge_of(test::plate_outer(), basis.grid());
    const DisplacementFit fit = fit_displacement(basis, std::vector{held(edge, false, wave)});
    mean.push_back(fit.error[0].mean);
    rms.push_back(fit.error[0].l2 / std::sqrt(length_of(edge)));
  }
  CHECK(std::log2(mean.front() / mean.back()) / 3.0 >= 2.0);
  CHECK(std::log2(rms.front() / rms.back()) / 3.0 >= 1.9);
  CHECK(mean.back() <= 1e-4);
}

TEST_CASE("in cells that a curve barely touches the fit stays smooth", "[boundary][displacement_fit]") {
  const BilinearBasis basis({Vec2(-1.0, -1.0), Vec2(0.25, 0.25), {8, 8}});
  for (const double touch : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const Edge edge = edge_of(circle({0.0, 0.0}, 0.5 + touch, 16, false), basis.grid());
    const DisplacementFit fit = fit_displacement(basis, std::vector{held(edge, false, wave)});
    double steepest = 0.0;
    for (const BoundaryPoint& p : edge.points)
      steepest = std::max(steepest, basis.support(p.cell, p.x).gradient_of(fit.coefficient).norm());
    CHECK(steepest <= 8.0);  // that of the field itself is below 4.6 on the circle
    CHECK(fit.error[0].mean <= 0.05);
  }
}

TEST_CASE("a roller fits the normal component and leaves the other at rest", "[boundary][displacement_fit]") {
  const BilinearBasis basis({Vec2(-1.0, -1.0), Vec2(0.3, 0.3), {8, 8}});
  const Edge edge = edge_of(line({-0.8, 0.07}, {0.9, 0.07}), basis.grid());
  const auto along_x = [](const Vec2& x) { return Vec2(1.0, 0.4 * x.x()); };
  const DisplacementFit fit = fit_displacement(basis, std::vector{held(edge, true, along_x)});
  CHECK(fit.error[0].l2 <= 1e-8);
  CHECK_THAT(fit.coefficient.row(0).cwiseAbs().maxCoeff(), WithinAbs(0.0, 1e-12));
}

TEST_CASE("where a curve leaves the slope across it open, there is none", "[boundary][displacement_fit]") {
  const BilinearBasis basis({Vec2(-1.0, -1.0), Vec2(0.3, 0.3), {8, 8}});
  const Edge edge = edge_of(line({-0.8, 0.07}, {0.9, 0.07}), basis.grid());
  const auto uniform = [](const Vec2&) { return Vec2(1.0, -2.0); };
  const DisplacementFit fit = fit_displacement(basis, std::vector{held(edge, false, uniform)});
  for (std::size_t k = 0; k < edge.points.size(); ++k) {
    const Support support = basis.support(edge.points[k].cell, edge.points[k].x);
    CHECK_THAT(support.gradient_of(fit.coefficient).cwiseAbs().maxCoeff(), WithinAbs(0.0, 1e-3));
  }
}

TEST_CASE("all curves are fitted together", "[boundary][displacement_fit]") {
  const BilinearBasis basis({Vec2(-1.0, -1.0), Vec2(0.3, 0.3), {8, 8}});
  const Edge moved = edge_of(line({-0.8, 0.07}, {0.1, 0.07}), basis.grid());
  const Edge still = edge_of(line({0.1, 0.07}, {0.1, -0.8}), basis.grid());
  const auto rising = [](const Vec2& x) { return Vec2(0.1 - x.x(), 0.0); };
  const auto nothing = [](const Vec2&) -> Vec2 { return Vec2::Zero(); };
  const DisplacementFit fit =
      fit_displacement(basis, std::vector{held(moved, false, rising), held(still, false, nothing)});
  const auto [at_moved, at_still] = std::pair(fit.error[0], fit.error[1]);
  CHECK(at_moved.l2 <= 0.1 * 0.9 * std::sqrt(0.9 / 3.0));  // a kink of the data inside a cell: a tenth of it
  CHECK(at_still.l2 <= 0.1 * 0.9 * std::sqrt(0.9 / 3.0));
  const DisplacementFit alone = fit_displacement(basis, std::vector{held(moved, false, rising)});
  double trace = 0.0;
  for (const BoundaryPoint& p : still.points)
    trace = std::max(trace, basis.support(p.cell, p.x).interpolate(alone.coefficient).norm());
  CHECK(trace > 0.0);
}

namespace {

/// Displacement of the plate with a hole.
Vec2 plate(const Vec2& x) {
  static const ExactSolution exact =
      exact_solution(PlateWithHole{0.5, 1e6}, {1e7, 0.2, Plane::stress}, [](double) { return 1.0; });
  return exact.displacement(x, 1.0);
}

/// Error of the plate's outer displacements along the curve, h = 2^-k, √(∫ |·|² dS).
double plate_error(Case::Grid grid, int k) {
  grid.lower = Vec2::Zero();
  grid.upper = Vec2(2.25, 2.25);
  grid.cell_size = std::ldexp(1.0, -k) * Vec2::Ones();
  const std::unique_ptr<const Basis> basis = test::basis_of(grid);
  const Edge edge = edge_of(test::plate_outer(), basis->grid());
  return fit_displacement(*basis, std::vector{held(edge, false, plate)}).error[0].l2;
}

}  // namespace

TEST_CASE("on every basis polynomials of its degree are reproduced along any curve", "[boundary][displacement_fit]") {
  test::Random random(6);
  for (const auto& [name, grid] : test::every_grid({-1.0, -1.0}, 2.0, 9)) {
    const std::unique_ptr<const Basis> basis = test::basis_of(grid);
    for (int draw = 0; draw < 5; ++draw) {
      CAPTURE(name, draw);
      const Edge edge = edge_of(circle(random.vector(-0.2, 0.2), random.uniform(0.2, 0.6), 12, false), basis->grid());
      const Vec2 direction = random.direction();
      const auto power = [&](const Vec2& x) -> Vec2 {
        return std::pow(0.3 + direction.dot(x), basis->degree()) * Vec2(1.0, -0.5);
      };
      CHECK(fit_displacement(*basis, std::vector{held(edge, false, power)}).error[0].l2 <= 2e-8);
    }
  }
}

TEST_CASE("on smooth bases the fit converges with order 2.5 and better", "[boundary][displacement_fit]") {
  Case::Grid grid;
  grid.basis = Case::BasisType::powell_sabin;
  CHECK(std::log2(plate_error(grid, 2) / plate_error(grid, 4)) / 2.0 >= 2.5);
  CHECK(plate_error(grid, 4) <= 3e-8);
  grid.basis = Case::BasisType::bspline;
  CHECK(std::log2(plate_error(grid, 2) / plate_error(grid, 4)) / 2.0 >= 2.5);
  CHECK(plate_error(grid, 4) <= 1.2e-8);
  grid.degree = 3;
  CHECK(std::log2(plate_error(grid, 2) / plate_error(grid, 4)) / 2.0 >= 3.5);
  CHECK(plate_error(grid, 4) <= 1.2e-9);
}

TEST_CASE("a fit with few points stays behind where segments end at edges of main triangles only",
          "[boundary][displacement_fit]") {
  const TriangleMesh mesh = triangulate({Vec2::Zero(), {0.125, 0.125}, {18, 18}}, TrianglePattern::diagonal);
  const PowellSabinBasis basis(mesh);
  const auto edge_with = [&](int points) {
    return make_edge(test::plate_outer(), basis.grid(),
                     std::vector<char>(static_cast<std::size_t>(basis.grid().cells()), 1), gauss(points));
  };
  const Edge fine = edge_with(6);
  const auto error = [&](const Edge& edge) {
    const DisplacementFit fit = fit_displacement(basis, std::vector{held(edge, false, plate)});
    double squares = 0.0;
    for (const BoundaryPoint& p : fine.points)
      squares += p.weight * (basis.support(p.cell, p.x).interpolate(fit.coefficient) - plate(p.x)).squaredNorm();
    return std::sqrt(squares);
  };
  Edge unsplit = edge_with(2);  // two points a segment of the main mesh, each as a segment of its own sub-triangle
  unsplit.points = boundary_points(unsplit.curve, trace(unsplit.curve, TriangleGrid(mesh), "outer"), gauss(2));
  unsplit.points_per_segment = 1;
  unsplit.segments.clear();
  unsplit.support_cell.clear();
  for (BoundaryPoint& p : unsplit.points) {
    p.cell = basis.grid().locate(p.x, 6 * p.cell).value();
    unsplit.support_cell.push_back(p.cell);
    unsplit.segments.push_back({p.span, p.u, p.u, p.cell});
  }
  CHECK(error(unsplit) >= 4.0 * error(edge_with(2)));
  CHECK(error(unsplit) >= 10.0 * error(edge_with(3)));
  CHECK(error(edge_with(3)) <= 1.2 * error(edge_with(4)));
}

TEST_CASE("on every basis the fit stays smooth in cells that a curve barely touches", "[boundary][displacement_fit]") {
  for (const auto& [name, grid] : test::every_grid({-1.0, -1.0}, 2.0, 8)) {
    const std::unique_ptr<const Basis> basis = test::basis_of(grid);
    for (const double touch : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
      CAPTURE(name, touch);
      const Edge edge = edge_of(circle({0.0, 0.0}, 0.5 + touch, 16, false), basis->grid());
      const DisplacementFit fit = fit_displacement(*basis, std::vector{held(edge, false, wave)});
      double steepest = 0.0;
      for (const BoundaryPoint& p : edge.points)
        steepest = std::max(steepest, basis->support(p.cell, p.x).gradient_of(fit.coefficient).norm());
      CHECK(steepest <= 12.0);  // that of the field itself is below 4.6 on the circle
    }
  }
}
