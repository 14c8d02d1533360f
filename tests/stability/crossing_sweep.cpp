#include <cmath>

#include "bodies.hpp"
#include "shoreline/engine/dynamics.hpp"
#include "sweeps.hpp"

namespace shoreline::test {
namespace {

constexpr double h = 0.125;
constexpr int cells = 4;                             ///< in the side of the body
constexpr int across = 4;                            ///< points in the side of a cell
constexpr Index traveller = 4 * cells * across + 6;  ///< number of the point that crosses

/// A block in bending off the grid lines, with a lattice of points, one of which is near a line between columns.
/// @param beyond  how far right of the line it is [m]
Case block(const Discretisation& on, double beyond) {
  constexpr double side = cells * h;
  Case problem = discretised(bending(sides(rectangle(side, side, 0.0)), h), on);
  problem.grid.lower = Vec2(-0.5 * side - 1.3 * h, -0.5 * side - 1.4 * h);
  std::vector<Case::ListedPoint> points;
  constexpr double spacing = h / across;
  for (int j = 0; j < cells * across; ++j)
    for (int i = 0; i < cells * across; ++i)
      points.push_back({Vec2(-0.5 * side + (i + 0.5) * spacing, -0.5 * side + (j + 0.5) * spacing), spacing * spacing});
  double& x = points[traveller].position.x();
  x = problem.grid.lower.x() + h * std::round((x - problem.grid.lower.x()) / h) + beyond;
  problem.material_points = points;
  return problem;
}

/// Stress of the traveller, the largest stress and the strain energy of a body.
struct State {
  Vec3 stress;
  double largest;
  double energy;
};

/// The traveller is where none else is: nearest to its place at the start.
Index find(const MaterialPoints& points, const Vec2& start) {
  Index nearest = 0;
  ((points.position - points.displacement).colwise() - start).colwise().squaredNorm().minCoeff(&nearest);
  return nearest;
}

Vec2 start_of(const Case& problem) {
  return std::get<std::vector<Case::ListedPoint>>(problem.material_points)[traveller].position;
}

State load_step(const Discretisation& on, double beyond) {
  const Case problem = block(on, beyond);
  Scene scene = build_scene(problem);
  RunRecord record;
  run_load_steps(scene, {}, record);
  State state{scene.points.stress.col(find(scene.points, start_of(problem))).head<3>(), 0.0, 0.0};
  for (Index p = 0; p < scene.points.size(); ++p) {
    const Vec3 stress = scene.points.stress.col(p).head<3>();
    state.largest = std::max(state.largest, stress.norm());
    state.energy += 0.5 * stress.dot(scene.points.strain.col(p)) * scene.points.volume[p];
  }
  return state;
}

State time_step(const Discretisation& on, double beyond) {
  constexpr double dt = 1e-5;
  Case problem = block(on, beyond);
  problem.boundaries.clear();
  problem.exact.reset();
  problem.ghost = 0.0;
  problem.analysis = ExplicitDynamics{.time_step = dt, .end_time = dt};
  problem.material.law = Case::Law::neo_hookean;
  problem.material.density = 1e3;
  problem.initial_velocity = {Expression("sin(5*X + 3*Y)"), Expression("cos(4*X - 2*Y)")};
  DynamicScene scene = build_dynamic_scene(problem);
  DynamicRecord record;
  run_time_steps(scene, {}, record);
  const MaterialPoints& points = scene.body.points;
  return {points.stress.col(find(points, start_of(problem))).head<3>(),
          points.stress.topRows<3>().colwise().norm().maxCoeff(), energies(scene, dt).strain};
}

double jump(double before, double after) { return std::abs(after - before) / std::abs(before); }
double stress_jump(const State& before, const State& after) {
  return (after.stress - before.stress).norm() / before.largest;
}

}  // namespace

std::vector<CrossingRow> crossing_sweep() {
  constexpr double beyond = 1e-9 * h;
  std::vector<CrossingRow> rows;
  for (const Discretisation& on : every_basis(EssentialMethod::nitsche)) {
    const State left = load_step(on, -beyond);
    const State right = load_step(on, beyond);
    const State slow = time_step(on, -beyond);
    const State fast = time_step(on, beyond);
    rows.push_back({basis_name(on), stress_jump(left, right), jump(left.energy, right.energy), stress_jump(slow, fast),
                    jump(slow.energy, fast.energy)});
  }
  return rows;
}

}  // namespace shoreline::test
