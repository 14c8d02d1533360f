#include "shoreline/bases/bilinear.hpp"

#include <catch2/catch.hpp>

#include "../random.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

TEST_CASE("each bilinear function is one at its node and zero at the others", "[bases][bilinear]") {
  test::Random random(1);
  for (int draw = 0; draw < 20; ++draw) {
    const BilinearBasis basis(random.grid());
    CHECK(basis.functions() == basis.grid().nodes());
    for (Index cell = 0; cell < basis.grid().cells(); ++cell)
      for (const Vec2& node : basis.grid().polygon(cell)) {
        const Support support = basis.support(cell, node);
        for (Eigen::Index a = 0; a < 4; ++a) {
          const bool own = (basis.control_point(support.function[a]) - node).norm() < 1e-12;
          CHECK_THAT(support.value[a], WithinAbs(own ? 1.0 : 0.0, 1e-13));
        }
      }
  }
}

TEST_CASE("bilinear functions are not negative in their cell", "[bases][bilinear]") {
  test::Random random(2);
  for (int draw = 0; draw < 500; ++draw) {
    const BilinearBasis basis(random.grid());
    const Vec2 x = random.in(basis.grid().bounds());
    const Index cell = basis.grid().locate(x, 0).value();
    CHECK(basis.support(cell, x).value.minCoeff() >= -1e-14);
  }
}

TEST_CASE("the product xy, which a cell reproduces, is continued outside it", "[bases][bilinear]") {
  test::Random random(3);
  for (int draw = 0; draw < 100; ++draw) {
    const BilinearBasis basis(random.grid());
    const Index cell = random.whole(0, basis.grid().cells() - 1);
    const Vec2 x = basis.grid().corner(cell) + basis.grid().spacing().cwiseProduct(random.vector(-3.0, 4.0));
    const Support support = basis.support(cell, x);
    double product = 0.0;
    Vec2 gradient = Vec2::Zero();
    double mixed = 0.0;
    for (Eigen::Index a = 0; a < 4; ++a) {
      const double nodal = basis.control_point(support.function[a]).prod();
      product += support.value[a] * nodal;
      gradient += support.gradient.col(a) * nodal;
      mixed += basis.curvatures(cell, x)(2, a) * nodal;
    }
    CHECK_THAT(product, WithinAbs(x.prod(), 1e-11));
    CHECK_THAT((gradient - Vec2(x.y(), x.x())).norm(), WithinAbs(0.0, 1e-9));
    CHECK_THAT(mixed, WithinAbs(1.0, 1e-8));
  }
}

TEST_CASE("the announced degree is the one that is reproduced", "[bases][bilinear]") {
  const BilinearBasis basis(QuadrilateralGrid(Vec2::Zero(), Vec2::Ones(), {1, 1}));
  CHECK(basis.degree() == 1);
  CHECK(basis.continuity() == 0);
  const Support middle = basis.support(0, Vec2(0.5, 0.5));
  double square = 0.0;
  for (Eigen::Index a = 0; a < 4; ++a)
    square += middle.value[a] * std::pow(basis.control_point(middle.function[a]).x(), 2);
  CHECK_THAT(square, WithinAbs(0.5, 1e-15));  // x² is not: it would be 0.25
}
