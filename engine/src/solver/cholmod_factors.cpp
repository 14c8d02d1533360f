#include "cholmod_factors.hpp"

#include <cholmod.h>

#include <array>
#include <limits>
#include <new>

namespace shoreline {
namespace {

/// CHOLMOD's view of a matrix; nothing is copied.
cholmod_sparse view(const SparseMatrix& a) {
  cholmod_sparse v{};
  v.nrow = v.ncol = static_cast<std::size_t>(a.size);
  v.nzmax = a.row.size();
  v.p = const_cast<Index*>(a.column.data());
  v.i = const_cast<Index*>(a.row.data());
  v.x = const_cast<double*>(a.value.data());
  v.stype = -1;
  v.itype = CHOLMOD_INT;
  v.xtype = CHOLMOD_REAL;
  v.dtype = CHOLMOD_DOUBLE;
  v.sorted = v.packed = 1;
  return v;
}

class CholmodFactors final : public Factors {
 public:
  CholmodFactors() {
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_AMD;
    common_.postorder = 1;
    common_.print = 0;
    common_.quick_return_if_not_posdef = 1;
  }
  ~CholmodFactors() override {
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  CholmodFactors(const CholmodFactors&) = delete;
  CholmodFactors& operator=(const CholmodFactors&) = delete;

  void analyse(const SparseMatrix& matrix) override {
    cholmod_free_factor(&factor_, &common_);
    cholmod_sparse a = view(matrix);
    factor_ = cholmod_analyze(&a, &common_);
    if (factor_ == nullptr) throw std::bad_alloc();
  }

  std::optional<Index> factorize(const ScaledMatrix& scaled, double shift) override {
    cholmod_sparse a = view(scaled.matrix);
    std::array<double, 2> beta{shift, 0.0};
    cholmod_factorize_p(&a, beta.data(), nullptr, 0, factor_, &common_);
    if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (common_.status == CHOLMOD_NOT_POSDEF) return static_cast<const int*>(factor_->Perm)[factor_->minor];
    return std::nullopt;
  }

  [[nodiscard]] Eigen::VectorXd apply_inverse(const Eigen::VectorXd& b) const override {
    cholmod_dense right{};
    right.nrow = right.nzmax = right.d = static_cast<std::size_t>(b.size());
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor_, &right, &common_);
    if (solution == nullptr) throw std::bad_alloc();
    Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution->x), b.size());
    cholmod_free_dense(&solution, &common_);
    return x;
  }

  /// The smallest squared diagonal entry of the supernodal factor.
  [[nodiscard]] std::optional<Pivot> smallest_pivot() const override {
    const auto* super = static_cast<const int*>(factor_->super);
    const auto* rows = static_cast<const int*>(factor_->pi);
    const auto* start = static_cast<const int*>(factor_->px);
    const auto* values = static_cast<const double*>(factor_->x);
    const auto* order = static_cast<const int*>(factor_->Perm);
    Pivot found{std::numeric_limits<double>::infinity(), -1};
    for (std::size_t s = 0; s < factor_->nsuper; ++s)
      for (int j = super[s]; j < super[s + 1]; ++j) {
        const double l = values[start[s] + (j - super[s]) * (rows[s + 1] - rows[s] + 1)];
        if (l * l < found.value) found = {l * l, order[j]};
      }
    return found;
  }

  [[nodiscard]] double bytes() const override {
    return 8.0 * static_cast<double>(factor_->xsize) + 4.0 * static_cast<double>(factor_->ssize);
  }

 private:
  mutable cholmod_common common_;
  cholmod_factor* factor_ = nullptr;
};

}  // namespace

std::unique_ptr<Factors> make_cholmod_factors() { return std::make_unique<CholmodFactors>(); }

}  // namespace shoreline
