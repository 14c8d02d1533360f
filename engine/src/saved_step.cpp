#include "saved_step.hpp"

#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

constexpr int samples_per_span = 16;  ///< of a curve that is drawn

Eigen::Matrix2Xd sampled(const SplineCurve& curve) {
  Eigen::Matrix2Xd line(2, static_cast<Eigen::Index>(curve.spans.size()) * samples_per_span + 1);
  Eigen::Index n = 0;
  line.col(n++) = curve.spans.front().position(0.0);
  for (const CubicSpan& span : curve.spans)
    for (int k = 1; k <= samples_per_span; ++k)
      line.col(n++) = span.position(static_cast<double>(k) / samples_per_span);
  return line;
}

/// The piece as it is drawn: its spline, or a line through its points where motion has left none.
Eigen::Matrix2Xd drawn(const Piece& piece, const Eigen::Matrix2Xd& points) {
  try {
    return sampled(fit_spline(piece));
  } catch (const InvalidArgument&) {
    return points;
  }
}

}  // namespace

SavedStep saved_step(const Scene& scene, int step, double t) {
  SavedStep saved{.step = step, .t = t, .curves = {}};
  for (const BoundaryPiece& b : scene.boundary) {
    Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(b.piece.points.size()));
    for (Eigen::Index k = 0; k < points.cols(); ++k) points.col(k) = b.piece.points[static_cast<std::size_t>(k)];
    Eigen::Matrix2Xd line = drawn(b.piece, points);
    saved.curves.push_back({b.piece.name, std::move(points), std::move(line)});
  }
  return saved;
}

}  // namespace shoreline
