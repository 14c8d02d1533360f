// Every basis under every condition, by every method, in both planes: a body whose displacement is linear.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "../every_grid.hpp"
#include "shoreline/engine/defaults.hpp"
#include "shoreline/engine/linear_elastic.hpp"
#include "shoreline/engine/quasi_static.hpp"

using namespace shoreline;
using test::every_grid;
using test::NamedGrid;

namespace {

enum class Kind { traction, pressure, fixed, roller, displacement, normal_displacement };
constexpr Kind kinds[] = {Kind::traction, Kind::pressure,     Kind::fixed,
                          Kind::roller,   Kind::displacement, Kind::normal_displacement};
constexpr double band = 1e-4;  ///< of the implicit boundary
constexpr int bottom = 0, right = 1, top = 2, left = 3;

/// A square with the displacement u = gradient · (x − corner) in its own axes, and how it comes about.
class Body {
 public:
  Body(double angle, const Vec2& corner, double side, Plane plane, Kind kind)
      : turn_(Eigen::Rotation2Dd(angle).toRotationMatrix()), corner_(corner), side_(side), kind_(kind) {
    const Mat3 tangent = LinearElastic(youngs_modulus, poissons_ratio, plane).tangent(Stress::Zero());
    switch (kind) {
      case Kind::pressure:  // the same pressure all around
        gradient_ = -pressure / (tangent(0, 0) + tangent(0, 1)) * Mat2::Identity();
        break;
      case Kind::fixed:  // nothing moves below
        gradient_ << 0.0, 2e-5, 0.0, -1e-5;
        break;
      case Kind::roller:  // nothing moves across three sides
        gradient_ << 0.0, 0.0, 0.0, -1e-5;
        break;
      case Kind::displacement:
        gradient_ << 1e-5, -2e-5, 5e-6, -1.5e-5;
        break;
      case Kind::traction:
      case Kind::normal_displacement:
        gradient_ << 2e-5, 0.0, 0.0, -1e-5;
    }
    const Vec3 s = tangent * Vec3(gradient_(0, 0), gradient_(1, 1), gradient_(0, 1) + gradient_(1, 0));
    stress_ << s[0], s[2], s[2], s[1];
  }

  [[nodiscard]] std::vector<Vec2> corners() const { return {corner_, at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)}; }

  /// @param support  how supports hold
  [[nodiscard]] Case problem(const NamedGrid& named, Plane plane, const Essential& support) const {
    Case problem;
    problem.file = "square.json";
    problem.plane = plane;
    problem.material = {.youngs_modulus = youngs_modulus, .poissons_ratio = poissons_ratio, .density = {}};
    problem.grid = named.grid;
    problem.ghost = ghost_for_nitsche(named.grid.basis, named.grid.degree);
    const auto corner = corners();
    for (const int k : {bottom, right, top, left})
      problem.boundaries.push_back(
          {{.name = std::string(1, "brtl"[k]),
            .points = {corner[static_cast<std::size_t>(k)], corner[static_cast<std::size_t>((k + 1) % 4)]}},
           condition(k, support)});
    problem.material_points = test::patch_points(named.grid, corner);
    return problem;
  }

  [[nodiscard]] ExactSolution exact() const {
    const Mat2 gradient = turn_ * gradient_ * turn_.transpose();
    const Mat2 stress = turn_ * stress_ * turn_.transpose();
    return {
        .displacement = [=, corner = corner_](const Vec2& x, double t) -> Vec2 { return t * gradient * (x - corner); },
        .stress = [=](const Vec2&, double t) -> Vec3 { return t * Vec3(stress(0, 0), stress(1, 1), stress(0, 1)); }};
  }

 private:
  static constexpr double youngs_modulus = 2e6;
  static constexpr double poissons_ratio = 0.3;
  static constexpr double pressure = 30.0;

  [[nodiscard]] Vec2 at(double x, double y) const { return corner_ + side_ * (turn_ * Vec2(x, y)); }

