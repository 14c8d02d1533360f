#pragma once
// Sweeps over what makes a cut-cell method fail. Tests run them small, with bounds; stability_table runs them whole.

#include <array>

#include "hard_case.hpp"

namespace shoreline::test {

/// Which part of the sweep over offsets.
struct OffsetChoice {
  int offsets = 12;
  bool ghost = true;    ///< with the penalty of each basis; else without any
  bool fitted = false;  ///< weights; else clipped volumes
};

/// The grid's origin slides through a cell under the turned square, the plate with tractions and with prescribed
/// displacements, and the ring sector: every basis, both methods.
[[nodiscard]] std::vector<Row> offset_sweep(const OffsetChoice& choice);

/// The band from 1e-1 to 1e-12 cells: turned square and plate, both methods, bilinear and quadratic B-splines.
[[nodiscard]] std::vector<Row> band_sweep(int offsets);

/// A corner that reaches into a cell by 1e-2 to 1e-12 cells: one run each.
[[nodiscard]] std::vector<Row> grazing_corner_sweep(bool ghost);

/// An edge that runs beside a grid line, from 1e-1 to 1e-12 cells beyond it: one run each; ν = 0.2 in plane stress and
/// ν = 0.4 in plane strain.
[[nodiscard]] std::vector<Row> grazing_edge_sweep(bool ghost);

/// A body of thickness 1e-3 h, a hole smaller than a cell, two boundaries within one cell.
[[nodiscard]] std::vector<Row> sliver_sweep(int offsets);

/// Triangles with a smallest angle from 45° down to below the limit of the mesh check.
[[nodiscard]] std::vector<Row> sliver_triangle_sweep(int offsets);

/// An edge whose radius of curvature goes from 100 cells to a quarter.
[[nodiscard]] std::vector<Row> curvature_sweep(int offsets);

/// 1 to 64 material points a cell on the plate; clipped volumes or fitted weights.
/// @param per_cell  numbers of points along the side of a cell
[[nodiscard]] std::vector<Row> point_number_sweep(const std::vector<int>& per_cell, bool fitted, int offsets);

/// Deflection of the cantilever's tip under 3000 Pa on one layout of cells and points.
struct CantileverRow {
  double h;  ///< [m]
  int across, high;
  double ghost;
  double tip = 0.0;  ///< [m]
  std::string failure{};
};
/// Four sizes of cells, four lattices of points each.
[[nodiscard]] std::vector<CantileverRow> cantilever_sweep(const std::vector<double>& ghosts);

/// What changes when one material point of a body crosses an edge between two cells by 1e-9 of a cell.
struct CrossingRow {
  std::string basis;
  double quasi_static_stress;  ///< jump of stress at that point, of the largest stress of the load step
  double quasi_static_energy;  ///< jump of the strain energy of the step, relative
  double dynamic_stress;       ///< the same after a time step from a given velocity field
  double dynamic_energy;
};
[[nodiscard]] std::vector<CrossingRow> crossing_sweep();

/// Errors of the pressure as ν tends to ½, with and without projected dilatation, by Nitsche's method.
inline constexpr std::array<double, 3> poissons_ratios{0.3, 0.49, 0.4999};
struct PressureRow {
  std::string basis;
  std::array<double, 3> plain{};      ///< L2 [Pa m]
  std::array<double, 3> projected{};  ///< L2 [Pa m]
};
[[nodiscard]] std::vector<PressureRow> pressure_sweep(Index cells);

/// The critical time step while the top of a column of 8 blocks passes through a cell [s].
struct SurfaceRow {
  std::vector<std::string> mass;  ///< as overrides of the case
  std::string volumes;
  double full = 0.0;  ///< with full cells
  double least = 0.0;
  double most = 0.0;
};
[[nodiscard]] SurfaceRow surface_sweep(const std::vector<std::string>& mass, const std::string& volumes, int places);

/// Root of the mean over the points of their acceleration in the column at rest under its weight, in parts of g; exact
/// integrals would give none.
[[nodiscard]] double spurious_acceleration(int rows, const std::string& volumes);

/// Time-averaged errors of the column to 1 s, partly lumped and pic, as shares of κ H, 2 κ c and σ₀, and the largest
/// change of energy in parts of the strain energy that swings.
struct ColumnErrors {
  double u, v, stress, energy;
};
[[nodiscard]] ColumnErrors column_errors(int rows, const std::string& volumes);

}  // namespace shoreline::test
