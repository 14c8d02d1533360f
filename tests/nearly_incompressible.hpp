#pragma once
// A smooth displacement of the unit square that tends to one without change of volume as ν tends to ½.

#include <fmt/format.h>

#include "every_grid.hpp"
#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/defaults.hpp"
#include "shoreline/engine/quasi_static.hpp"

namespace shoreline::test {

/// Lamé's parameters of E = 1 Pa in plane strain.
inline std::array<double, 2> lame(double poissons_ratio) {
  return {poissons_ratio / ((1.0 + poissons_ratio) * (1.0 - 2.0 * poissons_ratio)), 0.5 / (1.0 + poissons_ratio)};
}

/// u = curl ψ + ∇χ/λ, so λ div u = Δχ and the pressure stay what they are as ν tends to ½; σ = 2μ ε + Δχ I. Held with
/// its exact displacement on three sides, under its exact traction on the right one.
inline std::string manufactured_text(double poissons_ratio) {
  const auto [lambda, mu] = lame(poissons_ratio);
  return fmt::format(R"J({{
  "analysis": {{"type": "quasi_static", "plane": "strain"}},
  "material": {{"type": "linear_elastic", "youngs_modulus": 1, "poissons_ratio": {}}},
  "grid": {{"lower": [0, 0], "upper": [1, 1], "cell_size": 0.25}},
  "boundaries": [
    {{"name": "bottom", "line": {{"from": [0, 0], "to": [1, 0]}}, "condition": {{"type": "displacement", "value": "exact"}}}},
    {{"name": "right", "line": {{"from": [1, 0], "to": [1, 1]}}, "condition": {{"type": "traction", "value": "exact"}}}},
    {{"name": "top", "line": {{"from": [1, 1], "to": [0, 1]}}, "condition": {{"type": "displacement", "value": "exact"}}}},
    {{"name": "left", "line": {{"from": [0, 1], "to": [0, 0]}}, "condition": {{"type": "displacement", "value": "exact"}}}}
  ],
  "material_points": {{"per_cell": 2}},
  "constants": {{"b": 1e-6, "c": 2e-7, "la": {:.17g}, "mu": {:.17g}}},
  "body_force": [
    "10*pi^2*mu*b*sin(pi*X)*cos(2*pi*Y) + (1 + 2*mu/la)*2*c*pi^3*cos(pi*X)*cos(pi*Y)",
    "-5*pi^2*mu*b*cos(pi*X)*sin(2*pi*Y) - (1 + 2*mu/la)*2*c*pi^3*sin(pi*X)*sin(pi*Y)"
  ],
  "exact": {{
    "type": "expressions",
    "displacement": [
      "2*b*sin(pi*X)*cos(2*pi*Y) + c/la*pi*cos(pi*X)*cos(pi*Y)",
      "-b*cos(pi*X)*sin(2*pi*Y) - c/la*pi*sin(pi*X)*sin(pi*Y)"
    ],
    "stress": [
      "2*mu*(2*b*pi*cos(pi*X)*cos(2*pi*Y) - c/la*pi^2*sin(pi*X)*cos(pi*Y)) - 2*c*pi^2*sin(pi*X)*cos(pi*Y)",
      "2*mu*(-2*b*pi*cos(pi*X)*cos(2*pi*Y) - c/la*pi^2*sin(pi*X)*cos(pi*Y)) - 2*c*pi^2*sin(pi*X)*cos(pi*Y)",
      "mu*(-3*b*pi*sin(pi*X)*sin(2*pi*Y) - 2*c/la*pi^2*cos(pi*X)*sin(pi*Y))"
    ]
  }}
}})J",
                     poissons_ratio, lambda, mu);
}

/// How a body is held.
struct Held {
  EssentialMethod method;
  double band;  ///< 0: that of the basis for Nitsche's method
};

/// A case of the square with other pieces held in this way, on another grid, with points that integrate exactly.
inline Case on_grid(Case problem, const Case::Grid& grid, const Held& held, bool projected) {
  problem.grid = grid;
  problem.ghost = held.method == EssentialMethod::grid ? 0.0 : ghost_for_nitsche(grid.basis, grid.degree);
  problem.material.projected_dilatation = projected;
  for (Case::Boundary& side : problem.boundaries)
    if (auto* moved = std::get_if<Case::Displacement>(&side.condition)) {
      moved->support.method = held.method;
      moved->support.band = held.band > 0.0 ? held.band : nitsche_band(grid.basis);
      moved->support.narrows = held.band == 0.0;
    }
  problem.material_points = exact_points(basis_of(grid)->grid(), {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 4);
  return problem;
}

/// Every grid under the unit square: on its sides for method grid, else off them by fractions of a cell.
inline std::vector<NamedGrid> grids_under_square(EssentialMethod method, Index cells) {
  if (method == EssentialMethod::grid) return every_grid(Vec2::Zero(), 1.0, cells);
  const double h = 1.0 / static_cast<double>(cells);
  return every_grid(Vec2(-0.3 * h, -0.24 * h), 1.0 + 2.0 * h, cells + 2);
}

/// L2 error of the pressure −tr σ/3 over the points of a computed scene, σ_zz = ν (σ_xx + σ_yy) [Pa m].
inline double pressure_error(const Scene& scene, double poissons_ratio) {
  double squared = 0.0;
  for (Index p = 0; p < scene.points.size(); ++p) {
    const Vec2 origin = scene.points.position.col(p) - scene.points.displacement.col(p);
    const Vec3 exact = scene.exact->stress(origin, 1.0);
    const double trace = scene.points.stress(0, p) + scene.points.stress(1, p) + scene.points.stress(3, p);
    const double error = (trace - (1.0 + poissons_ratio) * (exact[0] + exact[1])) / 3.0;
    squared += scene.points.volume[p] * error * error;
  }
  return std::sqrt(squared);
}

}  // namespace shoreline::test
