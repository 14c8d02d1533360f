#include "shoreline/bases/projection.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "meshes.hpp"
#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/bspline.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/bases/linear_triangle.hpp"
#include "shoreline/bases/powell_sabin.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct NamedBasis {
  std::string name;
  std::unique_ptr<const Basis> basis;
};

std::vector<NamedBasis> bases(test::Random& random) {
  std::vector<NamedBasis> all;
  all.push_back({"bilinear", std::make_unique<BilinearBasis>(random.grid())});
  for (const int degree : {1, 2, 3})
    all.push_back(
        {"B-spline of degree " + std::to_string(degree), std::make_unique<BSplineBasis>(random.grid(), degree)});
  for (const auto& [name, mesh] : test::meshes(random)) {
    all.push_back({"linear, " + name, std::make_unique<LinearTriangleBasis>(mesh)});
    all.push_back({"Powell-Sabin, " + name, std::make_unique<PowellSabinBasis>(mesh)});
  }
  return all;
}

Eigen::MatrixXd values_of(const WeightedPoints& points, auto&& f) {
  Eigen::MatrixXd value(static_cast<Eigen::Index>(points.x.size()), 1);
  for (Eigen::Index p = 0; p < value.rows(); ++p) value(p, 0) = f(points.x[static_cast<std::size_t>(p)]);
  return value;
}

/// Value and x-slope of a field at a place in a cell.
std::pair<double, double> field_at(const Basis& basis, const Eigen::VectorXd& coefficient, Index cell, const Vec2& x) {
  const Support support = basis.support(cell, x);
  double value = 0.0;
  double slope = 0.0;
  for (Eigen::Index a = 0; a < support.value.size(); ++a) {
    value += coefficient[support.function[a]] * support.value[a];
    slope += coefficient[support.function[a]] * support.gradient(0, a);
  }
  return {value, slope};
}

struct SineErrors {
  double value;    ///< ‖f_h − f‖ in L2, f = sin πx sin πy
  double x_slope;  ///< ‖∂x f_h − ∂x f‖
};

SineErrors project_sines(const Basis& basis, Mass mass) {
  const auto sines = [](const Vec2& x) { return std::sin(test::pi * x.x()) * std::sin(test::pi * x.y()); };
  const WeightedPoints points = integration_points(basis.grid(), 11);
  const Eigen::MatrixXd coefficient = project(basis, points, values_of(points, sines), mass);
  SineErrors square{0.0, 0.0};
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    const Vec2& x = points.x[p];
    const auto [value, slope] = field_at(basis, coefficient.col(0), points.cell[p], x);
    square.value += points.weight[p] * std::pow(value - sines(x), 2);
    square.x_slope +=
        points.weight[p] * std::pow(slope - test::pi * std::cos(test::pi * x.x()) * std::sin(test::pi * x.y()), 2);
  }
  return {std::sqrt(square.value), std::sqrt(square.x_slope)};
}

TriangleMesh unit_square(Index squares) {
  return test::lattice(squares, squares, TrianglePattern::diagonal, Vec2::Constant(1.0 / squares));
}

std::vector<SineErrors> powell_sabin_errors(Mass mass) {
  std::vector<SineErrors> errors;
  for (const Index squares : {2, 4, 8, 16})
    errors.push_back(project_sines(PowellSabinBasis(unit_square(squares)), mass));
  return errors;
}

double factorial(int n) { return std::tgamma(n + 1.0); }

}  // namespace

