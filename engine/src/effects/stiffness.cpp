#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "../linear_cell.hpp"
#include "../threads.hpp"
#include "product_moments.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

/// What a cell's points add up to where gradients are linear there: products with m = (1, ξ, η).
struct LinearMoments {
  Mat3 volume;                         ///< Σ V m mᵀ
  Eigen::Matrix<double, 3, 3> stress;  ///< Σ V σ mᵀ, σ = (xx, yy, xy)
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
  sums.stress << s.head<3>(), sx.head<3>(), sy.head<3>();
  return sums;
}

/// Adds Bᵀ D B summed over points, from the moments of their gradients: block (a, b) is linear in Σ V g_a g_bᵀ, (E.5).
/// @param moments     gives Σ V g_a g_bᵀ of two functions, a ≥ b
/// @param lower_half  of a block, column by column
template <int N, class Moments>
void add_stiffness(Moments&& moments, const Mat3& d, double* lower_half) {
  const bool coupled = d(0, 2) != 0.0 || d(1, 2) != 0.0 || d(2, 0) != 0.0 || d(2, 1) != 0.0;  // not in isotropic laws
  double* left = lower_half;  // the two columns of function b, each from its diagonal on
  for (int b = 0; b < N; ++b) {
    double* const right = left + 2 * (N - b);
    for (int a = b; a < N; ++a) {
      const Mat2 m = moments(a, b);
      Mat2 k;
      k(0, 0) = d(0, 0) * m(0, 0) + d(2, 2) * m(1, 1);
      k(0, 1) = d(0, 1) * m(0, 1) + d(2, 2) * m(1, 0);
      k(1, 0) = d(1, 0) * m(1, 0) + d(2, 2) * m(0, 1);
      k(1, 1) = d(1, 1) * m(1, 1) + d(2, 2) * m(0, 0);
      if (coupled) {
        k(0, 0) += d(0, 2) * m(0, 1) + d(2, 0) * m(1, 0);
        k(0, 1) += d(0, 2) * m(0, 0) + d(2, 1) * m(1, 1);
        k(1, 0) += d(1, 2) * m(1, 1) + d(2, 0) * m(0, 0);
        k(1, 1) += d(1, 2) * m(1, 0) + d(2, 1) * m(0, 1);
      }
      const int row = 2 * (a - b);
      left[row] += k(0, 0);
      left[row + 1] += k(1, 0);
      if (row > 0) right[row - 1] += k(0, 1);
      right[row] += k(1, 1);
    }
    left = right + 2 * (N - b) - 1;
  }
}

/// @param sums  (2N, 3) Σ V σ_k g, k = xx, yy, xy
template <int N, class Sums>
void subtract_internal_force(const Sums& sums, double* force) {
  for (int a = 0; a < N; ++a) {
    force[2 * a] -= sums(2 * a, 0) + sums(2 * a + 1, 2);
    force[2 * a + 1] -= sums(2 * a + 1, 1) + sums(2 * a, 2);
  }
}

/// Cells on which gradients are C m: Σ V g gᵀ is C (Σ V m mᵀ) Cᵀ, (E.8), and the basis is evaluated at three places of
/// a cell instead of all its points.
template <int N>
class LinearCells {
 public:
  LinearCells(const StepState& step, const Material& material) : step_(step), d_(material.tangent(Stress::Zero())) {}

  /// @param c      the c-th occupied cell
  /// @param force  null where it is not wanted
  void add(Index c, double* lower_half, double* force) {
    const auto at = static_cast<std::size_t>(c);
    const LinearCell cell(step_.basis, step_.supports.cell[at],
                          step_.supports.place[static_cast<std::size_t>(step_.supports.first[at])]);
    const LinearMoments sums = moments_of(step_, c, cell);
    Eigen::Matrix<double, 2 * N, 3> coefficient(cell.gradient.data());
    coefficient.col(1) -= coefficient.col(0);
    coefficient.col(2) -= coefficient.col(0);

    const Eigen::Matrix<double, 2 * N, 3> weighted = coefficient.lazyProduct(sums.volume);
    const auto moments = [&](int a, int b) -> Mat2 {
      return weighted.template middleRows<2>(2 * a).lazyProduct(coefficient.template middleRows<2>(2 * b).transpose());
    };
    add_stiffness<N>(moments, d_, lower_half);
    if (force == nullptr) return;
    const Eigen::Matrix<double, 2 * N, 3> along = coefficient.lazyProduct(sums.stress.transpose());
    subtract_internal_force<N>(along, force);
  }

