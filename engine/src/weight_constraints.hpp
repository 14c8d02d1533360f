#pragma once
// What fitted weights of material points must satisfy: sums over the points equal to integrals over the edge, (W.7),
// (W.8).

#include <span>
#include <vector>

#include "shoreline/boundary/edge.hpp"
#include "shoreline/engine/element_blocks.hpp"
#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// What the weights are consistent with.
enum class Consistency {
  divergence,  ///< (W.7): every constant stress is in balance with the tractions on the edge
  linear       ///< (W.8) as well: every linear stress is in balance with them and with the points' body force
};

/// The constraints at one state of the points. Row (i, m, b) of a function i has the number 2(M i + m) + b; at a point
/// it is s_m ∂_b φ_i with s = 1, (x − X_i)/h_i, (y − Y_i)/h_i. M is 1 for divergence consistency and 3 for linear
/// consistency. Sums run over elements and functions in a fixed order.
class WeightConstraints {
 public:
  /// Evaluates the basis at all points, once for all iterations.
  WeightConstraints(Consistency consistency, const Basis& basis, const MaterialPoints& points,
                    const PointSupports& supports);

  [[nodiscard]] int moments() const { return moments_; }
  [[nodiscard]] Eigen::Index rows() const { return 2 * moments_ * static_cast<Eigen::Index>(basis_.functions()); }
  /// (functions) 1 where an element with points sees the function.
  [[nodiscard]] const std::vector<char>& seen() const { return seen_; }
  [[nodiscard]] bool is_linear(Eigen::Index row) const { return row / 2 % moments_ > 0; }

  /// What the sums must be, r of (W.7), (W.8) [m].
  [[nodiscard]] Eigen::VectorXd right_side(const std::vector<Edge>& edges) const;

  /// Aᵀ λ at the points in the order of cells.
  [[nodiscard]] Eigen::VectorXd at_points(const Eigen::VectorXd& multiplier) const;

  /// A w, (rows) [m].
  /// @param weight  of the points in the order of cells
  [[nodiscard]] Eigen::VectorXd sums(const Eigen::VectorXd& weight) const;

  /// A diag(w) Aᵀ as a block an element, of pseudo-functions M i + m.
  void blocks(const Eigen::VectorXd& weight, ElementBlocks& blocks) const;

 private:
  struct Element {
    Index first_cell, last_cell;  ///< range in the list of occupied cells
  };
  /// Calls use(k, x, g) for the points of an element; g is (2, n) in the order of the functions of its first cell.
  template <class Use>
  void for_points(const Element& element, Use&& use) const;
  void evaluate_basis();
  [[nodiscard]] ShortIndices functions_of(const Element& element) const;
  [[nodiscard]] Eigen::Vector3d shape(Index function, const Vec2& x, const Vec2& centre) const;

  int moments_;
  const Basis& basis_;
  const MaterialPoints& points_;
  const PointSupports& supports_;
  std::vector<double> value_;     ///< (points · n) in the order of cells, function fastest; linear consistency alone
  std::vector<double> gradient_;  ///< (points · 2n), ∂x, ∂y of each function [1/m]
  std::vector<double> h_;         ///< (functions) largest size of a cell with points that sees the function [m]
  std::vector<Element> element_;
  std::vector<char> seen_;
};

}  // namespace shoreline
