#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

/// A load on one piece: f = ∫ Mᵀ t dS.
class EdgeLoad final : public Contribution {
 public:
  EdgeLoad(std::string effect, int piece, std::string piece_name,
           std::function<Vec2(const BoundaryPoint&, double)> value)
      : effect_(std::move(effect)), piece_(piece), piece_name_(std::move(piece_name)), value_(std::move(value)) {}

  [[nodiscard]] std::string name() const override { return effect_ + ":" + piece_name_; }
  [[nodiscard]] std::string needs() const override { return "values on the edge"; }

  void add(const StepState& step, ElementBlocks& blocks) const override {
    const Edge& edge = step.edges[static_cast<std::size_t>(piece_)];
    for (std::size_t k = 0; k < edge.points.size(); ++k) {
      const std::size_t segment = edge.segment_of(k);
      if (k % static_cast<std::size_t>(edge.points_per_segment) == 0)
        blocks.append(step.basis.functions_of(edge.support_cell[segment]));
      const Support support = step.basis.support(edge.support_cell[segment], edge.points[k].x);
      const Vec2 force = force_of(step, edge.points[k]);
      auto sum = blocks.force_of(blocks.size() - 1);
      for (Eigen::Index a = 0; a < support.value.size(); ++a) sum.segment<2>(2 * a) += support.value[a] * force;
    }
  }

  void accept(const StepState& step, const Eigen::Matrix2Xd& /*increment*/) override {
    if (step.loading == Loading::residual) total_.setZero();
    for (const BoundaryPoint& p : step.edges[static_cast<std::size_t>(piece_)].points)
      total_ += resultant(p.x, force_of(step, p));
  }

  void report(Resultants& resultants) const override { resultants.loads[piece_name_] = total_; }

 private:
  [[nodiscard]] Vec2 force_of(const StepState& step, const BoundaryPoint& p) const {
    return p.weight * step.load([&](double t) -> Vec2 { return value_(p, t); });
  }

  std::string effect_;
  int piece_;
  std::string piece_name_;
  std::function<Vec2(const BoundaryPoint&, double)> value_;
  Vec3 total_ = Vec3::Zero();
};

}  // namespace

std::unique_ptr<Contribution> traction_on(int piece, std::string piece_name, Traction traction) {
  return std::make_unique<EdgeLoad>("traction", piece, std::move(piece_name), std::move(traction.value));
}

std::unique_ptr<Contribution> pressure_on(int piece, std::string piece_name, Pressure pressure) {
  return std::make_unique<EdgeLoad>(
      "pressure", piece, std::move(piece_name),
      [value = std::move(pressure.value)](const BoundaryPoint& p, double t) -> Vec2 { return value(p, t) * p.normal; });
}

}  // namespace shoreline
