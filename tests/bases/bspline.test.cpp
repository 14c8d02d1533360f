#include "shoreline/bases/bspline.hpp"

#include <catch2/catch.hpp>

#include "../random.hpp"
#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/error.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

TEST_CASE("degree 1 is the bilinear basis, function by function", "[bases][bspline]") {
  test::Random random(1);
  for (int draw = 0; draw < 50; ++draw) {
    const QuadrilateralGrid grid = random.grid();
    const BilinearBasis bilinear(grid);
    const BSplineBasis spline(grid, 1);
    REQUIRE(spline.functions() == bilinear.functions());
    const Index cell = random.whole(0, grid.cells() - 1);
    const Vec2 x = grid.corner(cell) + grid.spacing().cwiseProduct(random.vector(-1.0, 2.0));
    const Support a = bilinear.support(cell, x);
    const Support b = spline.support(cell, x);
    CHECK(a.function == b.function);
    CHECK_THAT((a.value - b.value).norm(), WithinAbs(0.0, 1e-13));
    CHECK_THAT((a.gradient - b.gradient).norm(), WithinAbs(0.0, 1e-11));
    for (Index f = 0; f < spline.functions(); ++f)
      CHECK_THAT((spline.control_point(f) - bilinear.control_point(f)).norm(), WithinAbs(0.0, 1e-13));
  }
}

TEST_CASE("B-splines are never negative on their cells", "[bases][bspline]") {
  test::Random random(2);
  for (const int degree : {1, 2, 3})
    for (int draw = 0; draw < 100; ++draw) {
      const BSplineBasis basis(random.grid(), degree);
      const Index cell = random.whole(0, basis.grid().cells() - 1);
      const Vec2 x = basis.grid().corner(cell) + basis.grid().spacing().cwiseProduct(random.vector(0.0, 1.0));
      CHECK(basis.support(cell, x).value.minCoeff() >= -1e-14);
    }
}

TEST_CASE("B-splines of degree p reproduce polynomials of degree p in x and y", "[bases][bspline]") {
  // by blossoming: the coefficient of x^k is the mean of products of k of the function's p inner knots
  test::Random random(3);
  for (const int degree : {2, 3})
    for (int draw = 0; draw < 50; ++draw) {
      const QuadrilateralGrid grid({0.0, 0.0}, {1.0, 1.0}, {random.whole(1, 6), random.whole(1, 6)});
      const BSplineBasis basis(grid, degree);
      const auto squares = [&](Index i, Index spans) {
        const auto knot = [&](Index k) { return static_cast<double>(std::clamp(k - degree, Index{0}, spans)); };
        double sum = 0.0;
        for (Index a = 1; a <= degree; ++a)
          for (Index b = a + 1; b <= degree; ++b) sum += knot(i + a) * knot(i + b);
        return sum / (degree * (degree - 1) / 2);
      };
      Eigen::Matrix2Xd field(2, basis.functions());
      for (Index f = 0; f < basis.functions(); ++f)
        field.col(f) = Vec2(squares(f % (grid.columns() + degree), grid.columns()),
                            squares(f / (grid.columns() + degree), grid.rows()));
      const Vec2 x = random.in(grid.bounds());
      const Support support = basis.support(grid.locate(x, 0).value(), x);
      CHECK_THAT((support.interpolate(field) - x.cwiseProduct(x)).norm(), WithinAbs(0.0, 1e-11));
    }
}

TEST_CASE("the border is interpolated: one function is 1 at a corner of the grid", "[bases][bspline]") {
  for (const int degree : {1, 2, 3}) {
    const BSplineBasis basis({{-1.0, 2.0}, {0.5, 0.25}, {4, 3}}, degree);
    const Support support = basis.support(0, {-1.0, 2.0});
    CHECK(support.value[0] == 1.0);
    CHECK_THAT(support.value.tail(support.value.size() - 1).norm(), WithinAbs(0.0, 1e-15));
    CHECK((basis.control_point(0) - Vec2(-1.0, 2.0)).norm() == 0.0);
    CHECK_THAT((basis.control_point(basis.functions() - 1) - Vec2(1.0, 2.75)).norm(), WithinAbs(0.0, 1e-15));
  }
}

TEST_CASE("functions of a cell are the products of its factors", "[bases][bspline]") {
  test::Random random(6);
  for (const int degree : {1, 2, 3}) {
    const BSplineBasis basis(random.grid(), degree);
    const int n = degree + 1;
    for (Index cell = 0; cell < basis.grid().cells(); ++cell) {
      const ProductCell product = *basis.product_cell(cell);
      const Vec2 xi = random.in({Vec2::Zero(), Vec2::Ones()});
      const auto factor = [&](std::span<const double> c, int function, double at) {
        double sum = 0.0;
        for (int power = degree; power >= 0; --power)
          sum = sum * at + c[static_cast<std::size_t>(function + power * n)];
        return sum;
      };
      const Support support = basis.support(cell, product.corner + product.size.cwiseProduct(xi));
      for (int a = 0; a < n * n; ++a)
        CHECK_THAT(factor(product.x, a % n, xi.x()) * factor(product.y, a / n, xi.y()),
                   WithinAbs(support.value[a], 1e-13));
    }
  }
}

TEST_CASE("a degree that is not there is refused", "[bases][bspline]") {
  for (const int degree : {-1, 0, 4})
    CHECK_THROWS_WITH(BSplineBasis({{0, 0}, {1, 1}, {2, 2}}, degree),
                      Contains("1 to 3") && Contains(std::to_string(degree)));
}
