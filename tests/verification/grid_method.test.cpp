// Conventional essential conditions on every basis, on lines at the border of the grid and inside it.
#include <catch2/catch.hpp>

#include "../bodies_on_lines.hpp"
#include "../scenes.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const Essential fixed{.normal_only = false, .method = EssentialMethod::grid};
const Essential roller{.normal_only = true, .method = EssentialMethod::grid};
constexpr double side = test::square_side;
constexpr double load = 1e3;

Mat3 tangent() { return LinearElastic(1e6, 0.3, Plane::strain).tangent(Stress::Zero()); }

/// A field in the axes of a body that is turned.
ExactSolution turned(double angle, std::function<Vec2(const Vec2&)> displacement,
                     std::function<Mat2(const Vec2&)> stress) {
  const Mat2 turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return {.displacement = [=](const Vec2& x, double) -> Vec2 { return turn * displacement(turn.transpose() * x); },
          .stress = [=](const Vec2& x, double) -> Vec3 {
            const Mat2 s = turn * stress(turn.transpose() * x) * turn.transpose();
            return {s(0, 0), s(1, 1), s(0, 1)};
          }};
}

Case::Traction pull(const test::Setting& setting, double x, double y) {
  const Vec2 t = setting.turned(x, y);
  return {std::array{Quantity(t.x()), Quantity(t.y())}};
}

struct Result {
  double displacement;
  double stress;
  RunRecord record;
};

/// Relative errors after one load step.
Result solve(const Case& problem, const ExactSolution& exact) {
  Scene scene = build_scene(problem);
  Result result{};
  run_load_steps(scene, {}, result.record);
  const ErrorNorms norms = error_norms(scene.points, exact, 1.0);
  result.displacement = norms.displacement_l2_relative.value();
  result.stress = norms.stress_l2_relative.value();
  return result;
}

std::vector<test::Setting> settings() {
  test::Random random(20180701);
  return test::settings(random);
}

bool smooth(const test::Setting& setting) {
  return setting.grid.basis == Case::BasisType::bspline || setting.grid.basis == Case::BasisType::powell_sabin;
}

/// X and Y of the body's own axes as formulas of X and Y.
std::array<Expression, 2> in_own_axes(const test::Setting& setting, const std::string& u, const std::string& v) {
  const double c = std::cos(setting.angle);
  const double s = std::sin(setting.angle);
  const auto place = [](std::string formula) {
    std::string all;
    for (const char letter : formula)
      all += letter == 'X' ? "(c*X+s*Y)" : letter == 'Y' ? "(c*Y-s*X)" : std::string(1, letter);
    return all;
  };
  const std::map<std::string, double> constants{{"c", c}, {"s", s}};
  return {Expression("c*(" + place(u) + ")-s*(" + place(v) + ")", constants),
          Expression("s*(" + place(u) + ")+c*(" + place(v) + ")", constants)};
}

}  // namespace

TEST_CASE("uniform compression between rollers is exact on every basis and line", "[verification][grid_method]") {
  for (const test::Setting& setting : settings()) {
    CAPTURE(setting.name);
    Case problem = test::body_on_lines(setting);
    for (const std::size_t k : {0u, 1u, 3u}) problem.boundaries[k].condition = roller;
    problem.boundaries[2].condition = pull(setting, 0.0, -load);
    const double strain = -load / tangent()(1, 1);
    const Mat2 stress = Vec2(tangent()(0, 1) * strain, -load).asDiagonal();
    const Result result = solve(problem, turned(
                                             setting.angle, [&](const Vec2& x) { return Vec2(0.0, strain * x.y()); },
                                             [&](const Vec2&) { return stress; }));
    CHECK(result.displacement <= 1e-10);
    CHECK(result.stress <= 1e-10);
    const auto& reactions = result.record.resultants.reactions;
    const Vec2 below = reactions.at("bottom").head<2>();
    CHECK_THAT((below - setting.turned(0.0, load * side)).norm(), WithinAbs(0.0, 1e-9 * load));
    const Vec2 left = reactions.at("left").head<2>();
    CHECK_THAT((left - setting.turned(-stress(0, 0) * side, 0.0)).norm(), WithinAbs(0.0, 1e-9 * load));
  }
}

