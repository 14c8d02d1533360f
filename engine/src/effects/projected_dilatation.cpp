#include <cassert>

#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

class DilatationEnergy final : public Contribution {
 public:
  [[nodiscard]] std::string name() const override { return "projected_dilatation"; }
  [[nodiscard]] std::string needs() const override { return "gradients at the material points by groups of cells"; }

  void add(const StepState& step, ElementBlocks& blocks) const override {
    assert(step.dilatation != nullptr);
    const double lambda = step.dilatation->lambda();
    for (const DilatationPatch& patch : step.dilatation->patches()) {
      const std::size_t block = blocks.append(patch.functions);
      blocks.add(block, Eigen::MatrixXd(lambda * patch.divergence.transpose() * patch.divergence));
      blocks.force_of(block) -= lambda * patch.divergence.transpose() * patch.prescribed;
    }
  }
};

}  // namespace

std::unique_ptr<Contribution> projected_dilatation() { return std::make_unique<DilatationEnergy>(); }

}  // namespace shoreline
