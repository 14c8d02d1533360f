#include <algorithm>
#include <span>
#include <vector>

#include "../linear_cell.hpp"
#include "../threads.hpp"
#include "gradient_products.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

/// A cell's block of the stiffness.
template <int N>
using BlockOf = Eigen::Matrix<double, 2 * N, 2 * N>;

/// What a cell's points add up to where gradients are linear there: products with m = (1, ξ, η).
struct LinearMoments {
  Mat3 volume;                         ///< Σ V m mᵀ
  Eigen::Matrix<double, 4, 3> stress;  ///< Σ V σ mᵀ, σ = (xx, yy, xy, zz)
};

LinearMoments moments_of(const StepState& step, Index c, const LinearCell& cell) {
  const auto at = static_cast<std::size_t>(c);
  double v = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  Stress s = Stress::Zero(), sx = Stress::Zero(), sy = Stress::Zero();
  for (auto k = static_cast<std::size_t>(step.supports.first[at]);
       k < static_cast<std::size_t>(step.supports.first[at + 1]); ++k) {
    const Index p = step.supports.point[k];
    const Vec2 xi = cell.local(step.supports.place[k]);
    const double weight = step.points.volume[p];
    const double weight_x = weight * xi.x();
    const double weight_y = weight * xi.y();
    v += weight;
    x += weight_x;
    y += weight_y;
    xx += weight_x * xi.x();
    xy += weight_x * xi.y();
    yy += weight_y * xi.y();
    s += weight * step.points.stress.col(p);
    sx += weight_x * step.points.stress.col(p);
    sy += weight_y * step.points.stress.col(p);
  }
  LinearMoments sums;
  sums.volume << v, x, y, x, xx, xy, y, xy, yy;
  sums.stress << s, sx, sy;
  return sums;
}

/// Bᵀ D B summed over points, from the moments of their gradients: block (a, b) is linear in Σ V g_a g_bᵀ, (E.5).
/// @param moments  gives Σ V g_a g_bᵀ of two functions, a ≥ b
template <int N, class Moments>
void add_stiffness(Moments&& moments, const Mat3& d, BlockOf<N>& stiffness) {
  for (int b = 0; b < N; ++b)
    for (int a = b; a < N; ++a) {
      const Mat2 m = moments(a, b);
      Mat2 k;
      k(0, 0) = d(0, 0) * m(0, 0) + d(0, 2) * m(0, 1) + d(2, 0) * m(1, 0) + d(2, 2) * m(1, 1);
      k(0, 1) = d(0, 1) * m(0, 1) + d(0, 2) * m(0, 0) + d(2, 1) * m(1, 1) + d(2, 2) * m(1, 0);
      k(1, 0) = d(1, 0) * m(1, 0) + d(1, 2) * m(1, 1) + d(2, 0) * m(0, 0) + d(2, 2) * m(0, 1);
      k(1, 1) = d(1, 1) * m(1, 1) + d(1, 2) * m(1, 0) + d(2, 1) * m(0, 1) + d(2, 2) * m(0, 0);
      stiffness.template block<2, 2>(2 * a, 2 * b) += k;
    }
}

/// @param sums  (2N and more, 4) Σ V σ_k g, k = xx, yy, xy, zz
template <int N, class Sums>
void subtract_internal_force(const Sums& sums, Eigen::Map<Eigen::VectorXd> force) {
  for (int a = 0; a < N; ++a) {
    force[2 * a] -= sums(2 * a, 0) + sums(2 * a + 1, 2);
    force[2 * a + 1] -= sums(2 * a + 1, 1) + sums(2 * a, 2);
  }
}

/// What a thread needs for the points of one cell after the other.
struct PointMemory {
  explicit PointMemory(const StepState& step) : basis(step.basis, step.supports) {
    volume.reserve(static_cast<std::size_t>(step.supports.most));
    stress.reserve(4 * static_cast<std::size_t>(step.supports.most));
  }

  BasisAtPoints basis;
  std::vector<double> volume;
  std::vector<double> stress;  ///< (4) times volume, of point after point
};

class Stiffness final : public Contribution {
 public:
  explicit Stiffness(std::shared_ptr<const Material> material) : material_(std::move(material)) {}

