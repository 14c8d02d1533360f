#include "shoreline/boundary/essential.hpp"

#include <cassert>

#include "band_width.hpp"
#include "edge_history.hpp"
#include "shoreline/engine/effects.hpp"
#include "slip_points.hpp"

namespace shoreline {
namespace {

class EssentialEdge final : public Contribution {
 public:
  EssentialEdge(int piece, std::string piece_name, Essential condition, std::shared_ptr<const Material> material,
                double gamma)
      : piece_(piece),
        piece_name_(std::move(piece_name)),
        condition_(std::move(condition)),
        material_(std::move(material)),
        gamma_(gamma) {}

  [[nodiscard]] std::string name() const override {
    return (condition_.method == EssentialMethod::nitsche ? "nitsche:" : "implicit_boundary:") + piece_name_;
  }
  [[nodiscard]] std::string needs() const override { return "values and gradients on the edge, and what it carries"; }

  void add(const StepState& step, ElementBlocks& blocks) const override {
    const Edge& edge = step.edges[static_cast<std::size_t>(piece_)];
    const Points points = points_of(step, edge);
    const std::vector<double> width = band_widths(step, edge, condition_, *material_, gamma_);
    for (std::size_t s = 0; s < edge.segments.size(); ++s) {
      const std::size_t block = blocks.append(step.basis.functions_of(edge.support_cell[s]));
      const BandIntegrals band = band_integrals(condition_.method, width[s]);
      Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * blocks.functions_in(block), 2 * blocks.functions_in(block));
      for (std::size_t k = s * points.per_segment; k < (s + 1) * points.per_segment; ++k) {
        const BoundaryPoint& p = points.point[k];
        const EdgeOperators o = operators(step, edge.support_cell[s], p);
        stiffness += p.weight *
                     (band.share * (o.traction.transpose() * o.displacement + o.displacement.transpose() * o.traction) +
                      band.penalty * o.displacement.transpose() * o.stiffness * o.displacement);
        if (step.prescribed.cols() > 0) {
          const Eigen::VectorXd d = local(step, edge, s, step.prescribed);
          const Vec2 moved = o.displacement * d;
          const Vec2 traction = band.penalty * o.stiffness * moved + (band.share - 1.0) * o.traction * d;
          blocks.force_of(block) +=
              p.weight * (o.displacement.transpose() * traction + band.share * o.traction.transpose() * moved);
        }
        if (carried_.empty()) continue;
        const Eigen::Vector4d carried = carried_.at(p.span, p.u);
        blocks.force_of(block) -= p.weight * (o.displacement.transpose() * carried.head<2>() +
                                              band.share * o.traction.transpose() * carried.tail<2>());
      }
      blocks.add(block, stiffness);
    }
  }

  void accept(const StepState& step, const Eigen::Matrix2Xd& increment) override {
    const Edge& edge = step.edges[static_cast<std::size_t>(piece_)];
    const Points points = points_of(step, edge);
    const std::vector<double> width = band_widths(step, edge, condition_, *material_, gamma_);
    Eigen::Matrix4Xd now(4, static_cast<Eigen::Index>(points.point.size()));
    Vec3 reaction = Vec3::Zero();
    for (std::size_t k = 0; k < points.point.size(); ++k) {
      const BoundaryPoint& p = points.point[k];
      const std::size_t s = k / points.per_segment;
      const BandIntegrals band = band_integrals(condition_.method, width[s]);
      const EdgeOperators o = operators(step, edge.support_cell[s], p);
      Eigen::VectorXd d = local(step, edge, s, increment);
      Vec2 traction = Vec2::Zero();
      if (step.prescribed.cols() > 0) {
        const Eigen::VectorXd moved = local(step, edge, s, step.prescribed);
        traction = o.traction * moved;
        d -= moved;
      }
      if (step.dilatation != nullptr)
        traction += step.dilatation->stress(edge.support_cell[s], p.x, increment) * p.normal;
      const Vec2 slip = o.displacement * d;
      traction += band.share * o.traction * d + band.penalty * o.stiffness * slip;
      Eigen::Vector4d total;
      total << traction, slip;
      if (!carried_.empty()) total += held_part(carried_.at(p.span, p.u), p.normal);
      now.col(static_cast<Eigen::Index>(k)) = total;
      reaction -= resultant(p.x, p.weight * total.head<2>());
    }
    if (step.loading == Loading::incremental) {
      reaction_ += reaction;
    } else {
      reaction_ = reaction;
      carried_ = {edge.segments, slip_rule(step.basis).point, std::move(now)};
    }
  }

  void respace(int piece, const PlaceMap& places) override {
    if (piece == piece_) carried_.places = places;
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

  /// Coefficients of the functions that a segment sees, (2n).
  static Eigen::VectorXd local(const StepState& step, const Edge& edge, std::size_t segment,
                               const Eigen::Matrix2Xd& coefficient) {
    const ShortIndices functions = step.basis.functions_of(edge.support_cell[segment]);
    Eigen::VectorXd d(2 * functions.size());
    for (Eigen::Index a = 0; a < functions.size(); ++a) d.segment<2>(2 * a) = coefficient.col(functions[a]);
    return d;
  }

  struct Points {
    std::vector<BoundaryPoint> point;
    std::size_t per_segment;
  };
  static Points points_of(const StepState& step, const Edge& edge) {
    std::vector<BoundaryPoint> points = slip_points(step.basis, edge);
    const std::size_t per_segment = points.size() / edge.segments.size();
    return {std::move(points), per_segment};
  }

  [[nodiscard]] EdgeOperators operators(const StepState& step, Index cell, const BoundaryPoint& p) const {
    return edge_operators(step.basis.support(cell, p.x), p.normal, material_->tangent(Stress::Zero()),
                          condition_.normal_only);
  }

  int piece_;
  std::string piece_name_;
  Essential condition_;
  std::shared_ptr<const Material> material_;
  double gamma_;         ///< of the ghost penalty
  EdgeHistory carried_;  ///< traction T and slip U so far; residual loading only
  Vec3 reaction_ = Vec3::Zero();
};

}  // namespace

std::unique_ptr<Contribution> essential_on(int piece, std::string piece_name, Essential condition,
                                           std::shared_ptr<const Material> material, double gamma) {
  assert(condition.method != EssentialMethod::grid);
  return std::make_unique<EssentialEdge>(piece, std::move(piece_name), std::move(condition), std::move(material),
                                         gamma);
}

}  // namespace shoreline
