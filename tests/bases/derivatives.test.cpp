#include "shoreline/bases/derivatives.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "meshes.hpp"
#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/bspline.hpp"
#include "shoreline/bases/linear_triangle.hpp"
#include "shoreline/bases/powell_sabin.hpp"

using namespace shoreline;

namespace {

std::vector<std::unique_ptr<const Basis>> bases(test::Random& random) {
  std::vector<std::unique_ptr<const Basis>> all;
  const QuadrilateralGrid rectangles({-0.3, 0.2}, {0.7, 0.4}, {4, 5});
  const TriangleMesh triangles = delaunay(test::jittered_points(4, 4, random));
  all.push_back(std::make_unique<BilinearBasis>(rectangles));
  all.push_back(std::make_unique<LinearTriangleBasis>(triangles));
  all.push_back(std::make_unique<PowellSabinBasis>(triangles));
  for (const int degree : {2, 3}) all.push_back(std::make_unique<BSplineBasis>(rectangles, degree));
  return all;
}

/// The tensor of order k at x from differences of that of order k − 1, in the rows of derivatives.
ShortDerivatives by_differences(const Basis& basis, Index cell, const Vec2& x, int order) {
  constexpr double step = 1e-5;
  const auto slope = [&](const Vec2& e) -> ShortDerivatives {
    if (order == 1) {
      const ShortVector ahead = basis.support(cell, x + step * e).value;
      const ShortVector behind = basis.support(cell, x - step * e).value;
      return (ahead - behind).transpose() / (2.0 * step);
    }
    if (order == 2)
      return (basis.support(cell, x + step * e).gradient - basis.support(cell, x - step * e).gradient) / (2.0 * step);
    return (basis.curvatures(cell, x + step * e) - basis.curvatures(cell, x - step * e)) / (2.0 * step);
  };
  const ShortDerivatives in_x = slope(Vec2::UnitX());
  const ShortDerivatives in_y = slope(Vec2::UnitY());
  ShortDerivatives rows(order + 1, basis.functions_per_cell());
  if (order == 1) rows << in_x, in_y;
  if (order == 2) rows << in_x.row(0), in_y.row(1), std::numbers::sqrt2 * in_y.row(0);
  if (order == 3)
    rows << in_x.row(0), in_y.row(1), std::numbers::sqrt3 * in_y.row(0), std::numbers::sqrt3 * in_x.row(1);
  return rows;
}

}  // namespace

TEST_CASE("derivatives are limits of differences", "[bases][derivatives]") {
  test::Random random(1);
  for (const auto& basis : bases(random))
    for (int draw = 0; draw < 20; ++draw) {
      const Index cell = random.whole(0, basis->grid().cells() - 1);
      const Vec2 x = basis->grid().polygon(cell)[0] + random.vector(-0.2, 0.2);
      for (const int order : {1, 2, 3}) {
        CAPTURE(basis->degree(), basis->functions_per_cell(), order);
        const ShortDerivatives d = derivatives(*basis, cell, x, order);
        CHECK((d - by_differences(*basis, cell, x, order)).norm() <= 1e-7 * (1.0 + d.norm()));
      }
    }
}

TEST_CASE("a derivative along a direction is the limit of differences along it", "[bases][derivatives]") {
  constexpr double step = 1e-5;
  test::Random random(2);
  for (const auto& basis : bases(random))
    for (int draw = 0; draw < 20; ++draw) {
      const Index cell = random.whole(0, basis->grid().cells() - 1);
      const Vec2 x = basis->grid().polygon(cell)[0] + random.vector(-0.2, 0.2);
      const Vec2 direction = random.direction();
      const auto along = [&](double s, int order) -> ShortVector {
        if (order == 0) return basis->support(cell, x + s * direction).value;
        return directional_derivative(*basis, cell, x + s * direction, direction, order);
      };
      for (const int order : {1, 2, 3}) {
        CAPTURE(basis->degree(), basis->functions_per_cell(), order);
        const ShortVector difference = (along(step, order - 1) - along(-step, order - 1)) / (2.0 * step);
        CHECK((along(0.0, order) - difference).norm() <= 1e-7 * (1.0 + difference.norm()));
      }
    }
}

TEST_CASE("there are no derivatives of other orders", "[bases][derivatives]") {
  const BilinearBasis basis({Vec2::Zero(), Vec2::Ones(), {1, 1}});
  CHECK_THROWS_WITH(derivatives(basis, 0, {0.5, 0.5}, 4), Catch::Contains("1 to 3, got 4"));
  CHECK_THROWS_WITH(derivatives(basis, 0, {0.5, 0.5}, 0), Catch::Contains("1 to 3, got 0"));
}
