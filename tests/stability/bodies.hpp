#pragma once
// Bodies with exact solutions, of which the grid cuts what it will.

#include <vector>

#include "shoreline/engine/case.hpp"

namespace shoreline::test {

/// The compression square, turned by 33°, 10 cells wide, between rollers.
[[nodiscard]] Case turned_compression();

/// The plate with a hole, at h = 1/8.
/// @param loaded_by  "neumann", tractions on its outer boundary, or "dirichlet", displacements there
[[nodiscard]] Case plate_with_hole(const std::string& loaded_by);

/// A quarter of a thick cylinder between inclined rollers, from 20° to 110°, at h = 1/2.
[[nodiscard]] Case ring_sector();

/// A body in pure bending, σ_xx = c y, plane strain: u = c x y/E', v = −c (x² + ν' y²)/(2E'), with E' = E/(1 − ν²) and
/// ν' = ν/(1 − ν). The first piece has the exact displacement, all others the exact tractions.
/// @param outline  pieces that close into loops
/// @param h        [m]
[[nodiscard]] Case bending(std::vector<Piece> outline, double h);

/// Sides of a polygon, counter-clockwise, as pieces.
[[nodiscard]] std::vector<Piece> sides(const std::vector<Vec2>& corners);

/// Corners of a rectangle about the origin, turned.
/// @param angle  [rad]
[[nodiscard]] std::vector<Vec2> rectangle(double width, double height, double angle);

}  // namespace shoreline::test
