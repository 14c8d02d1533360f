#include "shoreline/engine/linear_solver.hpp"

#include <cholmod.h>
#include <fmt/format.h>
#include <umfpack.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

extern "C" {
void openblas_set_num_threads(int threads);
char* openblas_get_config();
void dpotrf_(const char* triangle, const int* n, double* matrix, const int* rows, int* fault);
}

namespace shoreline {
namespace {

constexpr double smallest_usable_pivot = 1e-15;
constexpr double smallest_usable_lu =
    1e-12;  ///< of its pivots, over the largest: below, a sign may be that of rounding

/// y = A x from the lower half of A.
Eigen::VectorXd multiply(const SparseMatrix& a, const Eigen::VectorXd& x) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(a.size);
  for (Index j = 0; j < a.size; ++j)
    for (Index k = a.column[static_cast<std::size_t>(j)]; k < a.column[static_cast<std::size_t>(j) + 1]; ++k) {
      const Index i = a.row[static_cast<std::size_t>(k)];
      const double v = a.value[static_cast<std::size_t>(k)];
      y[i] += v * x[j];
      if (i != j) y[j] += v * x[i];
    }
  return y;
}

/// Largest column sum of |A|, from the lower half of A.
double norm1(const SparseMatrix& a) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(a.size);
  for (Index j = 0; j < a.size; ++j)
    for (Index k = a.column[static_cast<std::size_t>(j)]; k < a.column[static_cast<std::size_t>(j) + 1]; ++k) {
      const Index i = a.row[static_cast<std::size_t>(k)];
      const double v = std::abs(a.value[static_cast<std::size_t>(k)]);
      sum[j] += v;
      if (i != j) sum[i] += v;
    }
  return sum.maxCoeff();
}

/// Both halves of a matrix, for UMFPACK.
SparseMatrix full(const SparseMatrix& lower) {
  SparseMatrix a;
  a.size = lower.size;
  a.column.assign(static_cast<std::size_t>(lower.size) + 1, 0);
  const auto each = [&](auto&& use) {
    for (Index j = 0; j < lower.size; ++j)
      for (Index k = lower.column[static_cast<std::size_t>(j)]; k < lower.column[static_cast<std::size_t>(j) + 1];
           ++k) {
        const Index i = lower.row[static_cast<std::size_t>(k)];
        if (i != j) use(i, j, lower.value[static_cast<std::size_t>(k)]);
        use(j, i, lower.value[static_cast<std::size_t>(k)]);
      }
  };
  each([&](Index column, Index, double) { ++a.column[static_cast<std::size_t>(column) + 1]; });
  for (std::size_t j = 0; j < static_cast<std::size_t>(a.size); ++j) a.column[j + 1] += a.column[j];
  a.row.resize(static_cast<std::size_t>(a.column.back()));
  a.value.resize(a.row.size());
  std::vector<Index> next(a.column.begin(), a.column.end() - 1);
  each([&](Index column, Index row, double v) {
    const auto k = static_cast<std::size_t>(next[static_cast<std::size_t>(column)]++);
    a.row[k] = row;
    a.value[k] = v;
  });
  return a;
}

}  // namespace

SingularMatrix::SingularMatrix(Index equation, double pivot)
    : Error(fmt::format("singular matrix: pivot {:.2g} of the scaled matrix at equation {}", pivot, equation)),
      equation_(equation),
      pivot_(pivot) {}

struct LinearSolver::Factors {
  mutable cholmod_common common;
  cholmod_factor* cholesky = nullptr;
  void* lu = nullptr;      // UMFPACK's, where Cholesky fails
  SparseMatrix lu_matrix;  // both halves, which UMFPACK's solve reads again
  SparseMatrix scaled;     // unit diagonal, lower half
  Eigen::VectorXd scale;   // 1/√|K_ii|
  bool definite = false;   // else the factors are UMFPACK's
  double smallest = 0.0;   // pivot
  Index weakest = 0;       // its equation

  Factors() {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.postorder = 1;
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
  }
  ~Factors() {
    release_lu();
    cholmod_free_factor(&cholesky, &common);
    cholmod_finish(&common);
  }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;

  void release_lu() {
    if (lu != nullptr) umfpack_di_free_numeric(&lu);
    lu = nullptr;
  }

