#include <algorithm>

#include "../threads.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

/// Σ V g gᵀ over some points of one cell, g = (∂x φ_1, ∂y φ_1, ∂x φ_2, …): all that a constant tangent needs to know.
template <int N>
using GradientMoments = Eigen::Matrix<double, 2 * N, 2 * N>;

/// Bᵀ D B summed over points, from the moments of their gradients: block (a, b) is linear in Σ V g_a g_bᵀ, (E.5).
template <int N>
void add_stiffness(const GradientMoments<N>& moments, const Mat3& d, Eigen::Matrix<double, 2 * N, 2 * N>& stiffness) {
  for (int b = 0; b < N; ++b)
    for (int a = b; a < N; ++a) {
      const Mat2 m = moments.template block<2, 2>(2 * a, 2 * b);
      Mat2 k;
      k(0, 0) = d(0, 0) * m(0, 0) + d(0, 2) * m(0, 1) + d(2, 0) * m(1, 0) + d(2, 2) * m(1, 1);
      k(0, 1) = d(0, 1) * m(0, 1) + d(0, 2) * m(0, 0) + d(2, 1) * m(1, 1) + d(2, 2) * m(1, 0);
      k(1, 0) = d(1, 0) * m(1, 0) + d(1, 2) * m(1, 1) + d(2, 0) * m(0, 0) + d(2, 2) * m(0, 1);
      k(1, 1) = d(1, 1) * m(1, 1) + d(1, 2) * m(1, 0) + d(2, 1) * m(0, 1) + d(2, 2) * m(0, 0);
      stiffness.template block<2, 2>(2 * a, 2 * b) += k;
    }
}

class Stiffness final : public Contribution {
 public:
  explicit Stiffness(std::shared_ptr<const Material> material) : material_(std::move(material)) {}

  [[nodiscard]] std::string name() const override { return material_->name(); }

  void add(const StepState& step, ElementBlocks& blocks) const override {
    const std::size_t begin = blocks.append(step.supports.cell.size(), step.supports.functions);
    switch (step.supports.functions) {
      case 3:
        return add_cells<3>(step, begin, blocks);
      case 4:
        return add_cells<4>(step, begin, blocks);
      case 9:
        return add_cells<9>(step, begin, blocks);
      case 16:
        return add_cells<16>(step, begin, blocks);
      default:
        throw InvalidArgument("stiffness_of: no kernel for " + std::to_string(step.supports.functions) +
                              " functions a cell");
    }
  }

 private:
  template <int N>
  void add_cells(const StepState& step, std::size_t begin, ElementBlocks& blocks) const {
#pragma omp parallel for schedule(static) if (worth_threads(step.supports.point.size()))
    for (Index c = 0; c < step.supports.cells(); ++c)
      add_cell<N>(step, static_cast<std::size_t>(c), begin + static_cast<std::size_t>(c), blocks);
  }

  template <int N>
  void add_cell(const StepState& step, std::size_t c, std::size_t block, ElementBlocks& blocks) const {
    using Gradients = Eigen::Matrix<double, 2 * N, 1>;
    const bool once_a_cell = material_->constant_tangent();
    const bool internal_force = step.loading == Loading::residual;
    const ShortIndices functions = step.basis.functions_of(step.supports.cell[c]);
    std::ranges::copy(functions, blocks.function.begin() + blocks.first[block]);
    GradientMoments<N> moments = GradientMoments<N>::Zero();
    Eigen::Matrix<double, 2 * N, 2 * N> stiffness = Eigen::Matrix<double, 2 * N, 2 * N>::Zero();
    Gradients force = Gradients::Zero();
    for (auto k = static_cast<std::size_t>(step.supports.first[c]);
         k < static_cast<std::size_t>(step.supports.first[c + 1]); ++k) {
      const Index p = step.supports.point[k];
      const Eigen::Map<const Gradients> g(&step.supports.gradient[k * 2 * N]);
      const double volume = step.points.volume[p];
      moments.noalias() += (volume * g) * g.transpose();
      if (!once_a_cell) {
        add_stiffness<N>(moments, material_->tangent(step.points.stress.col(p)), stiffness);
        moments.setZero();
      }
      if (internal_force) {
        const auto s = step.points.stress.col(p);
        for (int a = 0; a < N; ++a) {
          force[2 * a] -= volume * (g[2 * a] * s[0] + g[2 * a + 1] * s[2]);
          force[2 * a + 1] -= volume * (g[2 * a + 1] * s[1] + g[2 * a] * s[2]);
        }
      }
    }
    if (once_a_cell) add_stiffness<N>(moments, material_->tangent(Stress::Zero()), stiffness);
    blocks.add(block, stiffness);
    blocks.force_of(block) += force;
  }

  std::shared_ptr<const Material> material_;
};

}  // namespace

std::unique_ptr<Contribution> stiffness_of(std::shared_ptr<const Material> material) {
  return std::make_unique<Stiffness>(std::move(material));
}

}  // namespace shoreline
