#pragma once
// A scene: what a run computes with. It holds the effects that its case names, and nothing of any other.

#include <memory>
#include <optional>
#include <vector>

#include "shoreline/boundary/outline.hpp"
#include "shoreline/engine/assembler.hpp"
#include "shoreline/engine/case.hpp"
#include "shoreline/engine/clock.hpp"
#include "shoreline/engine/contribution.hpp"
#include "shoreline/engine/error_norms.hpp"
#include "shoreline/engine/material.hpp"
#include "shoreline/engine/probes.hpp"

namespace shoreline {

/// A boundary piece with what acts on it.
struct BoundaryPiece {
  Piece piece;
  Condition condition;
  /// The curve at the start: the material at (span, u) of the curve now was at (span, u) of this one. Conditions share
  /// it.
  std::shared_ptr<SplineCurve> original{};
};

struct Scene {
  std::unique_ptr<const Basis> basis;
  std::shared_ptr<const Material> material;
  MaterialPoints points;
  std::optional<ProjectedDilatation> projected;  ///< where the material asks for it, (I.3)
  bool fitted = false;                           ///< their weights are fitted to the outline at every step
  std::vector<BoundaryPiece> boundary;
  std::vector<std::vector<int>> loops;  ///< pieces in order, joined end to start
  std::vector<std::unique_ptr<Contribution>> contributions;
  Loading loading = Loading::residual;
  int load_steps = 1;
  Geometry geometry = Geometry::updated;
  double respacing = 0.0;  ///< ratio of chords beyond which tracking points are re-spaced; 0: never
  std::optional<ExactSolution> exact;
  std::optional<MaterialPoints> samples;  ///< where errors are measured, (N.9), if not at the points; carry no load
  std::optional<MaterialPoints> places;   ///< of probes at a place, in their order; carry no load
  std::vector<Probe> probes;              ///< with their history, to which load steps add
};

/// Turns a case into a scene.
/// @throws CaseError with the key at fault where the outline does not bound a body inside the grid, or holds no points
[[nodiscard]] Scene build_scene(const Case& problem);

/// The same, with its time booked: that of the sample points under "errors", of probes under "probes", all else under
/// "setup".
[[nodiscard]] Scene build_scene(const Case& problem, Clock& phases);

/// What pieces with method `grid` prescribe at one step, (C.3), as components that others give; each once.
///
/// The trace of the displacement, or of its component across the piece, on every cell edge along such a piece is that
/// of the prescribed coefficients (zero where the piece has no value); nothing else is held, so not the slope across
/// the edge.
///
/// @param prescribed  coefficients of what pieces prescribe, (2, functions) [m]; no columns where none does
/// @throws InvalidArgument naming piece and position where a piece leaves the edges of cells, or runs along the edges
///         inside a Powell-Sabin triangle
[[nodiscard]] std::vector<Constraint> grid_constraints(const Basis& basis, const std::vector<BoundaryPiece>& boundary,
                                                       const std::vector<Edge>& edges,
                                                       const Eigen::Matrix2Xd& prescribed);

}  // namespace shoreline