TEST_CASE("integration points are exact to their degree", "[bases][projection]") {
  const int degree = GENERATE(0, 1, 2, 5, 8);
  const BilinearBasis square(QuadrilateralGrid({0.0, 0.0}, {1.0, 1.0}, {1, 1}));
  const LinearTriangleBasis triangle(TriangleMesh{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, {{0, 1, 2}}});
  const WeightedPoints in_square = integration_points(square.grid(), degree);
  const WeightedPoints in_triangle = integration_points(triangle.grid(), degree);
  const auto integral = [](const WeightedPoints& points, int a, int b) {
    double sum = 0.0;
    for (std::size_t p = 0; p < points.x.size(); ++p)
      sum += points.weight[p] * std::pow(points.x[p].x(), a) * std::pow(points.x[p].y(), b);
    return sum;
  };
  for (int a = 0; a <= degree; ++a)
    for (int b = 0; a + b <= degree; ++b) {
      CHECK_THAT(integral(in_square, a, b), WithinRel(1.0 / ((a + 1) * (b + 1)), 1e-13));
      CHECK_THAT(integral(in_triangle, a, b), WithinRel(factorial(a) * factorial(b) / factorial(a + b + 2), 1e-13));
    }
}

TEST_CASE("integration points lie in their cells and have their areas", "[bases][projection]") {
  test::Random random(1);
  for (const auto& [name, basis] : bases(random)) {
    CAPTURE(name);
    const WeightedPoints points = integration_points(basis->grid(), 3);
    std::vector<double> area(static_cast<std::size_t>(basis->grid().cells()), 0.0);
    for (std::size_t p = 0; p < points.x.size(); ++p) {
      CHECK(basis->grid().locate(points.x[p], points.cell[p]) == points.cell[p]);
      area[static_cast<std::size_t>(points.cell[p])] += points.weight[p];
    }
    for (Index cell = 0; cell < basis->grid().cells(); ++cell) {
      const std::vector<Vec2> corner = basis->grid().polygon(cell);
      double twice = 0.0;
      for (std::size_t k = 2; k < corner.size(); ++k) twice += cross(corner[k - 1] - corner[0], corner[k] - corner[0]);
      CHECK_THAT(area[static_cast<std::size_t>(cell)], WithinRel(0.5 * twice, 1e-9));
    }
  }
}

TEST_CASE("a polynomial of the basis's degree is its own consistent projection", "[bases][projection]") {
  test::Random random(2);
  for (const auto& [name, basis] : bases(random)) {
    CAPTURE(name);
    const int p = basis->degree();
    const Vec2 along = random.direction();
    const double length = (basis->grid().bounds().upper - basis->grid().bounds().lower).norm();
    const auto power = [&](const Vec2& x) {
      return std::pow(along.dot(x - basis->grid().bounds().lower) / length + 0.5, p);
    };
    const WeightedPoints points = integration_points(basis->grid(), 2 * p);
    const Eigen::MatrixXd coefficient = project(*basis, points, values_of(points, power), Mass::consistent);
    double worst = 0.0;
    for (std::size_t k = 0; k < points.x.size(); ++k) {
      const double value = field_at(*basis, coefficient.col(0), points.cell[k], points.x[k]).first;
      worst = std::max(worst, std::abs(value - power(points.x[k])));
    }
    CHECK_THAT(worst, WithinAbs(0.0, 1e-9));
  }
}

TEST_CASE("the error of a consistent projection sees no function", "[bases][projection]") {
  test::Random random(3);
  for (const auto& [name, basis] : bases(random)) {
    CAPTURE(name);
    const WeightedPoints points = integration_points(basis->grid(), 2 * basis->degree());
    const Eigen::MatrixXd value = values_of(points, [&](const Vec2&) { return random.uniform(-1.0, 1.0); });
    const Eigen::MatrixXd coefficient = project(*basis, points, value, Mass::consistent);
    Eigen::VectorXd product = Eigen::VectorXd::Zero(basis->functions());
    Eigen::VectorXd volume = Eigen::VectorXd::Zero(basis->functions());
    for (std::size_t k = 0; k < points.x.size(); ++k) {
      const Support support = basis->support(points.cell[k], points.x[k]);
      const double error = field_at(*basis, coefficient.col(0), points.cell[k], points.x[k]).first -
                           value(static_cast<Eigen::Index>(k), 0);
      for (Eigen::Index a = 0; a < support.value.size(); ++a) {
        product[support.function[a]] += points.weight[k] * support.value[a] * error;
        volume[support.function[a]] += points.weight[k] * support.value[a];
      }
    }
    CHECK_THAT(product.cwiseQuotient(volume).cwiseAbs().maxCoeff(), WithinAbs(0.0, 1e-9));
  }
}

