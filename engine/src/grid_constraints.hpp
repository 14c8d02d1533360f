#pragma once
// Conditions of pieces on grid lines in two parts: which edges of cells they hold, which seldom changes from one step
// to the next, and what follows for the basis.

#include "shoreline/engine/scene.hpp"

namespace shoreline {

/// An edge of a cell along which a piece with method `grid` runs.
struct HeldCellEdge {
  int piece;
  Index cell;
  Vec2 a;
  Vec2 b;
  Vec2 near;  ///< a place of the piece there, for messages

  [[nodiscard]] bool operator==(const HeldCellEdge& other) const {
    return piece == other.piece && cell == other.cell && a == other.a && b == other.b;
  }
};

/// Those edges, in the order of pieces and segments.
/// @throws as grid_constraints where a piece leaves the edges of cells
[[nodiscard]] std::vector<HeldCellEdge> held_cell_edges(const Basis& basis, const std::vector<BoundaryPiece>& boundary,
                                                        const std::vector<Edge>& edges);

/// grid_constraints from them.
/// @throws as grid_constraints where a piece runs inside a Powell-Sabin triangle
[[nodiscard]] std::vector<Constraint> constraints_along(const std::vector<HeldCellEdge>& held, const Basis& basis,
                                                        const std::vector<BoundaryPiece>& boundary,
                                                        const Eigen::Matrix2Xd& prescribed);

}  // namespace shoreline
