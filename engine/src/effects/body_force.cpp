#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

class BodyForce final : public Contribution {
 public:
  explicit BodyForce(std::function<Vec2(const PlaceTime&)> value) : value_(std::move(value)) {}

  [[nodiscard]] std::string name() const override { return "body_force"; }
  [[nodiscard]] std::string needs() const override { return "values at the material points"; }

  void add(const StepState& step, ElementBlocks& blocks) const override {
    Eigen::Matrix2Xd force = Eigen::Matrix2Xd::Zero(2, step.basis.functions());
    BasisAtPoints basis(step.basis, step.supports, Evaluate::values);
    for (Index c = 0; c < step.supports.cells(); ++c) {
      const auto cell = static_cast<std::size_t>(c);
      const ShortIndices functions = step.basis.functions_of(step.supports.cell[cell]);
      basis.evaluate(c);
      for (Index k = step.supports.first[cell]; k < step.supports.first[cell + 1]; ++k) {
        const Vec2 at_point = force_of(step, step.supports.point[static_cast<std::size_t>(k)]);
        for (Eigen::Index a = 0; a < functions.size(); ++a) force.col(functions[a]) += basis.value(k)[a] * at_point;
      }
    }
    for (Index f = 0; f < step.basis.functions(); ++f)
      if (!force.col(f).isZero(0.0)) blocks.force_of(blocks.append(std::array{f})) += force.col(f);
  }

  void accept(const StepState& step, const Eigen::Matrix2Xd& /*increment*/) override {
    if (step.loading == Loading::residual) total_.setZero();
    for (Index p = 0; p < step.points.size(); ++p) total_ += resultant(step.points.position.col(p), force_of(step, p));
  }

  void report(Resultants& resultants) const override { resultants.loads[name()] = total_; }

 private:
  [[nodiscard]] Vec2 force_of(const StepState& step, Index p) const {
    const Vec2 x = step.points.position.col(p);
    const Vec2 origin = x - step.points.displacement.col(p);
    return step.points.volume[p] * step.load([&](double t) -> Vec2 { return value_({x, origin, t}); });
  }

  std::function<Vec2(const PlaceTime&)> value_;
  Vec3 total_ = Vec3::Zero();
};

}  // namespace

std::unique_ptr<Contribution> body_force(std::function<Vec2(const PlaceTime&)> value) {
  return std::make_unique<BodyForce>(std::move(value));
}

}  // namespace shoreline
