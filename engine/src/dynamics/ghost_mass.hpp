#pragma once
// The mass that binds functions with little material to their neighbours.

#include <Eigen/SparseCore>
#include <map>
#include <utility>

#include "../ghost_faces.hpp"

namespace shoreline {

/// G = γ ρ Σ_F h^(2p+1) ∫_F [∂ₙᵖ φ_i][∂ₙᵖ φ_j] dS, (G.4), over all faces between elements with material points. It
/// vanishes on polynomials of degree p, and its rows sum to zero.
class GhostMass {
 public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// @param gamma    γ >= 0, dimensionless
  /// @param density  ρ [kg/m³]
  GhostMass(double gamma, double density) : scale_(gamma * density) {}

  /// Takes the faces of a step; those of the step before keep their jumps, which are of the grid.
  /// @param active  (cells) as PointSupports has it
  void find(const Basis& basis, const std::vector<char>& active);

  [[nodiscard]] const Matrix& matrix() const { return matrix_; }  ///< (functions, functions) [kg per metre]

 private:
  double scale_;
  std::vector<char> active_;  ///< for which the matrix holds
  std::map<std::pair<Index, Index>, FaceJumps> jumps_;
  Matrix matrix_;
};

}  // namespace shoreline