 private:
  const StepState& step_;
  Mat3 d_;
};

/// Cells whose functions are products: Σ V g gᵀ and Σ V σ g follow from sums of powers of the points' places, (E.10).
template <int N>
class ProductCells {
 public:
  ProductCells(const StepState& step, const Material& material)
      : step_(step), d_(material.tangent(Stress::Zero())), weight_(static_cast<std::size_t>(step.supports.most)) {}

  void add(Index c, double* lower_half, double* force) {
    const ProductCell cell = *step_.basis.product_cell(step_.supports.cell[static_cast<std::size_t>(c)]);
    std::array<double, (2 * p + 1) * (2 * p + 1)> powers;
    const auto volume = [&](Index point) { return step_.points.volume[point]; };
    sum_powers(2 * p + 1, cell, c, volume, powers.data());
    x_.make(p, cell.x, cell.size.x());
    y_.make(p, cell.y, cell.size.y());
    multiply(p, x_, y_, powers.data(), moments_);
    const auto moments = [&](int a, int b) {
      const PairPlace& at = places[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      Mat2 m;
      m << moments_.xx[static_cast<std::size_t>(at.same)], moments_.xy[static_cast<std::size_t>(at.xy)],
          moments_.xy[static_cast<std::size_t>(at.yx)], moments_.yy[static_cast<std::size_t>(at.same)];
      return m;
    };
    add_stiffness<N>(moments, d_, lower_half);
    if (force != nullptr) subtract_force(cell, c, force);
  }

 private:
  static constexpr int p = N == 9 ? 2 : 3;
  static constexpr auto places = pair_places<p + 1>();
  using Factors = Eigen::Matrix<double, p + 1, p + 1>;  ///< (function, power)

  template <class Weight>
  void sum_powers(int powers, const ProductCell& cell, Index c, Weight&& weight, double* sum) {
    const auto first = static_cast<std::size_t>(step_.supports.first[static_cast<std::size_t>(c)]);
    const auto last = static_cast<std::size_t>(step_.supports.first[static_cast<std::size_t>(c) + 1]);
    for (std::size_t k = first; k < last; ++k) weight_[k - first] = weight(step_.supports.point[k]);
    power_sums(powers, cell, std::span(step_.supports.place).subspan(first, last - first), weight_, sum);
  }

  static Factors slopes(const Factors& factors, double size) {
    Factors slope = Factors::Zero();
    for (int power = 1; power <= p; ++power) slope.col(power - 1) = power / size * factors.col(power);
    return slope;
  }

  void subtract_force(const ProductCell& cell, Index c, double* force) {
    const Factors x(about_middle(p, cell.x).data()), y(about_middle(p, cell.y).data());
    const Factors x_slope = slopes(x, cell.size.x()), y_slope = slopes(y, cell.size.y());
    Eigen::Matrix<double, 2 * N, 3> sums;
    for (const Eigen::Index k : {0, 1, 2}) {
      Factors powers;  // (power of η, power of ξ)
      const auto stress = [&](Index point) { return step_.points.volume[point] * step_.points.stress(k, point); };
      sum_powers(p + 1, cell, c, stress, powers.data());
      const Factors along_x = x_slope.lazyProduct(powers.transpose()).lazyProduct(y.transpose());
      const Factors along_y = x.lazyProduct(powers.transpose()).lazyProduct(y_slope.transpose());
      for (int a = 0; a < N; ++a) {
        sums(2 * a, k) = along_x(a % (p + 1), a / (p + 1));
        sums(2 * a + 1, k) = along_y(a % (p + 1), a / (p + 1));
      }
    }
    subtract_internal_force<N>(sums, force);
  }

  const StepState& step_;
  Mat3 d_;
  FactorPairs x_, y_;
  ProductMoments moments_;
  std::vector<double> weight_;
};

/// Any law on any basis, point by point.
template <int N>
class PointCells {
 public:
  PointCells(const StepState& step, const Material& material)
      : step_(step), material_(material), basis_(step.basis, step.supports) {}

