#pragma once
// The column of examples/soil_column, one block wide, on any number of blocks along its height.

#include <fmt/format.h>

#include "motion.hpp"

namespace shoreline::test {

/// Case of the column of 1 m on blocks of 0.8 : 1, 1/rows high, with an empty one above its top; partly lumped and pic.
inline Case column_case(int rows, const std::vector<std::string>& overrides) {
  const double width = 0.8 / rows;
  std::vector<std::string> keys{fmt::format("grid.cell_size=[{}, {}]", width, 1.0 / rows),
                                fmt::format("grid.upper=[{}, {}]", width, 1.0 + 1.0 / rows),
                                fmt::format("boundaries.0.points=[[0, 0], [{}, 0]]", width),
                                fmt::format("boundaries.1.points=[[{0}, 0], [{0}, 1]]", width),
                                fmt::format("boundaries.2.points=[[{}, 1], [0, 1]]", width),
                                fmt::format("probes.0.position=[{}, 0.5]", 0.5 * width),
                                fmt::format("analysis.time_step={}", 4e-3 / rows),
                                "analysis.mass=partly_lumped",
                                "analysis.transfer=pic",
                                "analysis.end_time=1"};
  keys.insert(keys.end(), overrides.begin(), overrides.end());
  return read_case(std::string(SHORELINE_EXAMPLES) + "/soil_column/large.json", keys);
}

inline constexpr double column_weight = 9810.0;              ///< σ₀ = ρ g H [Pa]
inline constexpr double column_kappa = column_weight / 2e5;  ///< κ = ρ g H/(2 E)

/// Brings a column at rest to the equilibrium of its own weight, y/H = ξ(1 − 2κ) + κ ξ², σ = −ρ g (H − X), with its
/// tracking points.
inline void squeeze(DynamicScene& scene) {
  const auto height = [](double x) { return x * (1.0 - 2.0 * column_kappa) + column_kappa * x * x; };
  MaterialPoints& points = scene.body.points;
  for (Index p = 0; p < points.size(); ++p) {
    const double x = points.position(1, p);
    const double stretch = 1.0 - 2.0 * column_kappa * (1.0 - x);
    points.position(1, p) = height(x);
    points.displacement(1, p) = height(x) - x;
    points.volume[p] = stretch * scene.motion.volume[p];
    points.stress(1, p) = -column_weight * (1.0 - x);
    scene.motion.deformation(3, p) = stretch;
  }
  for (BoundaryPiece& b : scene.body.boundary)
    for (Vec2& x : b.piece.points) x.y() = height(x.y());
}

}  // namespace shoreline::test
