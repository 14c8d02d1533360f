#pragma once
// What a method of the ladder offers the linear solver: something that answers like the inverse of a scaled matrix.

#include <optional>

#include "shoreline/engine/linear_solver.hpp"

namespace shoreline {

struct Pivot {
  double value = 0.0;
  Index equation = 0;
};

/// A = S K S with unit diagonal, S = diag(scale).
struct ScaledMatrix {
  SparseMatrix matrix;
  Eigen::VectorXd scale;  ///< 1/√|K_ii|
};

class Factors {
 public:
  virtual ~Factors() = default;

  /// Prepares for matrices of one pattern.
  virtual void analyse(const SparseMatrix& matrix) = 0;

  /// Factorises A + shift I, of the pattern that was analysed.
  /// @return the equation at which A + shift I was found not to be positive definite, if it was
  [[nodiscard]] virtual std::optional<Index> factorize(const ScaledMatrix& scaled, double shift) = 0;

  /// (A + shift I)⁻¹ b, after a factorisation that found the matrix positive definite.
  /// @throws NotConverged
  [[nodiscard]] virtual Eigen::VectorXd apply_inverse(const Eigen::VectorXd& b) const = 0;

  /// The smallest pivot; none where there are no pivots.
  [[nodiscard]] virtual std::optional<Pivot> smallest_pivot() const = 0;

  [[nodiscard]] virtual double bytes() const = 0;

  /// Iterations of all applications since factorize; none of a direct method.
  [[nodiscard]] virtual std::optional<long> iterations() const { return std::nullopt; }
};

}  // namespace shoreline
