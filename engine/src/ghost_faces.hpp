#pragma once
// Faces across which a ghost term binds polynomials, and the jumps there.

#include <vector>

#include "shoreline/bases/basis.hpp"
#include "shoreline/boundary/edge.hpp"

namespace shoreline {

/// The functions of both cells of a face, and the jump of their normal derivatives of order p at Gauss points on it.
struct FaceJumps {
  using Jump = Eigen::Matrix<double, 1, Eigen::Dynamic>;

  std::vector<Index> functions;
  std::vector<Jump> jump;      ///< a Gauss point: ∂ₙᵖ φ of the cell less that of its neighbour [1/mᵖ]
  std::vector<double> weight;  ///< scale · h^power w |F|: what multiplies jump · jumpᵀ
};

/// @param scale  γ times what the term is measured in: E [N/m²], or ρ [kg/m³]
/// @param power  of the width h of the element across the face: 2p − 1 for a stiffness (G.1), 2p + 1 for a mass (G.4)
[[nodiscard]] FaceJumps face_jumps(const Basis& basis, const Face& face, double scale, int power);

/// Faces between active cells, each once; of them at least one belongs to an element that the boundary cuts, or that
/// serves one of its segments.
/// @param active  (cells)
[[nodiscard]] std::vector<Face> faces_at_boundary(const Grid& grid, const std::vector<char>& active,
                                                  const std::vector<Edge>& edges);

/// All faces between active cells, each once.
[[nodiscard]] std::vector<Face> faces_inside(const Grid& grid, const std::vector<char>& active);

}  // namespace shoreline