TEST_CASE("a lumped projection stays within the extremes of the values", "[bases][projection]") {
  test::Random random(4);
  for (const auto& [name, basis] : bases(random)) {
    CAPTURE(name);
    const WeightedPoints points = integration_points(basis->grid(), 2);
    const Eigen::MatrixXd step =
        values_of(points, [&](const Vec2&) { return random.uniform(0.0, 1.0) < 0.5 ? 2.0 : 7.0; });
    const Eigen::MatrixXd coefficient = project(*basis, points, step, Mass::lumped);
    CHECK(coefficient.minCoeff() >= 2.0 - 1e-12);
    CHECK(coefficient.maxCoeff() <= 7.0 + 1e-12);
    CHECK(coefficient.maxCoeff() - coefficient.minCoeff() > 0.1);
  }
}

TEST_CASE("a lumped projection of position puts every function at its centroid", "[bases][projection]") {
  test::Random random(5);
  const PowellSabinBasis basis(unit_square(6));
  const WeightedPoints points = integration_points(basis.grid(), 3);
  Eigen::MatrixXd position(static_cast<Eigen::Index>(points.x.size()), 2);
  for (Eigen::Index p = 0; p < position.rows(); ++p)
    position.row(p) = points.x[static_cast<std::size_t>(p)].transpose();
  const Eigen::MatrixXd centroid = project(basis, points, position, Mass::lumped);
  double off = 0.0;  // of the control points, which reproduce position
  Vec2 mean = Vec2::Zero();
  for (Index f = 0; f < 3; ++f) {  // of an inner vertex: three functions whose control points go round it
    const Index function = 3 * (2 + 2 * 7) + f;
    off = std::max(off, (centroid.row(function).transpose() - basis.control_point(function)).norm());
    mean += centroid.row(function).transpose() / 3.0;
  }
  CHECK(off > 0.1 / 6.0);  // a fixed share of h, so the slope of the error does not vanish with h
  CHECK((mean - Vec2(2.0, 2.0) / 6.0).norm() < 0.1 / 6.0);
}

TEST_CASE("the projection of sin πx sin πy onto Powell-Sabin splines converges with order three",
          "[bases][projection]") {
  const std::vector<double> published{1.178e-2, 1.143e-3, 1.317e-4, 1.608e-5};
  const std::vector<SineErrors> error = powell_sabin_errors(Mass::consistent);
  for (std::size_t k = 0; k < error.size(); ++k) CHECK_THAT(error[k].value, WithinRel(published[k], 0.015));
  const double value_order = std::log2(error[2].value / error[3].value);
  const double slope_order = std::log2(error[2].x_slope / error[3].x_slope);
  CAPTURE(value_order, slope_order);
  CHECK((value_order > 2.9 && value_order < 3.15));
  CHECK((slope_order > 1.9 && slope_order < 2.15));
}

TEST_CASE("the slope of a lumped projection onto Powell-Sabin splines does not converge", "[bases][projection]") {
  const std::vector<SineErrors> error = powell_sabin_errors(Mass::lumped);
  const double value_order = std::log2(error[2].value / error[3].value);
  const double slope_order = std::log2(error[2].x_slope / error[3].x_slope);
  CAPTURE(value_order, slope_order, error[3].x_slope);
  CHECK(slope_order < 0.3);
  CHECK(error[3].x_slope > 0.1);
  CHECK((value_order > 0.8 && value_order < 1.5));  // 1 in the end: order 3/2 from the border still shows
}

TEST_CASE("the projection of sin πx sin πy onto linear triangles converges with order two", "[bases][projection]") {
  const std::vector<double> published{2.768e-2, 6.593e-3, 1.618e-3, 4.023e-4};
  std::vector<double> error;
  for (const Index squares : {4, 8, 16, 32})
    error.push_back(project_sines(LinearTriangleBasis(unit_square(squares)), Mass::consistent).value);
  CAPTURE(error);
  for (std::size_t k = 0; k < error.size(); ++k) CHECK_THAT(error[k], WithinRel(published[k], 0.001));
  CHECK_THAT(std::log2(error[2] / error[3]), WithinAbs(2.0, 0.05));
}