TEST_CASE("simple shear between a fixed and a displaced side is exact on every basis and line",
          "[verification][grid_method]") {
  constexpr double gamma = 1e-3;
  for (const test::Setting& setting : settings()) {
    CAPTURE(setting.name);
    Case problem = test::body_on_lines(setting);
    const Vec2 slide = setting.turned(gamma * side, 0.0);
    const double shear = tangent()(2, 2) * gamma;
    problem.boundaries[0].condition = fixed;
    problem.boundaries[1].condition = pull(setting, 0.0, shear);
    problem.boundaries[2].condition = Case::Displacement{std::array{Quantity(slide.x()), Quantity(slide.y())}, fixed};
    problem.boundaries[3].condition = pull(setting, 0.0, -shear);
    const Mat2 stress = (Mat2() << 0.0, shear, shear, 0.0).finished();
    const Result result = solve(problem, turned(
                                             setting.angle, [&](const Vec2& x) { return Vec2(gamma * x.y(), 0.0); },
                                             [&](const Vec2&) { return stress; }));
    CHECK(result.displacement <= 1e-10);
    CHECK(result.stress <= 1e-10);
    const Vec2 top = result.record.resultants.reactions.at("top").head<2>();
    CHECK_THAT((top - setting.turned(shear * side, 0.0)).norm(), WithinAbs(0.0, 1e-8 * shear));
  }
}

TEST_CASE("smooth bases hold a column under its weight without holding the slope at its foot",
          "[verification][grid_method]") {
  for (const test::Setting& setting : settings()) {
    if (!smooth(setting)) continue;
    CAPTURE(setting.name);
    Case problem = test::body_on_lines(setting);
    for (const std::size_t k : {0u, 1u, 3u}) problem.boundaries[k].condition = roller;
    const Vec2 weight = setting.turned(0.0, -load);
    problem.body_force = {Quantity(weight.x()), Quantity(weight.y())};
    const double modulus = tangent()(1, 1);
    const double ratio = tangent()(0, 1) / modulus;
    const auto displacement = [&](const Vec2& x) {
      return Vec2(0.0, -load / modulus * (side * x.y() - 0.5 * x.y() * x.y()));
    };
    const auto stress = [&](const Vec2& x) -> Mat2 { return -load * (side - x.y()) * Vec2(ratio, 1.0).asDiagonal(); };
    const Result result = solve(problem, turned(setting.angle, displacement, stress));
    CHECK(result.displacement <= 1e-10);
    CHECK(result.stress <= 1e-10);
    const Vec2 right = result.record.resultants.reactions.at("right").head<2>();
    const double thrust = 0.5 * ratio * load * side * side;
    CHECK_THAT((right - setting.turned(-thrust, 0.0)).norm(), WithinAbs(0.0, 1e-9 * load));
  }
}

TEST_CASE("smooth bases reproduce a quadratic displacement that is prescribed all around",
          "[verification][grid_method]") {
  constexpr double a = 1e-4;
  for (const test::Setting& setting : settings()) {
    if (!smooth(setting)) continue;
    CAPTURE(setting.name);
    Case problem = test::body_on_lines(setting);
    const auto value = in_own_axes(setting, "1e-4*(X^2+X*Y+2)", "1e-4*(Y^2-2*X*Y+X)");
    for (Case::Boundary& b : problem.boundaries)
      b.condition = Case::Displacement{std::array{Quantity(value[0]), Quantity(value[1])}, fixed};
    const Mat3 c = tangent();
    const auto displacement = [&](const Vec2& x) -> Vec2 {
      return a * Vec2(x.x() * x.x() + x.x() * x.y() + 2.0, x.y() * x.y() - 2.0 * x.x() * x.y() + x.x());
    };
    const auto stress = [&](const Vec2& x) -> Mat2 {
      const Vec3 strain = a * Vec3(2.0 * x.x() + x.y(), 2.0 * x.y() - 2.0 * x.x(), x.x() - 2.0 * x.y() + 1.0);
      const Vec3 s = c * strain;
      return (Mat2() << s[0], s[2], s[2], s[1]).finished();
    };
    // −div σ
    const Vec2 force = -a * Vec2(2.0 * c(0, 0) - 2.0 * c(0, 1) - 2.0 * c(2, 2), c(0, 1) + 2.0 * c(1, 1) + c(2, 2));
    const Vec2 body = setting.turned(force.x(), force.y());
    problem.body_force = {Quantity(body.x()), Quantity(body.y())};
    const Result result = solve(problem, turned(setting.angle, displacement, stress));
    CHECK(result.displacement <= 1e-9);
    CHECK(result.stress <= 1e-8);
  }
}

