#include "motion_check.hpp"

#include "shoreline/engine/failures.hpp"

namespace shoreline {
namespace {

Box bounds(const SplineCurve& curve) {
  Box box = curve.spans.front().bounds();
  for (const CubicSpan& span : curve.spans) {
    box.lower = box.lower.cwiseMin(span.bounds().lower);
    box.upper = box.upper.cwiseMax(span.bounds().upper);
  }
  return box;
}

}  // namespace

void check_motion(const Scene& scene) {
  constexpr const char* smaller_steps = "; take smaller load steps (analysis.load_steps) or reduce the load";
  check_inside(*scene.basis, scene.points);
  std::vector<Piece> pieces;
  std::vector<SplineCurve> curves;
  try {
    for (const BoundaryPiece& b : scene.boundary) {
      curves.push_back(fit_spline(b.piece));
      if (!scene.basis->grid().covers(bounds(curves.back())))
        static_cast<void>(trace(curves.back(), scene.basis->grid(), b.piece.name));
      pieces.push_back(b.piece);
    }
    check_outline(pieces, curves, scene.loops);
  } catch (const OutsideGrid& error) {
    throw ComputationError(std::string(error.what()) + "; enlarge the grid or reduce the load");
  } catch (const InvalidArgument& error) {
    throw ComputationError(error.what() + std::string(smaller_steps));
  } catch (const OutlineError& error) {
    throw ComputationError(error.what() + std::string(smaller_steps));
  }
}

}  // namespace shoreline
