#include <map>
#include <utility>

#include "../ghost_faces.hpp"
#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

class GhostPenalty final : public Contribution {
 public:
  GhostPenalty(double gamma, std::shared_ptr<const Material> material)
      : gamma_(gamma), material_(std::move(material)) {}

  [[nodiscard]] std::string name() const override { return "ghost_penalty"; }
  [[nodiscard]] std::string needs() const override {
    return "derivatives of the highest order across faces at the edge";
  }

  void add(const StepState& step, ElementBlocks& blocks) const override {
    for (const Face& face : faces(step)) {
      const FaceJumps jumps = jumps_at(step, face, gamma_ * material_->stiffness());
      const std::size_t block = blocks.append(jumps.functions);
      const auto n = static_cast<Eigen::Index>(jumps.functions.size());
      Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * n, 2 * n);
      const auto carried = carried_.find({face.cell, face.neighbour});
      for (std::size_t q = 0; q < jumps.jump.size(); ++q) {
        const Eigen::MatrixXd squared = jumps.weight[q] * jumps.jump[q].transpose() * jumps.jump[q];
        for (Eigen::Index a = 0; a < n; ++a) {
          for (Eigen::Index b = 0; b < n; ++b) stiffness.block<2, 2>(2 * a, 2 * b).diagonal().array() += squared(a, b);
          if (carried != carried_.end())
            blocks.force_of(block).segment<2>(2 * a) -= jumps.weight[q] * jumps.jump[q][a] * carried->second[q];
        }
      }
      blocks.add(block, stiffness);
    }
  }

  void accept(const StepState& step, const Eigen::Matrix2Xd& increment) override {
    if (step.loading == Loading::incremental) return;
    for (const Face& face : faces(step)) {
      const FaceJumps jumps = jumps_at(step, face, 1.0);
      auto& carried = carried_[{face.cell, face.neighbour}];
      carried.resize(jumps.jump.size(), Vec2::Zero());
      for (std::size_t q = 0; q < jumps.jump.size(); ++q)
        for (std::size_t a = 0; a < jumps.functions.size(); ++a)
          carried[q] += jumps.jump[q][static_cast<Eigen::Index>(a)] * increment.col(jumps.functions[a]);
    }
  }

 private:
  static std::vector<Face> faces(const StepState& step) {
    return faces_at_boundary(step.basis.grid(), step.supports.active, step.edges);
  }
  static FaceJumps jumps_at(const StepState& step, const Face& face, double scale) {
    return face_jumps(step.basis, face, scale, 2 * step.basis.degree() - 1);
  }

  double gamma_;
  std::shared_ptr<const Material> material_;
  std::map<std::pair<Index, Index>, std::vector<Vec2>> carried_;  ///< jump of ∂ₙᵖ u so far, (G.2); residual loading
};

}  // namespace

std::unique_ptr<Contribution> ghost_penalty(double gamma, std::shared_ptr<const Material> material) {
  return std::make_unique<GhostPenalty>(gamma, std::move(material));
}

}  // namespace shoreline