  [[nodiscard]] std::string name() const override { return material_->name(); }
  [[nodiscard]] std::string needs() const override { return "gradients at the material points, and their stress"; }

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
    const bool linear = material_->constant_tangent() && step.basis.gradient_degree() <= 1;
#pragma omp parallel if (worth_threads(step.supports.point.size()))
    {
      PointMemory memory(step);
#pragma omp for schedule(static)
      for (Index c = 0; c < step.supports.cells(); ++c) {
        const std::size_t block = begin + static_cast<std::size_t>(c);
        const ShortIndices functions = step.basis.functions_of(step.supports.cell[static_cast<std::size_t>(c)]);
        std::ranges::copy(functions, blocks.function.begin() + blocks.first[block]);
        if (linear)
          add_linear_cell<N>(step, c, block, blocks);
        else
          add_cell<N>(step, c, block, memory, blocks);
      }
    }
  }

  /// With gradients C m, Σ V g gᵀ is C (Σ V m mᵀ) Cᵀ: the basis is evaluated at three places of a cell instead of all
  /// its points.
  template <int N>
  void add_linear_cell(const StepState& step, Index c, std::size_t block, ElementBlocks& blocks) const {
    const auto at = static_cast<std::size_t>(c);
    const LinearCell cell(step.basis, step.supports.cell[at],
                          step.supports.place[static_cast<std::size_t>(step.supports.first[at])]);
    const LinearMoments sums = moments_of(step, c, cell);
    Eigen::Matrix<double, 2 * N, 3> coefficient(cell.gradient.data());
    coefficient.col(1) -= coefficient.col(0);
    coefficient.col(2) -= coefficient.col(0);

    const Eigen::Matrix<double, 2 * N, 3> weighted = coefficient.lazyProduct(sums.volume);
    const auto moments = [&](int a, int b) -> Mat2 {
      return weighted.template middleRows<2>(2 * a).lazyProduct(coefficient.template middleRows<2>(2 * b).transpose());
    };
    BlockOf<N> stiffness = BlockOf<N>::Zero();
    add_stiffness<N>(moments, material_->tangent(Stress::Zero()), stiffness);
    blocks.add(block, stiffness);
    if (step.loading != Loading::residual) return;
    const Eigen::Matrix<double, 2 * N, 4> along = coefficient.lazyProduct(sums.stress.transpose());
    subtract_internal_force<N>(along, blocks.force_of(block));
  }

  template <int N>
  void add_cell(const StepState& step, Index c, std::size_t block, PointMemory& memory, ElementBlocks& blocks) const {
    const Index first = step.supports.first[static_cast<std::size_t>(c)];
    const Index last = step.supports.first[static_cast<std::size_t>(c) + 1];
    memory.basis.evaluate(c);
    const double* const gradient = memory.basis.gradient(first);
    memory.volume.clear();
    for (Index k = first; k < last; ++k)
      memory.volume.push_back(step.points.volume[step.supports.point[static_cast<std::size_t>(k)]]);

    GradientMoments<N> moments = GradientMoments<N>::Zero();
    BlockOf<N> stiffness = BlockOf<N>::Zero();
    const auto moments_of = [&](int a, int b) -> Mat2 { return moments.template block<2, 2>(2 * a, 2 * b); };
    if (material_->constant_tangent()) {
      add_products(N, memory.volume, gradient, moments.data());
      add_stiffness<N>(moments_of, material_->tangent(Stress::Zero()), stiffness);
    } else {
      for (Index k = first; k < last; ++k) {
        const std::span<const double> own(&memory.volume[static_cast<std::size_t>(k - first)], 1);
        moments.setZero();
        add_products(N, own, memory.basis.gradient(k), moments.data());
        const Index p = step.supports.point[static_cast<std::size_t>(k)];
        add_stiffness<N>(moments_of, material_->tangent(step.points.stress.col(p)), stiffness);
      }
    }
    blocks.add(block, stiffness);
    if (step.loading != Loading::residual) return;

    memory.stress.clear();
    for (Index k = first; k < last; ++k) {
      const Index p = step.supports.point[static_cast<std::size_t>(k)];
      const Stress weighted = step.points.volume[p] * step.points.stress.col(p);
      memory.stress.insert(memory.stress.end(), weighted.begin(), weighted.end());
    }
    GradientSums<N> sums = GradientSums<N>::Zero();
    add_sums(N, memory.stress, gradient, sums.data());
    subtract_internal_force<N>(sums, blocks.force_of(block));
  }

  std::shared_ptr<const Material> material_;
};

}  // namespace

std::unique_ptr<Contribution> stiffness_of(std::shared_ptr<const Material> material) {
  return std::make_unique<Stiffness>(std::move(material));
}

}  // namespace shoreline
