// What a basis promises, whatever its functions: tested on the bases that there are.
#include "shoreline/bases/basis.hpp"

#include <catch2/catch.hpp>

#include "meshes.hpp"
#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/bspline.hpp"
#include "shoreline/bases/linear_triangle.hpp"
#include "shoreline/bases/powell_sabin.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

namespace {

/// A basis on a random grid, one of its cells, and a point in the box around it or up to two boxes off.
struct Draw {
  std::unique_ptr<const Basis> basis;
  Index cell;
  Vec2 x;
};

std::unique_ptr<const Basis> any_basis(test::Random& random) {
  const Index kind = random.whole(0, 3);
  if (kind == 0) return std::make_unique<BilinearBasis>(random.grid());
  if (kind == 3) return std::make_unique<BSplineBasis>(random.grid(), random.whole(1, 3));
  const TrianglePattern pattern = random.whole(0, 1) == 0 ? TrianglePattern::diagonal : TrianglePattern::four;
  TriangleMesh mesh = test::lattice(random.whole(2, 5), random.whole(2, 5), pattern, random.vector(0.5, 2.0));
  test::place(mesh, random);
  if (kind == 1) return std::make_unique<LinearTriangleBasis>(mesh);
  return std::make_unique<PowellSabinBasis>(mesh);
}

std::vector<Draw> draws(unsigned seed, int count) {
  test::Random random(seed);
  std::vector<Draw> all;
  for (int k = 0; k < count; ++k) {
    auto basis = any_basis(random);
    const Index cell = random.whole(0, basis->grid().cells() - 1);
    const std::vector<Vec2> polygon = basis->grid().polygon(cell);
    Box box{polygon[0], polygon[0]};
    for (const Vec2& p : polygon) box = {box.lower.cwiseMin(p), box.upper.cwiseMax(p)};
    const Vec2 x = box.lower + (box.upper - box.lower).cwiseProduct(random.vector(-2.0, 3.0));
    all.push_back({std::move(basis), cell, x});
  }
  return all;
}

/// Σ|φ|, at least 1: what rounding errors at a place are measured by; far outside a cell its polynomials grow.
double size_of(const Support& support) { return support.value.cwiseAbs().sum(); }

Eigen::Matrix2Xd control_points(const Basis& basis) {
  Eigen::Matrix2Xd points(2, basis.functions());
  for (Index f = 0; f < basis.functions(); ++f) points.col(f) = basis.control_point(f);
  return points;
}

}  // namespace

TEST_CASE("functions sum to one and their gradients to zero, in and outside the cell", "[bases][basis]") {
  for (const auto& [basis, cell, x] : draws(1, 100)) {
    const Support support = basis->support(cell, x);
    const double size = size_of(support);
    CHECK_THAT(support.value.sum(), WithinAbs(1.0, 1e-14 * size));
    CHECK_THAT(support.gradient.rowwise().sum().norm(), WithinAbs(0.0, 1e-12 * size));
    CHECK_THAT(basis->curvatures(cell, x).rowwise().sum().norm(), WithinAbs(0.0, 1e-10 * size));
  }
}

TEST_CASE("control points reproduce position: linear fields are exact", "[bases][basis]") {
  test::Random random(2);
  for (const auto& [basis, cell, x] : draws(3, 100)) {
    const Support support = basis->support(cell, x);
    const Eigen::Matrix2Xd points = control_points(*basis);
    const double size = size_of(support);
    CHECK_THAT((support.interpolate(points) - x).norm(), WithinAbs(0.0, 1e-13 * size));

    const Vec2 shift = random.vector();
    Mat2 gradient;
    gradient << random.vector(), random.vector();
    const Eigen::Matrix2Xd linear = (gradient * points).colwise() + shift;
    CHECK_THAT((support.interpolate(linear) - gradient * x - shift).norm(), WithinAbs(0.0, 1e-12 * size));
    CHECK_THAT((support.gradient_of(linear) - gradient).norm(), WithinAbs(0.0, 1e-11 * size));
  }
}