  void add(Index c, double* lower_half, double* force) {
    basis_.evaluate(c);
    const Index last = step_.supports.first[static_cast<std::size_t>(c) + 1];
    for (Index k = step_.supports.first[static_cast<std::size_t>(c)]; k < last; ++k) {
      const Index point = step_.supports.point[static_cast<std::size_t>(k)];
      const double volume = step_.points.volume[point];
      const Eigen::Map<const Eigen::Matrix<double, 2, N>> g(basis_.gradient(k));
      const auto moments = [&](int a, int b) -> Mat2 { return volume * g.col(a) * g.col(b).transpose(); };
      const Stress stress = step_.points.stress.col(point);
      add_stiffness<N>(moments, material_.tangent(stress), lower_half);
      if (force == nullptr) continue;
      const Eigen::Map<const Eigen::Matrix<double, 2 * N, 1>> all(g.data());
      subtract_internal_force<N>(all.lazyProduct((volume * stress.template head<3>()).transpose()), force);
    }
  }

 private:
  const StepState& step_;
  const Material& material_;
  BasisAtPoints basis_;
};

class Stiffness final : public Contribution {
 public:
  explicit Stiffness(std::shared_ptr<const Material> material) : material_(std::move(material)) {}

  [[nodiscard]] std::string name() const override { return material_->name(); }
  [[nodiscard]] std::string needs() const override { return "gradients at the material points, and their stress"; }

  void add(const StepState& step, ElementBlocks& blocks) const override {
    switch (step.supports.functions) {
      case 3:
        return add_cells<3>(step, blocks);
      case 4:
        return add_cells<4>(step, blocks);
      case 9:
        return add_cells<9>(step, blocks);
      case 16:
        return add_cells<16>(step, blocks);
      default:
        throw InvalidArgument("stiffness_of: no kernel for " + std::to_string(step.supports.functions) +
                              " functions a cell");
    }
  }

 private:
  template <int N>
  void add_cells(const StepState& step, ElementBlocks& blocks) const {
    if (!material_->constant_tangent()) return each_cell<PointCells<N>>(step, blocks);
    if (step.basis.gradient_degree() <= 1) return each_cell<LinearCells<N>>(step, blocks);
    if constexpr (N == 9 || N == 16)
      if (step.basis.product_cell(0)) return each_cell<ProductCells<N>>(step, blocks);
    each_cell<PointCells<N>>(step, blocks);
  }

  template <class Cells>
  void each_cell(const StepState& step, ElementBlocks& blocks) const {
    const std::size_t begin = blocks.append(step.supports.cell.size(), step.supports.functions);
#pragma omp parallel if (worth_threads(step.supports.point.size()))
    {
      Cells cells(step, *material_);
#pragma omp for schedule(static)
      for (Index c = 0; c < step.supports.cells(); ++c) {
        const std::size_t block = begin + static_cast<std::size_t>(c);
        const ShortIndices functions = step.basis.functions_of(step.supports.cell[static_cast<std::size_t>(c)]);
        std::ranges::copy(functions, blocks.function.begin() + blocks.first[block]);
        cells.add(c, blocks.matrix.data() + blocks.entry[block],
                  step.loading == Loading::residual ? blocks.force_of(block).data() : nullptr);
      }
    }
  }

  std::shared_ptr<const Material> material_;
};

}  // namespace

std::unique_ptr<Contribution> stiffness_of(std::shared_ptr<const Material> material) {
  return std::make_unique<Stiffness>(std::move(material));
}

}  // namespace shoreline
