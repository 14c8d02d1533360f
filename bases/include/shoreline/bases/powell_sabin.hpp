#pragma once
// The basis of quadratic Powell-Sabin splines: smooth and non-negative on any triangle mesh.

#include "shoreline/bases/basis.hpp"
#include "shoreline/bases/triangle_grid.hpp"

namespace shoreline {

/// Three functions a vertex of the main mesh, one for each corner of its control triangle, (S.4)–(S.10); quadratic on
/// each sub-triangle of the Powell-Sabin refinement, continuous with their gradients.
///
/// Functions 3v, 3v + 1, 3v + 2 belong to vertex v; their control points are the corners of its control triangle. The
/// cells of the grid are the sub-triangles, numbered as in powell_sabin_refinement.
///
/// On the border, the control triangle has a side on the border's line: only two of three functions do not vanish
/// there. At a corner of the body of less than 150° it has two such sides. Re-entrant corners have none.
class PowellSabinBasis final : public Basis {
 public:
  /// @throws MeshError by check(mesh)
  explicit PowellSabinBasis(const TriangleMesh& mesh);

  [[nodiscard]] const TriangleGrid& grid() const override { return grid_; }
  [[nodiscard]] Index functions() const override { return static_cast<Index>(3 * control_.size()); }
  [[nodiscard]] int functions_per_cell() const override { return 9; }
  [[nodiscard]] int degree() const override { return 2; }
  [[nodiscard]] int continuity() const override { return 1; }
  [[nodiscard]] int gradient_degree() const override { return 1; }
  [[nodiscard]] ShortIndices functions_of(Index cell) const override;
  [[nodiscard]] Vec2 control_point(Index function) const override;
  void evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const override;
  void evaluate(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const override;
  [[nodiscard]] ShortCurvatures curvatures(Index cell, const Vec2& x) const override;

 private:
  /// What (S.9) needs of a sub-triangle (V_i, R_ij, Z) of the main triangle (V_i, V_j, V_k).
  struct Piece {
    Vec2 origin;      ///< V_i [m]
    Vec2 slope_r;     ///< gradient of the barycentric coordinate of R_ij [1/m]
    Vec2 slope_z;     ///< and of that of Z [1/m]
    double lambda_i;  ///< R_ij = λ_i V_i + λ_j V_j
    double lambda_j;
    double a_i;  ///< Z = a_i V_i + a_j V_j + a_k V_k
    double a_j;
    Eigen::Matrix<double, 3, 6> ordinate;  ///< (q; α_i, L_i, L̃_i, λ_j L_j, L̃_j, a_k L̃_k), (S.8)
    std::array<Index, 3> vertex;           ///< i, j, k
  };
  template <class Point, class Number>
  void evaluate_all(Index cell, std::span<const Point> x, Number* value, Number* gradient) const;
  void evaluate_lanes(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const;
  [[nodiscard]] Piece make_piece(const TriangleMesh& main, Index cell) const;

  TriangleGrid grid_;
  std::vector<std::array<Vec2, 3>> control_;  ///< control triangle of each vertex, from the vertex [m]
  std::vector<Piece> piece_;
};

}  // namespace shoreline