TEST_CASE("a support holds the functions of its cell in their order, as many as announced", "[bases][basis]") {
  for (const auto& [basis, cell, x] : draws(4, 100)) {
    const Support support = basis->support(cell, x);
    CHECK(support.function == basis->functions_of(cell));
    CHECK(support.function.size() == basis->functions_per_cell());
    CHECK(support.value.size() == basis->functions_per_cell());
    CHECK(support.gradient.cols() == basis->functions_per_cell());
    CHECK(basis->functions_per_cell() <= max_support);
    CHECK(support.function.minCoeff() >= 0);
    CHECK(support.function.maxCoeff() < basis->functions());
  }
}

TEST_CASE("many points at once give what each gives alone", "[bases][basis]") {
  test::Random random(5);
  for (const auto& [basis, cell, x] : draws(6, 20)) {
    const auto n = static_cast<std::size_t>(basis->functions_per_cell());
    std::vector<Vec2> points(7);
    for (Vec2& point : points) point = x + random.vector();
    std::vector<double> value(points.size() * n);
    std::vector<double> gradient(points.size() * 2 * n);
    basis->evaluate(cell, points, value.data(), gradient.data());
    for (std::size_t q = 0; q < points.size(); ++q) {
      const Support support = basis->support(cell, points[q]);
      for (std::size_t a = 0; a < n; ++a) {
        const auto column = static_cast<Eigen::Index>(a);
        CHECK(value[q * n + a] == support.value[column]);
        CHECK(gradient[q * 2 * n + 2 * a] == support.gradient(0, column));
        CHECK(gradient[q * 2 * n + 2 * a + 1] == support.gradient(1, column));
      }
    }
  }
}

TEST_CASE("gradients and second derivatives match finite differences", "[bases][basis]") {
  for (const auto& [basis, cell, x] : draws(7, 100)) {
    const Support here = basis->support(cell, x);
    const ShortCurvatures second = basis->curvatures(cell, x);
    const double step = 1e-5 * basis->grid().size(cell);
    const double h = basis->grid().size(cell);
    const double size = size_of(here);
    for (int axis = 0; axis < 2; ++axis) {
      const Support ahead = basis->support(cell, x + step * Vec2::Unit(axis));
      const Support behind = basis->support(cell, x - step * Vec2::Unit(axis));
      const auto slope = (ahead.value - behind.value) / (2.0 * step);
      CHECK_THAT((here.gradient.row(axis).transpose() - slope).norm() * h, WithinAbs(0.0, 1e-8 * size));
      const auto bend = ((ahead.gradient - behind.gradient) / (2.0 * step)).eval();
      CHECK_THAT((second.row(axis) - bend.row(axis)).norm() * h * h, WithinAbs(0.0, 1e-7 * size));
      CHECK_THAT((second.row(2) - bend.row(1 - axis)).norm() * h * h, WithinAbs(0.0, 1e-7 * size));
    }
  }
}

TEST_CASE("derivatives up to the announced order are continuous across faces", "[bases][basis]") {
  test::Random random(8);
  for (const auto& [basis, cell, x] : draws(9, 50)) {
    const Eigen::Matrix2Xd field = random.field(basis->functions());
    for (const Face& face : basis->grid().faces(cell)) {
      const Vec2 on_face = face.a + random.uniform(0.0, 1.0) * (face.b - face.a);
      const Support left = basis->support(face.cell, on_face);
      const Support right = basis->support(face.neighbour, on_face);
      CHECK_THAT((left.interpolate(field) - right.interpolate(field)).norm(), WithinAbs(0.0, 1e-13));
      const double jump = (left.gradient_of(field) - right.gradient_of(field)).norm();
      if (basis->continuity() == 0) CHECK(jump > 1e-6);
      if (basis->continuity() == 1) CHECK(jump < 1e-11 * left.gradient.norm());
    }
  }
}
