#pragma once
// Sparse LU with pivoting, for a symmetric matrix that is not positive definite: UMFPACK.

#include "factors.hpp"

namespace shoreline {

class UmfpackFactors {
 public:
  UmfpackFactors() = default;
  ~UmfpackFactors() { release(); }
  UmfpackFactors(const UmfpackFactors&) = delete;
  UmfpackFactors& operator=(const UmfpackFactors&) = delete;

  /// @return smallest pivot over the largest; 0 where the matrix is singular
  [[nodiscard]] double factorize(const SparseMatrix& lower);
  [[nodiscard]] Eigen::VectorXd apply_inverse(const Eigen::VectorXd& b) const;
  [[nodiscard]] double bytes() const { return bytes_; }
  void release();

 private:
  void* numeric_ = nullptr;
  SparseMatrix matrix_;  ///< both halves, which UMFPACK's solve reads again
  double bytes_ = 0.0;
};

}  // namespace shoreline
