#pragma once
// Sparse direct solution of one symmetric system: CHOLMOD, and UMFPACK where the matrix is not positive definite.

#include <memory>
#include <string>

#include "shoreline/bases/error.hpp"
#include "shoreline/engine/assembler.hpp"

namespace shoreline {

/// The matrix has no usable inverse, (L.2). @ref equation is where the factorisation came to its smallest pivot.
class SingularMatrix : public Error {
 public:
  SingularMatrix(Index equation, double pivot);
  [[nodiscard]] Index equation() const { return equation_; }
  [[nodiscard]] double pivot() const { return pivot_; }  ///< of the matrix scaled to unit diagonal

 private:
  Index equation_;
  double pivot_;
};

/// Solves K x = f for K scaled symmetrically by its diagonal, with one step of iterative refinement, (L.1).
/// No SuiteSparse type appears here.
class LinearSolver {
 public:
  LinearSolver();
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  /// Orders (AMD) and analyses a pattern; it holds for every later matrix of the same pattern.
  void analyse(const SparseMatrix& matrix);

  /// Factorises a matrix whose pattern was analysed. With a shift s > 0 the factors are those of A + s I, A the scaled
  /// matrix: refined() steps with them towards a solution even where A is singular, (L.5).
  /// @throws SingularMatrix if a pivot of the scaled matrix is below 1e-15 (of a pivoted LU below 1e-12 of the
  /// largest);
  ///         with a shift, if one is not positive
  void factorize(const SparseMatrix& matrix, double shift = 0.0);

  /// @pre factorize was called
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;

  /// One step of iterative refinement: @p x and what the factors answer to the rest of the right side. solve() is two
  /// of them from zero.
  /// @pre factorize was called
  [[nodiscard]] Eigen::VectorXd refined(const Eigen::VectorXd& right_hand_side, const Eigen::VectorXd& x) const;

  /// Smallest pivot of the scaled matrix; 0 where Cholesky fails.
  [[nodiscard]] double smallest_pivot() const;

  /// Where that pivot is; where Cholesky fails, where it met a pivot that is not positive.
  [[nodiscard]] Index smallest_pivot_equation() const;

  /// Whether Cholesky's factorisation exists; if not, the factors are those of a pivoted LU.
  [[nodiscard]] bool positive_definite() const;

  /// Estimate of ‖A‖₁‖A⁻¹‖₁ of the scaled matrix A from its factors (Hager 1984, Higham 1988), (L.3); a few solves.
  [[nodiscard]] double condition_estimate() const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

/// Sets the threads that the BLAS uses.
void set_blas_threads(int threads);

/// Name and build of the BLAS at work, for instance "OpenBLAS 0.3.21 …".
[[nodiscard]] std::string blas_name();

}  // namespace shoreline
