#include "prescribed.hpp"

#include <algorithm>

namespace shoreline {
namespace {

const Essential* essential(const BoundaryPiece& piece) { return std::get_if<Essential>(&piece.condition); }

bool prescribes(const BoundaryPiece& piece) { return essential(piece) != nullptr && essential(piece)->value; }

HeldEdge held_edge(const Essential& condition, const Edge& edge, double t, double t_before) {
  HeldEdge held{edge, condition.normal_only, Eigen::Matrix2Xd::Zero(2, static_cast<Eigen::Index>(edge.points.size()))};
  if (!condition.value) return held;
  for (std::size_t k = 0; k < edge.points.size(); ++k) {
    Vec2 gain = condition.value(edge.points[k], t);
    if (t_before > 0.0) gain -= condition.value(edge.points[k], t_before);
    held.value.col(static_cast<Eigen::Index>(k)) = gain;
  }
  return held;
}

}  // namespace

Eigen::Matrix2Xd prescribed_increment(const Scene& scene, const std::vector<Edge>& edges, double t, double t_before,
                                      std::map<std::string, FitError>& errors) {
  if (std::ranges::none_of(scene.boundary, prescribes)) return Eigen::Matrix2Xd(2, 0);
  std::vector<HeldEdge> held;
  std::vector<const BoundaryPiece*> pieces;
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (const Essential* condition = essential(scene.boundary[k])) {
      held.push_back(held_edge(*condition, edges[k], t, t_before));
      pieces.push_back(&scene.boundary[k]);
    }
  DisplacementFit fit = fit_displacement(*scene.basis, held);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    if (prescribes(*pieces[k])) {
      FitError& sum = errors[pieces[k]->piece.name];
      sum.l2 += fit.error[k].l2;
      sum.mean += fit.error[k].mean;
    }
  return std::move(fit.coefficient);
}

}  // namespace shoreline
