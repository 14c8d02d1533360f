#include "band_factors.hpp"

#include <limits>

#include "../threads.hpp"

extern "C" {
void openblas_set_num_threads(int threads);
int openblas_get_num_threads();
void dpbtrf_(const char* triangle, const int* n, const int* width, double* band, const int* rows, int* fault);
void dpbtrs_(const char* triangle, const int* n, const int* width, const int* columns, const double* band,
             const int* rows, double* right, const int* right_rows, int* fault);
}

namespace shoreline {
namespace {

/// One thread of the BLAS while it lives: the blocks of a narrow band are too small to share.
class OneBlasThread {
 public:
  OneBlasThread() : threads_(openblas_get_num_threads()) { openblas_set_num_threads(1); }
  ~OneBlasThread() { openblas_set_num_threads(threads_); }
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  int threads_;
};

class BandFactors final : public Factors {
 public:
  explicit BandFactors(BandOrder order) : order_(std::move(order)) {}

  void analyse(const SparseMatrix& matrix) override {
    place_.resize(matrix.row.size());
    equation_.resize(static_cast<std::size_t>(matrix.size));
    for (Index j = 0; j < matrix.size; ++j) {
      const Index pj = order_.position[static_cast<std::size_t>(j)];
      equation_[static_cast<std::size_t>(pj)] = j;
      for (auto k = static_cast<std::size_t>(matrix.column[static_cast<std::size_t>(j)]);
           k < static_cast<std::size_t>(matrix.column[static_cast<std::size_t>(j) + 1]); ++k) {
        const Index pi = order_.position[static_cast<std::size_t>(matrix.row[k])];
        place_[k] = start(std::min(pi, pj)) + static_cast<std::size_t>(std::abs(pi - pj));
      }
    }
    band_ = std::make_unique_for_overwrite<double[]>(start(matrix.size));
  }

  std::optional<Index> factorize(const ScaledMatrix& scaled, double shift) override {
    const Index n = size();
#pragma omp parallel for schedule(static) if (worth_threads(start(n)))
    for (Index j = 0; j < n; ++j) std::fill(band_.get() + start(j), band_.get() + start(j + 1), 0.0);
    for (std::size_t k = 0; k < place_.size(); ++k) band_[place_[k]] = scaled.matrix.value[k];
    for (Index j = 0; j < n; ++j) band_[start(j)] += shift;
    const int rows = order_.width + 1;
    int fault = 0;
    const OneBlasThread one;
    dpbtrf_("L", &n, &order_.width, band_.get(), &rows, &fault);
    if (fault > 0) return equation_[static_cast<std::size_t>(fault) - 1];
    return std::nullopt;
  }

  [[nodiscard]] Eigen::VectorXd apply_inverse(const Eigen::VectorXd& b) const override {
    const Index n = size();
    Eigen::VectorXd x(n);
    for (Index k = 0; k < n; ++k) x[k] = b[equation_[static_cast<std::size_t>(k)]];
    const int rows = order_.width + 1;
    const int one = 1;
    int fault = 0;
    const OneBlasThread alone;
    dpbtrs_("L", &n, &order_.width, &one, band_.get(), &rows, x.data(), &n, &fault);
    Eigen::VectorXd solution(n);
    for (Index k = 0; k < n; ++k) solution[equation_[static_cast<std::size_t>(k)]] = x[k];
    return solution;
  }

  [[nodiscard]] std::optional<Pivot> smallest_pivot() const override {
    Pivot found{std::numeric_limits<double>::infinity(), -1};
    for (Index j = 0; j < size(); ++j)
      if (const double l = band_[start(j)]; l * l < found.value)
        found = {l * l, equation_[static_cast<std::size_t>(j)]};
    return found;
  }

  [[nodiscard]] double bytes() const override { return 8.0 * static_cast<double>(start(size())); }

 private:
  [[nodiscard]] Index size() const { return static_cast<Index>(equation_.size()); }

  /// Where a column of the band begins, with its diagonal.
  [[nodiscard]] std::size_t start(Index column) const {
    return static_cast<std::size_t>(column) * (static_cast<std::size_t>(order_.width) + 1);
  }

  BandOrder order_;
  std::vector<Index> equation_;     ///< by position
  std::vector<std::size_t> place_;  ///< of every entry of the matrix in the band
  std::unique_ptr<double[]> band_;  ///< (width + 1, equations)
};

}  // namespace

std::unique_ptr<Factors> make_band_factors(BandOrder order) { return std::make_unique<BandFactors>(std::move(order)); }

}  // namespace shoreline
