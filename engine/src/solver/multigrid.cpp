// The component of multigrid: conjugate gradients of PETSc, preconditioned by smoothed aggregation (GAMG).

#include <petscksp.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>

#include "both_halves.hpp"
#include "multigrid_component.hpp"

namespace shoreline {
namespace {

/// Of the residual, per application: a solution is two of them, so 1e-12.
constexpr double tolerance = 1e-6;
constexpr int most_iterations = 500;

void check(PetscErrorCode code) {
  if (code == PETSC_ERR_MEM) throw std::bad_alloc();
  if (code != 0) throw Error("PETSc: error " + std::to_string(code) + " in the multigrid solver");
}

/// Starts PETSc, once in a process: no arguments, files of options, signal handlers or other processes.
void start_petsc() {
  static const bool started = [] {
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_btl", "self", 0);
    setenv("OMPI_MCA_opal_signal", "", 0);
    for (const auto& [option, value] : {std::pair{"-no_signal_handler", "true"}, std::pair{"-skip_petscrc", "true"},
                                        std::pair{"-shoreline_mg_levels_pc_type", "icc"}})
      check(PetscOptionsSetValue(nullptr, option, value));
    check(PetscInitializeNoArguments());
    check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
    return std::atexit([] { PetscFinalize(); }) == 0;
  }();
  static_cast<void>(started);
}

class Multigrid final : public Factors {
 public:
  explicit Multigrid(Unknowns unknowns) : unknowns_(std::move(unknowns)) { start_petsc(); }
  ~Multigrid() override {
    KSPDestroy(&solver_);
    MatDestroy(&matrix_);
  }
  Multigrid(const Multigrid&) = delete;
  Multigrid& operator=(const Multigrid&) = delete;

  void analyse(const SparseMatrix& matrix) override {
    number_rows();
    KSPDestroy(&solver_);
    MatDestroy(&matrix_);
    padded_ = both_halves(padded(matrix));
  }

  std::optional<Index> factorize(const ScaledMatrix& scaled, double shift) override {
    SparseMatrix lower = padded(scaled.matrix);
    for (Index j = 0; j < lower.size; ++j)
      lower.value[static_cast<std::size_t>(lower.column[static_cast<std::size_t>(j)])] += shift;
    if (solver_ == nullptr) make_solver();
    double* values = nullptr;
    check(MatSeqAIJGetArray(matrix_, &values));
    std::ranges::copy(both_halves(lower).value, values);
    check(MatSeqAIJRestoreArray(matrix_, &values));
    set_rigid_motions(scaled.scale);
    check(KSPSetOperators(solver_, matrix_, matrix_));
    check(KSPSetUp(solver_));
    iterations_ = 0;
    return std::nullopt;
  }

  [[nodiscard]] Eigen::VectorXd apply_inverse(const Eigen::VectorXd& b) const override {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(padded_.size);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(padded_.size);
    for (Eigen::Index e = 0; e < b.size(); ++e) right[row_[static_cast<std::size_t>(e)]] = b[e];
    if (right.norm() > 0.0) iterate(right, x);
    Eigen::VectorXd solution(b.size());
    for (Eigen::Index e = 0; e < b.size(); ++e) solution[e] = x[row_[static_cast<std::size_t>(e)]];
    return solution;
  }

  [[nodiscard]] std::optional<Pivot> smallest_pivot() const override { return std::nullopt; }

  [[nodiscard]] double bytes() const override {
    PC multigrid = nullptr;
    PetscReal complexity = 0.0;
    check(KSPGetPC(solver_, &multigrid));
    PetscReal operators = 0.0;
    check(PCMGGetGridComplexity(multigrid, &complexity, &operators));
    constexpr double with_smoother = 1.5;  // an incomplete Cholesky factor is as large as half a matrix
    return 12.0 * with_smoother * complexity * static_cast<double>(padded_.row.size());
  }

  [[nodiscard]] std::optional<long> iterations() const override { return iterations_; }

 private:
  /// Two rows for every place that has an equation; the row of a component that is held stands alone.
  void number_rows() {
    row_.resize(static_cast<std::size_t>(unknowns_.component.size()));
    node_.clear();
    for (Index e = 0; e < unknowns_.component.size(); ++e) {
      const bool follows = e > 0 && unknowns_.component[e] == 1 && unknowns_.component[e - 1] == 0 &&
                           unknowns_.place.col(e) == unknowns_.place.col(e - 1);
      if (!follows) node_.emplace_back(unknowns_.place.col(e));
      row_[static_cast<std::size_t>(e)] = 2 * static_cast<Index>(node_.size() - 1) + unknowns_.component[e];
    }
  }

