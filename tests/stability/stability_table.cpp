// Writes docs/stability.md: every sweep in full.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "sweeps.hpp"

using namespace shoreline;
using namespace shoreline::test;

namespace {

std::string spread(const Spread& s, const char* format = "{:.1e} | {:.2g}") {
  return s.median > 0.0 ? fmt::format(fmt::runtime(format), s.median, s.ratio()) : "– | –";
}

void print(const std::vector<Row>& rows) {
  fmt::print(
      "| case | basis | method | γ | band | volumes | runs | refused | singular | indefinite | condition | max/med | "
      "u error | max/med | stress error | max/med | ghost | weights | s |\n");
  fmt::print(
      "| --- | --- | --- | --- | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | "
      "---: | ---: | ---: |\n");
  for (const Row& r : rows)
    fmt::print(
        "| {} | {} | {} | {:g} | {:g} | {} | {} | {} | {} | {} | {} | {} | {} | {:.0f} % | {:.0f} % | {:.3f} |\n",
        r.label, basis_name(r.on), method_name(r.on.method), r.on.ghost, r.on.band, r.on.fitted ? "fitted" : "clipped",
        r.runs, r.failures, r.singular, r.indefinite, spread(r.condition), spread(r.displacement), spread(r.stress),
        100.0 * r.ghost_share, 100.0 * r.weight_share, r.seconds);
  fmt::print("\n");
}

/// What was said where something was wrong, for rows whose remedies are on.
void print_messages(const std::vector<Row>& rows) {
  for (const Row& r : rows)
    if (r.failures + r.singular + r.indefinite > 0)
      fmt::print("- {}, {}, {}, γ {:g}, band {:g}, grid at {}: {}\n", r.label, basis_name(r.on),
                 method_name(r.on.method), r.on.ghost, r.on.band, r.worst, r.said);
  fmt::print("\n");
}

void section(const char* title, const char* shows, const std::vector<Row>& rows, bool messages = true) {
  fmt::print("## {}\n\n{}\n\n", title, shows);
  print(rows);
  if (messages) print_messages(rows);
  std::fflush(stdout);
}

void print(const std::vector<CantileverRow>& rows) {
  fmt::print("| γ | h [m] | points | deflection of the tip [m] |\n| ---: | ---: | ---: | ---: |\n");
  for (const CantileverRow& r : rows)
    fmt::print("| {:g} | {:g} | {} × {} | {} |\n", r.ghost, r.h, r.across, r.high,
               r.failure.empty() ? fmt::format("{:.4f}", r.tip) : "refused: " + r.failure);
  fmt::print("\n");
}

void print(const std::vector<CrossingRow>& rows) {
  fmt::print(
      "| basis | load step: stress | energy | time step: stress | energy |\n| --- | ---: | ---: | ---: | ---: |\n");
  for (const CrossingRow& r : rows)
    fmt::print("| {} | {:.1e} | {:.1e} | {:.1e} | {:.1e} |\n", r.basis, r.quasi_static_stress, r.quasi_static_energy,
               r.dynamic_stress, r.dynamic_energy);
  fmt::print("\n");
}

void print(const std::vector<PressureRow>& rows) {
  fmt::print("| basis | plain, ν = 0.3 | 0.49 | 0.4999 | projected, 0.3 | 0.49 | 0.4999 |\n");
  fmt::print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (const PressureRow& r : rows)
    fmt::print("| {} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} |\n", r.basis, r.plain[0], r.plain[1],
               r.plain[2], r.projected[0], r.projected[1], r.projected[2]);
  fmt::print("\n");
}

/// The column while its top falls through a cell, at rest, and swinging.
void write_columns() {
  fmt::print(
      "## The free surface of a column passes through a cell\n\n"
      "Critical time step at 24 places of the top, Powell-Sabin splines, 8 blocks. A consistent mass alone becomes "
      "singular on the way.\n\n"
      "| mass | volumes | full cells [s] | least | most |\n| --- | --- | ---: | ---: | ---: |\n");
  for (const std::vector<std::string>& mass : std::vector<std::vector<std::string>>{
           {"analysis.mass=partly_lumped"}, {"analysis.mass=consistent", "ghost=0.01"}, {"analysis.mass=lumped"}})
    for (const char* const volumes : {"clipped", "fitted"}) {
      const SurfaceRow r = surface_sweep(mass, volumes, 24);
      fmt::print("| {} | {} | {:.1e} | {:.1e} | {:.1e} |\n", fmt::join(r.mass, ", "), r.volumes, r.full, r.least,
                 r.most);
    }
  fmt::print(
      "\n## Columns under their own weight\n\n"
      "Acceleration of the column at rest, which should be none, in parts of g; then time-averaged errors to 1 s and "
      "the "
      "change of energy, partly lumped mass and pic. With volumes refining does not help.\n\n"
      "| blocks | volumes | acceleration at rest [g] | u [%] | v [%] | σ [%] | energy [%] |\n"
      "| ---: | --- | ---: | ---: | ---: | ---: | ---: |\n");
  for (const int rows : {8, 16, 32})
    for (const char* const volumes : {"clipped", "fitted"}) {
      const double rest = spurious_acceleration(rows, volumes);
      const ColumnErrors e = column_errors(rows, volumes);
      fmt::print("| {} | {} | {:.4f} | {:.3f} | {:.2f} | {:.2f} | {:.3f} |\n", rows, volumes, rest, 100.0 * e.u,
                 100.0 * e.v, 100.0 * e.stress, 100.0 * e.energy);
    }
  fmt::print("\n");
  std::fflush(stdout);
}

constexpr const char* opening =
    R"(# Stability: sweeps over hard cases

This page is written by one command, which takes some minutes:

```
build/release/tests/stability_table > docs/stability.md
```

The tests of the label `stability` run the same sweeps with fewer places of the grid, and bounds on their figures.

Each row is one case on one discretisation, computed with the grid at several places within a cell (`runs`).

| Column | Meaning |
| --- | --- |
| γ, band | of the ghost penalty (G.1), and the width δ/h of essential conditions (D.3). γ > 0 is that of the basis; cases leave it out by default for `bilinear` and `linear` with `implicit_boundary` |
| volumes | rule of `material_points.volumes` |
| refused | runs that ended with a message |
| singular | runs that went on with a warning: the matrix had no inverse, but no load moved what was loose (L.5) |
| indefinite | runs with a warning: Cholesky's factorisation does not exist, a pivoted LU solved |
| condition | estimate (L.3) for the matrix scaled to unit diagonal, median over the runs that went to their end; then its largest over its median |
| u error | relative L2 error of the displacement, median; then largest over median |
| stress error | largest error at any point over the largest exact stress, median; then largest over median |
| ghost, weights | share of the load step's time that the penalty and fitted weights took |
| s | seconds for one run, outline to errors |

Under a table stands what the runs said that were refused or warned, one line a row.

)";

