#pragma once
// The projected dilatation of one load step: the trace of the strain increment as one polynomial on each macro-element.

#include <vector>

#include "shoreline/boundary/edge.hpp"
#include "shoreline/engine/macro_elements.hpp"
#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// Where a material projects the dilatation, and the parameter by which it resists it.
struct ProjectedDilatation {
  MacroElements groups;
  double lambda;  ///< λ of (M.1) [Pa]
};

/// A macro-element that holds material points. Its polynomials q are orthonormal over them, Σ V_p q qᵀ = I.
struct DilatationPatch {
  std::vector<Index> functions;  ///< (n) those that see it, ascending
  Vec2 centre;                   ///< centroid of its points [m]
  double length;                 ///< half its width [m]
  Eigen::MatrixXd orthonormal;   ///< (m, monomials): q = orthonormal · monomials of (x − centre)/length [1/m]
  Eigen::MatrixXd divergence;    ///< (m, 2n): 𝐆 of (I.4) [1]
  Eigen::VectorXd prescribed;    ///< (m): 𝐠 of (I.4) [m]
};

/// Projects dilatations at one load step, (I.3): π tr ε = qᵀ (𝐆 d + 𝐠) on each patch.
class Dilatation {
 public:
  /// Every element with material points is part of one patch.
  Dilatation(const Basis& basis, const ProjectedDilatation& law, const MaterialPoints& points,
             const PointSupports& supports);

  /// Takes in that the body may slip over an edge, (I.4): the jump across it is part of the dilatation.
  /// @param points      of the edge, the same number in each segment, in order
  /// @param prescribed  (2, functions) coefficients of what pieces prescribe [m]; no columns where none does
  void let_slip(const Edge& edge, const std::vector<BoundaryPoint>& points, const Eigen::Matrix2Xd& prescribed);

  [[nodiscard]] double lambda() const { return lambda_; }
  [[nodiscard]] const std::vector<DilatationPatch>& patches() const { return patches_; }

  /// λ π tr Δε at a place, by the polynomials of the patch of a cell [Pa].
  /// @param cell       of an element with material points
  /// @param increment  (2, functions) Δd [m]
  [[nodiscard]] double stress(Index cell, const Vec2& x, const Eigen::Matrix2Xd& increment) const;

  /// λ (π tr Δε − tr Δε) at every material point, (I.6) [Pa].
  [[nodiscard]] Eigen::RowVectorXd correction(const MaterialPoints& points, const PointSupports& supports,
                                              const Eigen::Matrix2Xd& increment) const;

 private:
  [[nodiscard]] std::size_t patch_of(Index cell) const;
  [[nodiscard]] Eigen::VectorXd polynomials(const DilatationPatch& patch, const Vec2& x) const;
  [[nodiscard]] Eigen::VectorXd coefficients(const DilatationPatch& patch, const Eigen::Matrix2Xd& increment) const;

  const Basis* basis_;
  double lambda_;
  PolynomialSpace polynomials_;
  std::vector<Index> patch_of_element_;  ///< −1 for elements without points
  std::vector<DilatationPatch> patches_;
};

}  // namespace shoreline
