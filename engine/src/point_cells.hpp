#pragma once
// The cells in which material points sit, and the points in the order of cells.

#include <vector>

#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// The cell of every point, in the order of points; −1 outside the grid.
[[nodiscard]] std::vector<Index> cells_of(const Basis& basis, const MaterialPoints& points);

/// Puts points on the outline into the cell on the body's side of a grid line.
/// @param cell  (points) of every point, −1 outside the grid
void keep_on_body_side(const Basis& basis, const MaterialPoints& points, std::vector<Index>& cell);

/// @throws ComputationError naming the first point outside the grid, its position, and how many there are
void require_inside(const std::vector<Index>& cell, const MaterialPoints& points);

/// Order of the points by cell, in linear time; points of one cell keep their order.
/// @param cells  of the grid
/// @pre every point has a cell
void order_by_cell(const std::vector<Index>& cell, Index cells, std::vector<Index>& order);

/// Lists the occupied cells with their points; the places stay as they are.
/// @pre every point has a cell
void group_points(const std::vector<Index>& cell, const Grid& grid, PointSupports& supports);

/// Notes where the points are, in the order of cells.
void note_places(const MaterialPoints& points, PointSupports& supports);

/// The columns of a field, one a point, in a new order; what is not in it is gone.
template <class Field>
void reorder_columns(const std::vector<Index>& order, Field& field) {
  Field after(field.rows(), static_cast<Eigen::Index>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) after.col(static_cast<Eigen::Index>(k)) = field.col(order[k]);
  field = std::move(after);
}

/// The same for numbers, one a point.
inline void reorder_entries(const std::vector<Index>& order, Eigen::VectorXd& numbers) {
  Eigen::VectorXd after(static_cast<Eigen::Index>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) after[static_cast<Eigen::Index>(k)] = numbers[order[k]];
  numbers = std::move(after);
}

/// Puts the points in a new order: at place k the one that was at order[k]. Points that are not in it are gone.
void reorder(const std::vector<Index>& order, MaterialPoints& points);

}  // namespace shoreline