/// The grid's origin slides through a cell.
void write_offsets() {
  section("Where the grid lies", "The grid's origin slides through a cell. With the penalty nothing may depend on it.",
          offset_sweep({.offsets = 200}));
  section("Where the grid lies, fitted weights", "The same with `volumes: fitted`.",
          offset_sweep({.offsets = 200, .fitted = true}));
  section(
      "Where the grid lies, without ghost penalty",
      "The same with γ = 0. Powell-Sabin splines are singular everywhere. On other bases some places are indefinite or "
      "refused, and stresses in slivers are thousands of times too large, while displacements hardly show it.",
      offset_sweep({.offsets = 200, .ghost = false}));
}

/// What cuts a cell in an extreme way, and how wide the band is.
void write_bands_and_grazes() {
  section(
      "Width of the band",
      "The solution stays usable, or comes with a warning. Wide bands cost definiteness (`nitsche`) or accuracy "
      "(`implicit_boundary`); thin ones gain nothing, and the condition grows as 1/δ: at 1e-12 four digits are left.",
      band_sweep(10));
  section("A corner that grazes a cell",
          "The right corner of a diamond reaches into a column of cells by 1e-2, 1e-3, … 1e-12 h; each row has all 11.",
          grazing_corner_sweep(true));
  section("A corner that grazes a cell, without ghost penalty",
          "The same with γ = 0: stresses at the corner are wild, also without a warning.", grazing_corner_sweep(false));
  section(
      "An edge beside a grid line",
      "A roller along the plate's left edge leaves a layer of 1e-1, 1e-2, … 1e-12 h beyond a line of the grid; each "
      "row has all 12. (D.10) gives the band that bears it.",
      grazing_edge_sweep(true));
}

/// Bodies, meshes, points and motions at the edge of what is possible.
void write_extremes() {
  section(
      "Slivers",
      "A strip of a thousandth of a cell, a hole within a cell, a hole that leaves a thin wall. Linear bases find the "
      "strip's displacement, not its stress; cubic B-splines are refused. Holes and walls are like any cut.",
      sliver_sweep(20));
  section("Flat triangles",
          "Rectangles that are cut by diagonals get flatter. The mesh check refuses angles below 1°: that is the "
          "limit. The condition grows as the inverse square of the angle.",
          sliver_triangle_sweep(5));
  section("Curvature",
          "A bow of 100 to 5 cells, then a hole of 3 cells to a quarter, the field being the same: the "
          "error does not see the radius.",
          curvature_sweep(10));
  section(
      "Points a cell",
      "From 1 to 64 points in a cell, clipped volumes. Linear bases and Powell-Sabin splines live with one; B-splines "
      "of degree p need about (p + 1)², and say so where they have fewer.",
      point_number_sweep({1, 2, 3, 4, 6, 8}, false, 10));
  section("Points a cell, fitted weights", "The same with `volumes: fitted`.",
          point_number_sweep({1, 2, 3, 4, 6, 8}, true, 10));
  fmt::print(
      "## Cantilever under 3000 Pa\n\n"
      "Its left edge is fixed, its tip goes down by half the length; corners cross into empty cells all the "
      "time. Lattices with points in every cell bend alike.\n\n");
  print(cantilever_sweep({1e-4, 1e-3}));
  fmt::print(
      "## A point crosses an edge between two cells\n\n"
      "By 1e-9 of a cell. Where gradients jump across the edge, so do stress and energy; across the edges of "
      "smooth bases they do not.\n\n");
  print(crossing_sweep());
  fmt::print(
      "## Nearly incompressible\n\n"
      "L2 error of the pressure, smooth displacement of a square, h = 1/16, `nitsche`, grid off the sides: `plain` and "
      "with "
      "`material.dilatation` `projected`.\n\n");
  print(pressure_sweep(16));
  std::fflush(stdout);
}

}  // namespace

int main() {
  try {
    fmt::print("{}", opening);
    write_offsets();
    write_bands_and_grazes();
    write_extremes();
    write_columns();
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "stability_table: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