TEST_CASE("several fields are projected as each by itself", "[bases][projection]") {
  const Mass mass = GENERATE(Mass::consistent, Mass::lumped);
  test::Random random(6);
  const PowellSabinBasis basis(test::fan(5));
  const WeightedPoints points = integration_points(basis.grid(), 4);
  const auto fields = Eigen::MatrixXd::NullaryExpr(static_cast<Eigen::Index>(points.x.size()), 3, [&] {
                        return random.uniform(-1.0, 1.0);
                      }).eval();
  const Eigen::MatrixXd together = project(basis, points, fields, mass);
  for (Eigen::Index k = 0; k < 3; ++k)
    CHECK((together.col(k) - project(basis, points, fields.col(k), mass).col(0)).norm() < 1e-13);
}

TEST_CASE("points in some of the cells determine the functions of these alone", "[bases][projection]") {
  const BilinearBasis basis(QuadrilateralGrid({0.0, 0.0}, {1.0, 1.0}, {4, 1}));
  const std::vector<Vec2> x{{1.2, 0.1}, {1.9, 0.3}, {1.4, 0.9}, {1.8, 0.6}, {1.5, 0.5}};
  const std::vector<double> weight{1.0, 2.0, 0.5, 1.0, 3.0};
  const WeightedPoints points = points_in(basis.grid(), x, weight);
  CHECK(points.cell == std::vector<Index>(5, 1));
  const Eigen::MatrixXd coefficient = project(
      basis, points, values_of(points, [](const Vec2& at) { return 3.0 + at.x() - 2.0 * at.y(); }), Mass::consistent);
  for (Index node = 0; node < basis.functions(); ++node) {
    const Vec2 at = basis.control_point(node);
    const bool seen = at.x() == 1.0 || at.x() == 2.0;
    CHECK_THAT(coefficient(node, 0), WithinAbs(seen ? 3.0 + at.x() - 2.0 * at.y() : 0.0, 1e-12));
  }
}

TEST_CASE("what cannot be projected is refused with the function and its place", "[bases][projection]") {
  const BilinearBasis basis(QuadrilateralGrid({0.0, 0.0}, {1.0, 1.0}, {2, 1}));
  const auto at = [&](const std::vector<Vec2>& x) {
    return points_in(basis.grid(), x, std::vector<double>(x.size(), 1.0));
  };
  const auto onto = [&](const WeightedPoints& points, Mass mass) {
    return project(basis, points, Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(points.x.size()), 1), mass);
  };
  CHECK_THROWS_WITH(at({{0.5, 0.5}, {2.5, 0.5}}), Contains("point 1 at (2.5, 0.5)") && Contains("outside the grid"));
  CHECK_THROWS_WITH(onto(at({{0.0, 0.0}}), Mass::lumped), Contains("function 1 at (1, 0) sees no point"));
  CHECK_THROWS_WITH(onto(at({{0.25, 0.5}, {0.75, 0.5}}), Mass::consistent),
                    Contains("singular") && Contains("function ") && Contains("more points"));
  CHECK_THROWS_WITH(onto(at({{0.21, 0.37}, {0.83, 0.11}, {0.47, 0.93}}), Mass::consistent), Contains("singular"));
  CHECK_NOTHROW(onto(at({{0.25, 0.5}, {0.75, 0.5}}), Mass::lumped));
  CHECK_THROWS_AS(onto(at({}), Mass::consistent), InvalidArgument);
  CHECK_THROWS_AS(project(basis, at({{0.5, 0.5}}), Eigen::MatrixXd::Ones(2, 1), Mass::lumped), InvalidArgument);
  CHECK_THROWS_WITH(integration_points(basis.grid(), -1), Contains("-1"));
  CHECK_THROWS_AS(integration_points(basis.grid(), 64), InvalidArgument);
}
