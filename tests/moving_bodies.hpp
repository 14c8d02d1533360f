#pragma once
// Small bodies in motion that tests of explicit dynamics compute with.

#include "every_grid.hpp"
#include "scenes.hpp"
#include "shoreline/engine/dynamics.hpp"

namespace shoreline::test {

inline constexpr std::array every_mass{MassForm::consistent, MassForm::lumped, MassForm::partly_lumped};

inline ExplicitDynamics& settings_of(Case& problem) { return std::get<ExplicitDynamics>(problem.analysis); }

inline std::array<Expression, 2> formulas(const char* x, const char* y) { return {Expression(x), Expression(y)}; }

/// A free rectangle of evenly listed points, of E = 1 Pa and density 1 kg/m³, until t = 1 s.
/// @param across  points in each of its sides
inline Case free_block(const Case::Grid& grid, const Vec2& lower, const Vec2& upper, int across) {
  const Vec2 size = (upper - lower) / across;
  std::vector<Case::ListedPoint> points;
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < across; ++i) points.push_back({lower + size.cwiseProduct(Vec2(i + 0.5, j + 0.5)), size.prod()});
  Case problem;
  problem.file = "block.json";
  problem.analysis = ExplicitDynamics{.end_time = 1.0};
  problem.material = {.law = Case::Law::neo_hookean, .youngs_modulus = 1.0, .poissons_ratio = 0.25, .density = 1.0};
  problem.grid = grid;
  problem.material_points = points;
  return problem;
}

/// A square grid of bilinear cells of size 1 from the origin.
inline Case::Grid unit_cells(double side) {
  return {.lower = Vec2::Zero(), .upper = Vec2::Constant(side), .cell_size = Vec2::Ones()};
}

/// A rectangle with sides "base", "right", "top" and "left", otherwise as free_block.
struct Standing {
  Vec2 lower = Vec2(2, 2);
  Vec2 upper = Vec2(4, 4);
  Case::Condition base = Essential{.method = EssentialMethod::grid};
  Case::Condition sides = Case::Free{};
  Case::Condition top = Case::Free{};
};

inline Case standing_block(const Case::Grid& grid, const Standing& body) {
  const Vec2& a = body.lower;
  const Vec2& c = body.upper;
  const Vec2 b(c.x(), a.y()), d(a.x(), c.y());
  Case problem = free_block(grid, a, c, 1);
  problem.boundaries = {{{.name = "base", .points = {a, b}}, body.base},
                        {{.name = "right", .points = {b, c}}, body.sides},
                        {{.name = "top", .points = {c, d}}, body.top},
                        {{.name = "left", .points = {d, a}}, body.sides}};
  problem.material_points = LatticeFill{{3, 3}, VolumeRule::clipped};
  return problem;
}

inline const Essential grid_roller{.normal_only = true, .method = EssentialMethod::grid};

/// Runs a scene with all resultants of every step.
/// @param after_step  called with the record and the time
template <class AfterStep>
DynamicRecord run_steps(DynamicScene& scene, AfterStep&& after_step) {
  DynamicRecord record;
  run_time_steps(scene,
                 {.wanted = [](int, double) { return true; },
                  .after_step = [&](int, double t) { after_step(std::as_const(record), t); }},
                 record);
  return record;
}

inline DynamicRecord run_steps(DynamicScene& scene) {
  return run_steps(scene, [](const DynamicRecord&, double) {});
}

/// The largest difference between the rate of momentum and the sum of loads and reactions, over all steps, in parts of
/// the largest load or reaction.
inline double worst_imbalance(DynamicScene& scene) {
  Vec2 momentum = energies(scene, 0.0).momentum;
  double before = 0.0, worst = 0.0, largest = 0.0;
  run_steps(scene, [&](const DynamicRecord& record, double t) {
    const Vec2 now = energies(scene, t).momentum;
    const Vec2 rate = (now - momentum) / (t - before);
    worst = std::max(worst, (rate - imbalance(record.resultants).head<2>()).norm());
    for (const auto& sums : {record.resultants.loads, record.resultants.reactions})
      for (const auto& [name, force] : sums) largest = std::max(largest, force.head<2>().norm());
    momentum = now;
    before = t;
  });
  return worst / largest;
}

}  // namespace shoreline::test