  /// CHOLMOD's view of a matrix; nothing is copied.
  static cholmod_sparse view(const SparseMatrix& a) {
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

  void scale_by_diagonal(const SparseMatrix& matrix) {
    scaled = matrix;
    scale.resize(matrix.size);
    for (Index j = 0; j < matrix.size; ++j) {
      const double diagonal = matrix.value[static_cast<std::size_t>(matrix.column[static_cast<std::size_t>(j)])];
      if (diagonal == 0.0 || !std::isfinite(diagonal)) throw SingularMatrix(j, diagonal);
      scale[j] = 1.0 / std::sqrt(std::abs(diagonal));
    }
    for (Index j = 0; j < matrix.size; ++j)
      for (auto k = static_cast<std::size_t>(matrix.column[static_cast<std::size_t>(j)]);
           k < static_cast<std::size_t>(matrix.column[static_cast<std::size_t>(j) + 1]); ++k)
        scaled.value[k] *= scale[j] * scale[scaled.row[k]];
  }

  /// The smallest squared diagonal entry of the supernodal factor, and its equation.
  [[nodiscard]] std::pair<double, Index> find_smallest_pivot() const {
    const auto* super = static_cast<const int*>(cholesky->super);
    const auto* rows = static_cast<const int*>(cholesky->pi);
    const auto* start = static_cast<const int*>(cholesky->px);
    const auto* values = static_cast<const double*>(cholesky->x);
    const auto* order = static_cast<const int*>(cholesky->Perm);
    std::pair<double, Index> found{std::numeric_limits<double>::infinity(), -1};
    for (std::size_t s = 0; s < cholesky->nsuper; ++s)
      for (int j = super[s]; j < super[s + 1]; ++j) {
        const double l = values[start[s] + (j - super[s]) * (rows[s + 1] - rows[s] + 1)];
        if (l * l < found.first) found = {l * l, order[j]};
      }
    return found;
  }

  void factorize_unsymmetric() {
    lu_matrix = full(scaled);
    void* symbolic = nullptr;
    std::array<double, UMFPACK_INFO> info{};
    umfpack_di_symbolic(lu_matrix.size, lu_matrix.size, lu_matrix.column.data(), lu_matrix.row.data(),
                        lu_matrix.value.data(), &symbolic, nullptr, nullptr);
    const int status = umfpack_di_numeric(lu_matrix.column.data(), lu_matrix.row.data(), lu_matrix.value.data(),
                                          symbolic, &lu, nullptr, info.data());
    umfpack_di_free_symbolic(&symbolic);
    if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
    if (status != UMFPACK_OK || info[UMFPACK_RCOND] < smallest_usable_lu)
      throw SingularMatrix(weakest, info[UMFPACK_RCOND]);
  }

  [[nodiscard]] Eigen::VectorXd apply_inverse(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x(b.size());
    if (lu != nullptr) {
      umfpack_di_solve(UMFPACK_A, lu_matrix.column.data(), lu_matrix.row.data(), lu_matrix.value.data(), x.data(),
                       b.data(), lu, nullptr, nullptr);
      return x;
    }
    cholmod_dense right{};
    right.nrow = right.nzmax = right.d = static_cast<std::size_t>(b.size());
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, cholesky, &right, &common);
    if (solution == nullptr) throw std::bad_alloc();
    x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution->x), b.size());
    cholmod_free_dense(&solution, &common);
    return x;
  }
};

LinearSolver::LinearSolver() : factors_(std::make_unique<Factors>()) {}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

void LinearSolver::analyse(const SparseMatrix& matrix) {
  Factors& f = *factors_;
  cholmod_free_factor(&f.cholesky, &f.common);
  cholmod_sparse a = Factors::view(matrix);
  f.cholesky = cholmod_analyze(&a, &f.common);
  if (f.cholesky == nullptr) throw std::bad_alloc();
}

void LinearSolver::factorize(const SparseMatrix& matrix, double shift) {
  Factors& f = *factors_;
  f.release_lu();
  f.definite = true;
  f.smallest = 0.0;
  f.scale_by_diagonal(matrix);
  cholmod_sparse a = Factors::view(f.scaled);
  std::array<double, 2> beta{shift, 0.0};
  cholmod_factorize_p(&a, beta.data(), nullptr, 0, f.cholesky, &f.common);
  if (f.common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  if (f.common.status == CHOLMOD_NOT_POSDEF) {
    f.definite = false;
    f.weakest = static_cast<const int*>(f.cholesky->Perm)[f.cholesky->minor];
    if (shift > 0.0) throw SingularMatrix(f.weakest, 0.0);
    return f.factorize_unsymmetric();
  }
  std::tie(f.smallest, f.weakest) = f.find_smallest_pivot();
  if (f.smallest < smallest_usable_pivot) throw SingularMatrix(f.weakest, f.smallest);
}

Eigen::VectorXd LinearSolver::solve(const Eigen::VectorXd& right_hand_side) const {
  return refined(right_hand_side, refined(right_hand_side, Eigen::VectorXd::Zero(right_hand_side.size())));
}

Eigen::VectorXd LinearSolver::refined(const Eigen::VectorXd& right_hand_side, const Eigen::VectorXd& x) const {
  const Factors& f = *factors_;
  const Eigen::VectorXd scaled = x.cwiseQuotient(f.scale);
  const Eigen::VectorXd rest = f.scale.cwiseProduct(right_hand_side) - multiply(f.scaled, scaled);
  return x + f.scale.cwiseProduct(f.apply_inverse(rest));
}

double LinearSolver::smallest_pivot() const { return factors_->smallest; }

bool LinearSolver::positive_definite() const { return factors_->definite; }

Index LinearSolver::smallest_pivot_equation() const { return factors_->weakest; }

double LinearSolver::condition_estimate() const {
  const Factors& f = *factors_;
  const Eigen::Index n = f.scale.size();
  Eigen::VectorXd x = Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
  double estimate = 0.0;
  for (int iteration = 0; iteration < 5; ++iteration) {  // ‖A⁻¹‖₁ from below: climb over the vertices of the unit ball
    const Eigen::VectorXd y = f.apply_inverse(x);
    if (y.lpNorm<1>() <= estimate) break;
    estimate = y.lpNorm<1>();
    const Eigen::VectorXd z = f.apply_inverse(y.unaryExpr([](double v) { return v < 0.0 ? -1.0 : 1.0; }));
    Eigen::Index steepest = 0;
    if (z.cwiseAbs().maxCoeff(&steepest) <= z.dot(x)) break;
    x = Eigen::VectorXd::Unit(n, steepest);
  }
  return estimate * norm1(f.scaled);
}

void set_blas_threads(int threads) {
  openblas_set_num_threads(threads);
  // OpenBLAS waits for ever for work space that the system refuses; so it takes it here, where there still is some
  const int one = 1;
  double matrix = 1.0;
  int fault = 0;
  dpotrf_("L", &one, &matrix, &one, &fault);
}

std::string blas_name() { return openblas_get_config(); }

}  // namespace shoreline
