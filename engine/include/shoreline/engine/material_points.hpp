#pragma once
// The material points, as structure of arrays, and the cells in which they sit.

#include <vector>

#include "shoreline/bases/basis.hpp"

namespace shoreline {

/// A point on the outline, which belongs to the cell on the body's side wherever grid lines run.
struct OutlinePoint {
  Index point;
  Vec2 inward;  ///< unit direction into the body
};

/// State carried by the material points; column p belongs to point p.
struct MaterialPoints {
  Eigen::Matrix2Xd position;      ///< [m]
  Eigen::Matrix2Xd displacement;  ///< since the start [m]; position − displacement is the original position
  Eigen::VectorXd volume;         ///< [m³ per metre of thickness], positive
  Eigen::Matrix4Xd stress;        ///< xx, yy, xy, zz [Pa]
  Eigen::Matrix3Xd strain;        ///< xx, yy, xy (engineering)
  std::vector<OutlinePoint> on_outline;

  [[nodiscard]] Index size() const { return static_cast<Index>(volume.size()); }
};

/// Points at rest without stress.
/// @param position  (2, n) [m]
/// @param volume    (n) [m³ per metre of thickness]
[[nodiscard]] MaterialPoints points_at(Eigen::Matrix2Xd position, Eigen::VectorXd volume);

/// Where every material point sits, and the basis there: evaluated once a load step.
struct PointSupports {
  std::vector<Index> cell;       ///< (m) the cells that hold points, ascending
  std::vector<Index> first;      ///< (m + 1) range of each such cell in the arrays below
  std::vector<Index> point;      ///< points in the order of cells
  int functions = 0;             ///< n per cell
  std::vector<double> value;     ///< (points · n), function fastest
  std::vector<double> gradient;  ///< (points · 2n), ∂x, ∂y of each function [1/m]
  std::vector<char> active;      ///< (cells of the grid) 1 in all parts of an element in which a material point sits

  [[nodiscard]] Index cells() const { return static_cast<Index>(cell.size()); }
};

/// @throws ComputationError naming the first point outside the grid, its position, and how many there are
void check_inside(const Basis& basis, const MaterialPoints& points);

/// Finds the cells of all points and evaluates the basis there.
///
/// @param reuse  the supports of the step before, whose memory serves again
/// @throws ComputationError naming the first point outside the grid, its position, and how many there are
[[nodiscard]] PointSupports locate_points(const Basis& basis, const MaterialPoints& points, PointSupports reuse = {});

/// Reorders the points by cell, which makes every later pass over them local.
void sort_by_cell(const Basis& basis, MaterialPoints& points);

}  // namespace shoreline
