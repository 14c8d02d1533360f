#include "shoreline/boundary/essential.hpp"

#include <algorithm>
#include <cassert>

#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

/// What a support has exerted so far, along the curve: traction T (rows 0, 1) and slip U (rows 2, 3), polynomial on
/// each segment of the step before, (D.7). The place (span, u) moves with the material.
struct EdgeHistory {
  std::vector<Segment> segments;
  Eigen::VectorXd node;    ///< Gauss points of a segment, in [0, 1]
  Eigen::Matrix4Xd value;  ///< at every boundary point

  [[nodiscard]] Eigen::Vector4d at(int span, double u) const {
    const auto ends_before = [&](const Segment& segment) {
      return segment.span < span || (segment.span == span && segment.end < u);
    };
    const auto found = std::ranges::partition_point(segments, ends_before);
    const auto s = static_cast<std::size_t>(std::min(found, segments.end() - 1) - segments.begin());
    const double place = (u - segments[s].begin) / (segments[s].end - segments[s].begin);
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (Eigen::Index i = 0; i < node.size(); ++i) {  // Lagrange polynomials
      double weight = 1.0;
      for (Eigen::Index j = 0; j < node.size(); ++j)
        if (j != i) weight *= (place - node[j]) / (node[i] - node[j]);
      sum += weight * value.col(static_cast<Eigen::Index>(s) * node.size() + i);
    }
    return sum;
  }
};

class EssentialEdge final : public Contribution {
 public:
  EssentialEdge(int piece, std::string piece_name, Essential condition, std::shared_ptr<const Material> material)
      : piece_(piece), piece_name_(std::move(piece_name)), condition_(condition), material_(std::move(material)) {}

  [[nodiscard]] std::string name() const override {
    return (condition_.method == EssentialMethod::nitsche ? "nitsche:" : "implicit_boundary:") + piece_name_;
  }

  void add(const StepState& step, ElementBlocks& blocks) const override {
    const Edge& edge = step.edges[static_cast<std::size_t>(piece_)];
    for (std::size_t s = 0; s < edge.segments.size(); ++s) {
      const std::size_t block = blocks.append(step.basis.functions_of(edge.support_cell[s]));
      const BandIntegrals band = band_of(step, edge.segments[s]);
      Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * blocks.functions_in(block), 2 * blocks.functions_in(block));
      for (std::size_t k = first_point(edge, s); k < first_point(edge, s + 1); ++k) {
        const BoundaryPoint& p = edge.points[k];
        const EdgeOperators o = operators(step, edge, k);
        stiffness += p.weight *
                     (band.share * (o.traction.transpose() * o.displacement + o.displacement.transpose() * o.traction) +
                      band.penalty * o.displacement.transpose() * o.stiffness * o.displacement);
        if (carried_.segments.empty()) continue;
        const Eigen::Vector4d carried = carried_.at(p.span, p.u);
        blocks.force_of(block) -= p.weight * (o.displacement.transpose() * carried.head<2>() +
                                              band.share * o.traction.transpose() * carried.tail<2>());
      }
      blocks.add(block, stiffness);
    }
  }

  void accept(const StepState& step, const Eigen::Matrix2Xd& increment) override {
    const Edge& edge = step.edges[static_cast<std::size_t>(piece_)];
    Eigen::Matrix4Xd now(4, static_cast<Eigen::Index>(edge.points.size()));
    Vec3 reaction = Vec3::Zero();
    for (std::size_t k = 0; k < edge.points.size(); ++k) {
      const BoundaryPoint& p = edge.points[k];
      const std::size_t s = edge.segment_of(k);
      const BandIntegrals band = band_of(step, edge.segments[s]);
      const EdgeOperators o = operators(step, edge, k);
      const ShortIndices functions = step.basis.functions_of(edge.support_cell[s]);
      Eigen::VectorXd d(2 * functions.size());
      for (Eigen::Index a = 0; a < functions.size(); ++a) d.segment<2>(2 * a) = increment.col(functions[a]);

      const Vec2 slip = o.displacement * d;
      const Vec2 traction = band.share * o.traction * d + band.penalty * o.stiffness * slip;
      auto total = now.col(static_cast<Eigen::Index>(k));
      total << traction, slip;
      if (!carried_.segments.empty()) total += held_part(carried_.at(p.span, p.u), p.normal);
      reaction -= resultant(p.x, p.weight * total.head<2>());
    }
    if (step.loading == Loading::incremental) {
      reaction_ += reaction;
    } else {
      reaction_ = reaction;
      carried_ = {edge.segments, gauss(edge.points_per_segment).point, std::move(now)};
    }
  }

  void report(Resultants& resultants) const override { resultants.reactions[piece_name_] = reaction_; }

 private:
  /// P of traction and slip carried so far: a roller that has turned holds only what is normal to it now.
  [[nodiscard]] Eigen::Vector4d held_part(const Eigen::Vector4d& carried, const Vec2& normal) const {
    if (!condition_.normal_only) return carried;
    Eigen::Vector4d held;
    held << normal.dot(carried.head<2>()) * normal, normal.dot(carried.tail<2>()) * normal;
    return held;
  }

  static std::size_t first_point(const Edge& edge, std::size_t segment) {
    return segment * static_cast<std::size_t>(edge.points_per_segment);
  }

  [[nodiscard]] BandIntegrals band_of(const StepState& step, const Segment& segment) const {
    return band_integrals(condition_.method, condition_.band * step.basis.grid().size(segment.cell));
  }

  [[nodiscard]] EdgeOperators operators(const StepState& step, const Edge& edge, std::size_t k) const {
    const Support support = step.basis.support(edge.support_cell[edge.segment_of(k)], edge.points[k].x);
    return edge_operators(support, edge.points[k].normal, material_->tangent(Stress::Zero()), condition_.normal_only);
  }

  int piece_;
  std::string piece_name_;
  Essential condition_;
  std::shared_ptr<const Material> material_;
  EdgeHistory carried_;  ///< residual loading only
  Vec3 reaction_ = Vec3::Zero();
};

}  // namespace

std::unique_ptr<Contribution> essential_on(int piece, std::string piece_name, Essential condition,
                                           std::shared_ptr<const Material> material) {
  assert(condition.method != EssentialMethod::grid);
  return std::make_unique<EssentialEdge>(piece, std::move(piece_name), condition, std::move(material));
}

}  // namespace shoreline
