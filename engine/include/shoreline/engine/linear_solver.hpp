#pragma once
// Solution of one symmetric system by a ladder of methods, and by UMFPACK where the matrix is not positive definite.

#include <memory>
#include <string>

#include "shoreline/bases/error.hpp"
#include "shoreline/engine/assembler.hpp"
#include "shoreline/engine/solver_choice.hpp"

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

/// An iteration came to no end: the matrix is not positive definite, or too badly conditioned.
class NotConverged : public Error {
 public:
  NotConverged(long iterations, double residual)
      : Error("no convergence after " + std::to_string(iterations) + " iterations"),
        iterations_(iterations),
        residual_(residual) {}
  [[nodiscard]] long iterations() const { return iterations_; }
  [[nodiscard]] double residual() const { return residual_; }  ///< reached, over that of the start

 private:
  long iterations_;
  double residual_;
};

/// What equations stand for; methods that know the grid need it.
struct Unknowns {
  Eigen::Matrix2Xd place;     ///< (2, equations) control point of each one's function [m]
  Eigen::VectorXi component;  ///< (equations) 0 or 1
  int functions_per_cell;     ///< of the basis
};

/// Solves K x = f for K scaled symmetrically by its diagonal, with one step of iterative refinement, (L.1).
/// No type of SuiteSparse, LAPACK or PETSc appears here.
class LinearSolver {
 public:
  LinearSolver();
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  /// Orders (AMD) and analyses a pattern for CHOLMOD; it holds for every later matrix of the same pattern.
  void analyse(const SparseMatrix& matrix);

  /// Likewise, for the method that choose_solver finds.
  /// @throws InvalidArgument if that is multigrid and its component is not installed
  void analyse(const SparseMatrix& matrix, const Unknowns& unknowns, const SolverRequest& request);

  /// Factorises a matrix whose pattern was analysed. With a shift s > 0 the factors are those of A + s I, A the scaled
  /// matrix: refined() steps with them towards a solution even where A is singular, (L.5).
  /// @pre analyse was called
  /// @throws SingularMatrix if a pivot of the scaled matrix is below 1e-15 (of a pivoted LU below 1e-12 of the
  ///         largest); with a shift, if one is not positive
  void factorize(const SparseMatrix& matrix, double shift = 0.0);

  /// @pre factorize was called
  /// @throws NotConverged from multigrid alone
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;

  /// One step of iterative refinement: @p x and what the factors answer to the rest of the right side. solve() is two
  /// of them from zero.
  /// @pre factorize was called
  [[nodiscard]] Eigen::VectorXd refined(const Eigen::VectorXd& right_hand_side, const Eigen::VectorXd& x) const;

  /// Smallest pivot of the scaled matrix; 0 where Cholesky fails, and of multigrid, which has none.
  [[nodiscard]] double smallest_pivot() const;

  /// Where that pivot is; where Cholesky fails, where it met a pivot that is not positive.
  [[nodiscard]] Index smallest_pivot_equation() const;

  /// Whether Cholesky's factorisation exists; if not, the factors are those of a pivoted LU. Multigrid takes it for
  /// granted, and does not converge otherwise.
  [[nodiscard]] bool positive_definite() const;

  /// Estimate of ‖A‖₁‖A⁻¹‖₁ of the scaled matrix A from its factors (Hager 1984, Higham 1988), (L.3); a few solves.
  [[nodiscard]] double condition_estimate() const;

  /// @pre factorize was called
  [[nodiscard]] SolverUse use() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Sets the threads that the BLAS uses.
void set_blas_threads(int threads);

/// The BLAS at work.
struct Blas {
  std::string name;        ///< for instance "OpenBLAS 0.3.21 …"
  bool reference = false;  ///< the reference implementation, many times slower than others
};

/// Finds the library whose dgemm the program calls, whatever it was linked with.
[[nodiscard]] Blas blas_at_work();

/// The name of blas_at_work().
[[nodiscard]] std::string blas_name();

}  // namespace shoreline