  /// The matrix with a unit diagonal in rows that stand alone.
  [[nodiscard]] SparseMatrix padded(const SparseMatrix& matrix) const {
    SparseMatrix to{.size = 2 * static_cast<Index>(node_.size()), .column = {0}, .row = {}, .value = {}};
    to.row.reserve(matrix.row.size() + 2 * node_.size());
    to.value.reserve(matrix.row.size() + 2 * node_.size());
    for (Index e = 0; e <= matrix.size; ++e) {
      const Index row = e < matrix.size ? row_[static_cast<std::size_t>(e)] : to.size;
      while (static_cast<Index>(to.column.size()) - 1 < row) {
        to.row.push_back(static_cast<Index>(to.column.size()) - 1);
        to.value.push_back(1.0);
        to.column.push_back(static_cast<Index>(to.row.size()));
      }
      if (e == matrix.size) break;
      for (auto k = static_cast<std::size_t>(matrix.column[static_cast<std::size_t>(e)]);
           k < static_cast<std::size_t>(matrix.column[static_cast<std::size_t>(e) + 1]); ++k) {
        to.row.push_back(row_[static_cast<std::size_t>(matrix.row[k])]);
        to.value.push_back(matrix.value[k]);
      }
      to.column.push_back(static_cast<Index>(to.row.size()));
    }
    return to;
  }

  void make_solver() {
    check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, padded_.size, padded_.size, padded_.column.data(),
                                    padded_.row.data(), padded_.value.data(), &matrix_));
    check(MatSetBlockSize(matrix_, 2));
    check(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
    check(KSPCreate(PETSC_COMM_SELF, &solver_));
    check(KSPSetType(solver_, KSPCG));
    check(KSPSetNormType(solver_, KSP_NORM_UNPRECONDITIONED));
    check(KSPSetTolerances(solver_, tolerance, 0.0, 1e10, most_iterations));
    PC multigrid = nullptr;
    check(KSPGetPC(solver_, &multigrid));
    check(PCSetType(multigrid, PCGAMG));
    check(PCGAMGSetReuseInterpolation(multigrid, PETSC_TRUE));
    check(KSPSetOptionsPrefix(solver_, "shoreline_"));
    check(KSPSetFromOptions(solver_));
  }

  /// Translations and the rotation in the scaled unknowns; bases reproduce linear fields by their control points.
  void set_rigid_motions(const Eigen::VectorXd& scale) {
    std::array<Vec, 3> motion{};
    for (Vec& m : motion) {
      check(VecCreateSeq(PETSC_COMM_SELF, padded_.size, &m));
      check(VecSetBlockSize(m, 2));
    }
    for (Index e = 0; e < scale.size(); ++e) {
      const Index row = row_[static_cast<std::size_t>(e)];
      const int c = unknowns_.component[e];
      const double turn = c == 0 ? -unknowns_.place(1, e) : unknowns_.place(0, e);
      check(VecSetValue(motion[static_cast<std::size_t>(c)], row, 1.0 / scale[e], INSERT_VALUES));
      check(VecSetValue(motion[2], row, turn / scale[e], INSERT_VALUES));
    }
    orthonormalise(motion);
    MatNullSpace motions = nullptr;
    check(MatNullSpaceCreate(PETSC_COMM_SELF, PETSC_FALSE, 3, motion.data(), &motions));
    check(MatSetNearNullSpace(matrix_, motions));
    check(MatNullSpaceDestroy(&motions));
    for (Vec& m : motion) check(VecDestroy(&m));
  }

  static void orthonormalise(std::array<Vec, 3>& motion) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        double product = 0.0;
        check(VecDot(motion[k], motion[j], &product));
        check(VecAXPY(motion[k], -product, motion[j]));
      }
      check(VecNormalize(motion[k], nullptr));
    }
  }

  void iterate(const Eigen::VectorXd& right, Eigen::VectorXd& x) const {
    Vec b = nullptr;
    Vec to = nullptr;
    check(VecCreateSeqWithArray(PETSC_COMM_SELF, 2, padded_.size, right.data(), &b));
    check(VecCreateSeqWithArray(PETSC_COMM_SELF, 2, padded_.size, x.data(), &to));
    check(KSPSolve(solver_, b, to));
    KSPConvergedReason reason{};
    PetscInt iterations = 0;
    double residual = 0.0;
    check(KSPGetConvergedReason(solver_, &reason));
    check(KSPGetIterationNumber(solver_, &iterations));
    check(KSPGetResidualNorm(solver_, &residual));
    check(VecDestroy(&b));
    check(VecDestroy(&to));
    iterations_ += iterations;
    if (reason < 0) throw NotConverged(iterations, residual / right.norm());
  }

  Unknowns unknowns_;
  std::vector<Index> row_;             ///< of every equation
  std::vector<Eigen::Vector2d> node_;  ///< places with two rows each
  SparseMatrix padded_;                ///< both halves; PETSc's matrix shares it
  Mat matrix_ = nullptr;
  KSP solver_ = nullptr;
  mutable long iterations_ = 0;
};

}  // namespace
}  // namespace shoreline

extern "C" shoreline::Factors* shoreline_make_multigrid(const shoreline::Unknowns& unknowns) {
  return new shoreline::Multigrid(unknowns);
}