TEST_CASE("reactions on grid lines balance any load on every basis", "[verification][grid_method]") {
  for (const test::Setting& setting : settings())
    for (const auto& [bottom, right] : {std::pair(fixed, roller), std::pair(roller, fixed), std::pair(fixed, fixed)})
      for (const Loading loading : {Loading::residual, Loading::incremental}) {
        CAPTURE(setting.name, bottom.normal_only, right.normal_only, loading);
        Case problem = test::body_on_lines(setting);
        problem.analysis = QuasiStatic{.loading = loading, .load_steps = 2};
        problem.boundaries[0].condition = bottom;
        problem.boundaries[1].condition = right;
        problem.boundaries[2].condition = pull(setting, 0.3, 0.5);
        problem.body_force = {Quantity(0.2), Quantity(Expression("-0.7*x*t"))};
        Scene scene = build_scene(problem);
        RunRecord record;
        run_load_steps(scene, {}, record);
        const double size = record.resultants.loads.at("body_force").norm();
        CHECK(test::imbalance(record.resultants).norm() <= 1e-10 * size);
        CHECK(record.resultants.reactions.at("bottom").norm() > 0.1 * size);
      }
}

TEST_CASE("a field that vanishes on both lines of a re-entrant corner is met by Powell-Sabin splines",
          "[verification][grid_method]") {
  // u = a (x − 1)(y − 1) e_x on an L whose inner corner is (1, 1)
  constexpr double a = 1e-4;
  const std::vector<Vec2> corner{{-1, -1}, {3, -1}, {3, 1}, {1, 1}, {1, 3}, {-1, 3}};
  const Mat3 c = tangent();
  const ExactSolution exact{
      .displacement = [&](const Vec2& x, double) -> Vec2 {
        return {a * (x.x() - 1.0) * (x.y() - 1.0), 0.0};
      },
      .stress = [&](const Vec2& x, double) -> Vec3 { return c * (a * Vec3(x.y() - 1.0, 0.0, x.x() - 1.0)); }};
  for (const bool border : {true, false}) {
    CAPTURE(border);
    const TriangleMesh square =
        triangulate(QuadrilateralGrid(Vec2(-1, -1), Vec2::Ones(), {4, 4}), TrianglePattern::diagonal);
    const auto outside = [&](Index t) {
      const auto [p, q, r] = corners(square, t);
      return ((p + q + r) / 3.0).minCoeff() > 1.0;
    };
    test::Setting setting{"", {.basis = Case::BasisType::powell_sabin}};
    setting.grid.mesh = std::make_shared<const TriangleMesh>(border ? test::without(square, outside) : square);
    Case problem = test::body_on_lines(setting);
    problem.boundaries.clear();
    for (std::size_t k = 0; k < corner.size(); ++k) {
      const bool inner = k == 2 || k == 3;
      problem.boundaries.push_back(
          {{.name = "side " + std::to_string(k), .points = {corner[k], corner[(k + 1) % 6]}},
           inner ? Case::Condition(fixed) : Case::Condition(Case::Traction{Case::FromExact{}})});
    }
    const auto formula = [&](const char* text) {
      return Expression(text, {{"a", a}, {"p", c(0, 0)}, {"q", c(0, 1)}, {"g", c(2, 2)}});
    };
    problem.exact = Case::ExactExpressions{{formula("a*(X-1)*(Y-1)"), formula("0")},
                                           {formula("p*a*(Y-1)"), formula("q*a*(Y-1)"), formula("g*a*(X-1)")}};
    const auto basis = make_basis(setting.grid);
    auto points = test::exact_points(basis->grid(), {{-1, -1}, {3, -1}, {3, 1}, {-1, 1}}, 3);
    const auto upper = test::exact_points(basis->grid(), {{-1, 1}, {1, 1}, {1, 3}, {-1, 3}}, 3);
    points.insert(points.end(), upper.begin(), upper.end());
    problem.material_points = std::move(points);
    problem.body_force = {Quantity(0.0), Quantity(-a * (c(0, 1) + c(2, 2)))};
    const Result result = solve(problem, exact);
    CHECK(result.displacement <= 1e-10);
    CHECK(result.stress <= 1e-10);
    CHECK(test::imbalance(result.record.resultants).norm() <= 1e-10);
  }
}
