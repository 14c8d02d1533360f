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
  Eigen::Matrix3Xd strain;        ///< xx, yy, xy (engineering); no columns where nothing asks for it
  std::vector<OutlinePoint> on_outline;

  [[nodiscard]] Index size() const { return static_cast<Index>(volume.size()); }
};

/// Points at rest without stress, which keep no strain.
/// @param position  (2, n) [m]
/// @param volume    (n) [m³ per metre of thickness]
[[nodiscard]] MaterialPoints points_at(Eigen::Matrix2Xd position, Eigen::VectorXd volume);

/// What is evaluated of a basis.
enum class Evaluate { values, values_and_gradients };

/// Where every material point sits: found once a load step. The basis there is evaluated by those who use it, cell by
/// cell (BasisAtPoints): that takes less time than to write it down for all points and to read it again.
struct PointSupports {
  std::vector<Index> cell;   ///< (m) the cells that hold points, ascending
  std::vector<Index> first;  ///< (m + 1) range of each such cell in the arrays below
  std::vector<Index> point;  ///< points in the order of cells
  std::vector<Vec2> place;   ///< where they were located, in this order [m]
  int functions = 0;         ///< n per cell
  Index most = 0;            ///< points in one cell
  std::vector<char> active;  ///< (cells of the grid) 1 in all parts of an element in which a material point sits

  [[nodiscard]] Index cells() const { return static_cast<Index>(cell.size()); }
};

/// @throws ComputationError naming the first point outside the grid, its position, and how many there are
void check_inside(const Basis& basis, const MaterialPoints& points);

/// The basis at the points of one cell after the other, in memory that serves again.
class BasisAtPoints {
 public:
  /// @param supports  outlive this object
  BasisAtPoints(const Basis& basis, const PointSupports& supports, Evaluate what = Evaluate::values_and_gradients);

  /// Evaluates at the points of the c-th occupied cell.
  void evaluate(Index c);

  /// (n) values at the k-th point in the order of cells. @pre one of the cell that was evaluated last
  [[nodiscard]] const double* value(Index k) const { return value_.data() + (k - begin_) * supports_->functions; }
  /// (2n) ∂x, ∂y of each function there [1/m]. @pre it evaluates gradients, too
  [[nodiscard]] const double* gradient(Index k) const {
    return gradient_.data() + 2 * (k - begin_) * supports_->functions;
  }

 private:
  const Basis* basis_;
  const PointSupports* supports_;
  Index begin_ = 0;  ///< first point of the cell
  std::vector<double> value_;
  std::vector<double> gradient_;  ///< empty where it is not wanted
};

/// Finds the cells of all points.
///
/// @param reuse  the supports of the step before, whose memory serves again
/// @throws ComputationError naming the first point outside the grid, its position, and how many there are
[[nodiscard]] PointSupports locate_points(const Basis& basis, const MaterialPoints& points, PointSupports reuse = {});

/// Reorders the points by cell, which makes every later pass over them local.
void sort_by_cell(const Basis& basis, MaterialPoints& points);

}  // namespace shoreline
