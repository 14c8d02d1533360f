#pragma once
// Small bodies that many tests compute with.

#include <Eigen/Geometry>
#include <numbers>

#include "shoreline/engine/linear_elastic.hpp"
#include "shoreline/engine/quasi_static.hpp"

namespace shoreline::test {

/// A square that stands on a roller between rollers, under a pressure on its top (Bing et al. 2019, §4.1), anywhere in
/// its grid; with angle and shift zero its sides lie on grid lines.
struct CompressionSquare {
  double angle = 0.0;         ///< [rad]
  Vec2 shift = Vec2::Zero();  ///< of the centre [m]
  double side = 0.1;          ///< [m]
  int cells = 10;             ///< in the side
  int per_cell = 1;           ///< material points in the side of a cell
  double band = 1e-3;
  EssentialMethod method = EssentialMethod::implicit_boundary;
  double ghost = 0.0;
  double load = 8e3;       ///< on the top, downward [Pa]
  bool held_load = false;  ///< the whole load in every step, instead of a ramp
  int steps = 1;
  Loading loading = Loading::residual;
  Plane plane = Plane::strain;
  double youngs_modulus = 1e6;  ///< [Pa]
  double poissons_ratio = 0.25;
};

inline Case compression_case(const CompressionSquare& o) {
  const Eigen::Rotation2Dd turn(o.angle);
  const auto corner = [&](double x, double y) -> Vec2 { return o.shift + turn * (o.side * Vec2(x - 0.5, y - 0.5)); };
  const Essential roller{.normal_only = true, .method = o.method, .band = o.band};
  const Vec2 traction = turn * Vec2(0.0, -o.load);
  const auto quantity = [&](double value) -> Quantity {
    return o.held_load ? Quantity(Expression("value", {{"value", value}})) : Quantity(value);
  };
  const auto side = [](const char* name, const Vec2& from, const Vec2& to, Case::Condition condition) {
    return Case::Boundary{{.name = name, .points = {from, to}}, std::move(condition)};
  };
  const double h = o.side / o.cells;
  const double reach = 0.5 * o.side + h * (o.cells / 4 + 2);  // NOLINT(bugprone-integer-division): whole cells
  Case problem;
  problem.file = "square.json";
  problem.plane = o.plane;
  problem.analysis = QuasiStatic{.loading = o.loading, .load_steps = o.steps};
  problem.material = {.youngs_modulus = o.youngs_modulus, .poissons_ratio = o.poissons_ratio, .density = {}};
  problem.grid = {.lower = Vec2::Constant(-reach), .upper = Vec2::Constant(reach), .cell_size = Vec2(h, h)};
  problem.boundaries = {side("bottom", corner(0, 0), corner(1, 0), roller),
                        side("right", corner(1, 0), corner(1, 1), roller),
                        side("top", corner(1, 1), corner(0, 1),
                             Case::Traction{std::array{quantity(traction.x()), quantity(traction.y())}}),
                        side("left", corner(0, 1), corner(0, 0), roller)};
  problem.material_points = LatticeFill{{o.per_cell, o.per_cell}, VolumeRule::clipped};
  problem.ghost = o.ghost;
  return problem;
}

/// The scene of the square, with its exact solution.
inline Scene compression_square(const CompressionSquare& o) {
  Scene scene = build_scene(compression_case(o));
  const Mat3 tangent = scene.material->tangent(Stress::Zero());
  const double strain = -o.load / tangent(1, 1);
  const Mat2 turn = Eigen::Rotation2Dd(o.angle).toRotationMatrix();
  const Mat2 stress = turn * Vec2(tangent(0, 1) * strain, -o.load).asDiagonal() * turn.transpose();
  const Vec2 up = turn.col(1);
  const Vec2 held = o.shift - 0.5 * o.side * up;
  scene.exact = ExactSolution{
      .displacement = [=](const Vec2& x, double t) -> Vec2 { return t * strain * up.dot(x - held) * up; },
      .stress = [=](const Vec2&, double t) -> Vec3 { return t * Vec3(stress(0, 0), stress(1, 1), stress(0, 1)); }};
  return scene;
}

/// A square turned and off the grid lines.
inline Scene turned_square(double side = 0.1) {
  return compression_square({.angle = 0.6, .shift = Vec2(0.03, -0.02) * side, .side = side, .cells = 7});
}

/// A disc of given outline conditions in a grid of cells [h], off the grid's symmetry.
inline Case disc_case(double radius, double h, Case::Condition condition) {
  Case problem;
  problem.file = "disc.json";
  problem.material = {.youngs_modulus = 1e6, .poissons_ratio = 0.25, .density = {}};
  problem.grid = {
      .lower = Vec2::Constant(-1.3 * radius - h), .upper = Vec2::Constant(1.3 * radius + h), .cell_size = Vec2(h, h)};
  problem.boundaries = {{{.name = "rim", .points = {}, .closed = true}, std::move(condition)}};
  for (int k = 0; k < 16; ++k)
    problem.boundaries[0].piece.points.emplace_back(
        radius * (Eigen::Rotation2Dd(k * std::numbers::pi / 8.0) * Vec2::UnitX()) + Vec2(0.11, 0.07) * h);
  problem.material_points = LatticeFill{{2, 2}, VolumeRule::clipped};
  return problem;
}

/// A disc of radius 1 on which nothing acts.
inline Scene disc() { return build_scene(disc_case(1.0, 0.21, Case::Free{})); }

/// What the contributions of a scene see at one load step.
struct Step {
  PointSupports supports;
  std::vector<Edge> edges;
  Eigen::Matrix2Xd prescribed{2, 0};
  StepState state;

  explicit Step(const Scene& scene, double t = 1.0, double t_before = 0.0)
      : supports(locate_points(*scene.basis, scene.points)),
        edges(make_edges(scene, supports.active)),
        state{*scene.basis, scene.points, supports, edges, scene.loading, t, t_before, prescribed} {}
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

 private:
  static std::vector<Edge> make_edges(const Scene& scene, const std::vector<char>& active) {
    std::vector<Edge> made;
    for (const BoundaryPiece& b : scene.boundary)
      made.push_back(make_edge(b.piece, scene.basis->grid(), active, gauss(4)));
    return made;
  }
};

/// What one effect adds at a load step.
inline ElementBlocks blocks_of(const Contribution& effect, const StepState& state) {
  ElementBlocks blocks;
  effect.add(state, blocks);
  return blocks;
}

/// Displacements u = gradient · x of all control points.
inline Eigen::Matrix2Xd linear_field(const Basis& basis, const Mat2& gradient) {
  Eigen::Matrix2Xd field(2, basis.functions());
  for (Index f = 0; f < basis.functions(); ++f) field.col(f) = gradient * basis.control_point(f);
  return field;
}

/// Resultant and moment of nodal forces at the control points.
inline Vec3 total(const Basis& basis, const Eigen::Matrix2Xd& force) {
  Vec3 sum = Vec3::Zero();
  for (Index f = 0; f < basis.functions(); ++f) sum += resultant(basis.control_point(f), force.col(f));
  return sum;
}

/// Sum of loads and reactions: zero in equilibrium.
inline Vec3 imbalance(const Resultants& resultants) {
  Vec3 sum = Vec3::Zero();
  for (const auto& [name, load] : resultants.loads) sum += load;
  for (const auto& [name, reaction] : resultants.reactions) sum += reaction;
  return sum;
}

}  // namespace shoreline::test