  /// Bottom and left are supports; what the right and the top do is the kind's.
  [[nodiscard]] Case::Condition condition(int k, Essential support) const {
    support.normal_only = kind_ != Kind::fixed && kind_ != Kind::displacement;
    if (kind_ == Kind::displacement) return prescribed(support);
    if (k == bottom || (k == left && kind_ != Kind::fixed)) return support;
    if (k == right && kind_ == Kind::roller) return support;
    if (k == top && kind_ == Kind::normal_displacement)
      return Case::Displacement{Quantity(-side_ * gradient_(1, 1)), support};
    if (kind_ == Kind::pressure) return Case::Pressure{Quantity(pressure)};
    const Vec2 outward = k == right ? Vec2::UnitX() : k == top ? Vec2::UnitY() : Vec2(-Vec2::UnitX());
    const Vec2 traction = turn_ * stress_ * outward;
    return Case::Traction{std::array{Quantity(traction.x()), Quantity(traction.y())}};
  }

  [[nodiscard]] Case::Condition prescribed(const Essential& support) const {
    const Mat2 gradient = turn_ * gradient_ * turn_.transpose();
    const auto component = [&](int row) {
      return Quantity(
          Expression("t*(gx*(X - x0) + gy*(Y - y0))",
                     {{"gx", gradient(row, 0)}, {"gy", gradient(row, 1)}, {"x0", corner_.x()}, {"y0", corner_.y()}}));
    };
    return Case::Displacement{std::array{component(0), component(1)}, support};
  }

  Mat2 turn_;
  Vec2 corner_;
  double side_;
  Kind kind_;
  Mat2 gradient_;
  Mat2 stress_;
};

void check_all_kinds(const std::vector<NamedGrid>& grids, double angle, const Vec2& corner, double side,
                     EssentialMethod method) {
  for (const NamedGrid& named : grids)
    for (const Kind kind : kinds)
      for (const Plane plane : {Plane::strain, Plane::stress}) {
        CAPTURE(named.name, kind, plane, method);
        const Body body(angle, corner, side, plane, kind);
        const double width = method == EssentialMethod::nitsche ? nitsche_band(named.grid.basis) : band;
        Scene scene = build_scene(body.problem(named, plane, {.method = method, .band = width}));
        RunRecord record;
        run_load_steps(scene, {}, record);
        const ErrorNorms norms = error_norms(scene.points, body.exact(), 1.0);
        const bool fitted = kind == Kind::displacement || kind == Kind::normal_displacement;
        const double bound = method == EssentialMethod::implicit_boundary ? band : fitted ? 2e-8 : 1e-9;
        CHECK(norms.displacement_l2_relative.value() <= bound);
        CHECK(norms.stress_l2_relative.value() <= bound);
        CHECK(record.warnings.empty());
      }
}

}  // namespace

TEST_CASE("every condition on every basis: Nitsche's method anywhere in the grid", "[verification][every_basis]") {
  check_all_kinds(every_grid({-1.0, -1.0}, 2.0, 9), 0.4, {-0.43, -0.61}, 0.9, EssentialMethod::nitsche);
}

TEST_CASE("every condition on every basis: the implicit boundary anywhere in the grid", "[verification][every_basis]") {
  check_all_kinds(every_grid({-1.0, -1.0}, 2.0, 9), 0.4, {-0.43, -0.61}, 0.9, EssentialMethod::implicit_boundary);
}

TEST_CASE("every condition on every basis: elimination on the border of the grid", "[verification][every_basis]") {
  check_all_kinds(every_grid({0.0, 0.0}, 1.0, 5), 0.0, {0.0, 0.0}, 1.0, EssentialMethod::grid);
}

TEST_CASE("every condition on every basis: elimination on lines inside the grid", "[verification][every_basis]") {
  std::vector<NamedGrid> grids = every_grid({-1.0, -1.0}, 2.0, 10);
  std::erase_if(grids, [](const NamedGrid& named) { return named.grid.mesh != nullptr; });  // without straight lines
  check_all_kinds(grids, 0.0, {-0.4, -0.6}, 0.8, EssentialMethod::grid);
}
