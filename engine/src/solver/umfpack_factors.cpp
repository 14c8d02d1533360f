#include "umfpack_factors.hpp"

#include <umfpack.h>

#include <array>
#include <new>

#include "both_halves.hpp"

namespace shoreline {

double UmfpackFactors::factorize(const SparseMatrix& lower) {
  release();
  matrix_ = both_halves(lower);
  void* symbolic = nullptr;
  std::array<double, UMFPACK_INFO> info{};
  umfpack_di_symbolic(matrix_.size, matrix_.size, matrix_.column.data(), matrix_.row.data(), matrix_.value.data(),
                      &symbolic, nullptr, nullptr);
  const int status = umfpack_di_numeric(matrix_.column.data(), matrix_.row.data(), matrix_.value.data(), symbolic,
                                        &numeric_, nullptr, info.data());
  umfpack_di_free_symbolic(&symbolic);
  if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
  bytes_ = info[UMFPACK_NUMERIC_SIZE] * info[UMFPACK_SIZE_OF_UNIT];
  return status == UMFPACK_OK ? info[UMFPACK_RCOND] : 0.0;
}

Eigen::VectorXd UmfpackFactors::apply_inverse(const Eigen::VectorXd& b) const {
  Eigen::VectorXd x(b.size());
  umfpack_di_solve(UMFPACK_A, matrix_.column.data(), matrix_.row.data(), matrix_.value.data(), x.data(), b.data(),
                   numeric_, nullptr, nullptr);
  return x;
}

void UmfpackFactors::release() {
  if (numeric_ != nullptr) umfpack_di_free_numeric(&numeric_);
  numeric_ = nullptr;
  matrix_ = {};
}

}  // namespace shoreline
