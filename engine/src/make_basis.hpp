#pragma once
// The grid and basis of a case.

#include <memory>

#include "shoreline/bases/basis.hpp"
#include "shoreline/bases/quadrilateral_grid.hpp"
#include "shoreline/engine/case.hpp"
#include "shoreline/engine/results.hpp"

namespace shoreline {

/// @throws MeshError if the triangles of a case break a rule
[[nodiscard]] std::unique_ptr<const Basis> make_basis(const Case::Grid& grid);

/// Columns and rows of the rectangles that cover a grid; as doubles, which hold any number of them.
[[nodiscard]] Vec2 rectangles_of(const Case::Grid& grid);

/// The rectangles of a grid, whole or cut.
/// @pre the grid is no mesh
[[nodiscard]] QuadrilateralGrid rectangles(const Case::Grid& grid);

/// As a case names it.
[[nodiscard]] const char* name_of(Case::BasisType basis);

/// The basis of a run with its degree, if that is free.
void name_basis(const Case::Grid& grid, Summary& summary);

}  // namespace shoreline
