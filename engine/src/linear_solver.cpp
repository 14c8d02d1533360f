#include "shoreline/engine/linear_solver.hpp"

#include <fmt/format.h>

#include <cmath>

#include "shoreline/bases/counters.hpp"
#include "solver/band_factors.hpp"
#include "solver/cholmod_factors.hpp"
#include "solver/multigrid_component.hpp"
#include "solver/umfpack_factors.hpp"

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

void scale_by_diagonal(const SparseMatrix& matrix, ScaledMatrix& scaled) {
  scaled.matrix = matrix;
  Eigen::VectorXd& scale = scaled.scale;
  scale.resize(matrix.size);
  for (Index j = 0; j < matrix.size; ++j) {
    const double diagonal = matrix.value[static_cast<std::size_t>(matrix.column[static_cast<std::size_t>(j)])];
    if (diagonal == 0.0 || !std::isfinite(diagonal)) throw SingularMatrix(j, diagonal);
    scale[j] = 1.0 / std::sqrt(std::abs(diagonal));
  }
  for (Index j = 0; j < matrix.size; ++j)
    for (auto k = static_cast<std::size_t>(matrix.column[static_cast<std::size_t>(j)]);
         k < static_cast<std::size_t>(matrix.column[static_cast<std::size_t>(j) + 1]); ++k)
      scaled.matrix.value[k] *= scale[j] * scale[scaled.matrix.row[k]];
}

/// The narrowest band of a matrix.
BandOrder band_of(const SparseMatrix& matrix, const Unknowns& unknowns) {
  return narrowest_order(unknowns, [&](auto&& use) {
    for (Index j = 0; j < matrix.size; ++j)
      for (Index k = matrix.column[static_cast<std::size_t>(j)]; k < matrix.column[static_cast<std::size_t>(j) + 1];
           ++k)
        use(matrix.row[static_cast<std::size_t>(k)], j);
  });
}

}  // namespace

SingularMatrix::SingularMatrix(Index equation, double pivot)
    : Error(fmt::format("singular matrix: pivot {:.2g} of the scaled matrix at equation {}", pivot, equation)),
      equation_(equation),
      pivot_(pivot) {}

struct LinearSolver::State {
  SolverType type = SolverType::cholmod;
  std::unique_ptr<Factors> factors;
  UmfpackFactors lu;  // where Cholesky fails
  ScaledMatrix scaled;
  bool definite = false;  // else the factors are UMFPACK's
  Pivot smallest;

  [[nodiscard]] Eigen::VectorXd apply_inverse(const Eigen::VectorXd& b) const {
    count(Work::solves);
    return definite ? factors->apply_inverse(b) : lu.apply_inverse(b);
  }
};

LinearSolver::LinearSolver() : state_(std::make_unique<State>()) {}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

void LinearSolver::analyse(const SparseMatrix& matrix) {
  count(Work::analyses);
  state_->type = SolverType::cholmod;
  state_->factors = make_cholmod_factors();
  state_->factors->analyse(matrix);
}

void LinearSolver::analyse(const SparseMatrix& matrix, const Unknowns& unknowns, const SolverRequest& request) {
  BandOrder order;
  if (request.type == SolverType::automatic || request.type == SolverType::band) order = band_of(matrix, unknowns);
  const SystemSize size{
      .unknowns = matrix.size, .width = order.width, .functions_per_cell = unknowns.functions_per_cell};
  state_->type = choose_solver(request, size).type;
  if (state_->type == SolverType::cholmod) return analyse(matrix);
  state_->factors =
      state_->type == SolverType::band ? make_band_factors(std::move(order)) : make_multigrid_factors(unknowns);
  state_->factors->analyse(matrix);
}

void LinearSolver::factorize(const SparseMatrix& matrix, double shift) {
  count(Work::factorisations);
  State& s = *state_;
  s.lu.release();
  s.definite = true;
  s.smallest = {};
  scale_by_diagonal(matrix, s.scaled);
  if (const auto failing = s.factors->factorize(s.scaled, shift)) {
    s.definite = false;
    s.smallest.equation = *failing;
    if (shift > 0.0) throw SingularMatrix(*failing, 0.0);
    if (const double smallest = s.lu.factorize(s.scaled.matrix); smallest < smallest_usable_lu)
      throw SingularMatrix(*failing, smallest);
  } else if (const auto smallest = s.factors->smallest_pivot()) {
    s.smallest = *smallest;
    if (smallest->value < smallest_usable_pivot) throw SingularMatrix(smallest->equation, smallest->value);
  }
}

Eigen::VectorXd LinearSolver::solve(const Eigen::VectorXd& right_hand_side) const {
  return refined(right_hand_side, refined(right_hand_side, Eigen::VectorXd::Zero(right_hand_side.size())));
}

Eigen::VectorXd LinearSolver::refined(const Eigen::VectorXd& right_hand_side, const Eigen::VectorXd& x) const {
  const ScaledMatrix& scaled = state_->scaled;
  const Eigen::VectorXd y = x.cwiseQuotient(scaled.scale);
  const Eigen::VectorXd rest = scaled.scale.cwiseProduct(right_hand_side) - multiply(scaled.matrix, y);
  return x + scaled.scale.cwiseProduct(state_->apply_inverse(rest));
}

double LinearSolver::smallest_pivot() const { return state_->smallest.value; }

bool LinearSolver::positive_definite() const { return state_->definite; }

Index LinearSolver::smallest_pivot_equation() const { return state_->smallest.equation; }

double LinearSolver::condition_estimate() const {
  const State& s = *state_;
  const Eigen::Index n = s.scaled.scale.size();
  Eigen::VectorXd x = Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
  double estimate = 0.0;
  for (int iteration = 0; iteration < 5; ++iteration) {  // ‖A⁻¹‖₁ from below: climb over the vertices of the unit ball
    const Eigen::VectorXd y = s.apply_inverse(x);
    if (y.lpNorm<1>() <= estimate) break;
    estimate = y.lpNorm<1>();
    const Eigen::VectorXd z = s.apply_inverse(y.unaryExpr([](double v) { return v < 0.0 ? -1.0 : 1.0; }));
    Eigen::Index steepest = 0;
    if (z.cwiseAbs().maxCoeff(&steepest) <= z.dot(x)) break;
    x = Eigen::VectorXd::Unit(n, steepest);
  }
  return estimate * norm1(s.scaled.matrix);
}

SolverUse LinearSolver::use() const {
  const State& s = *state_;
  return {.type = s.type,
          .unknowns = s.scaled.matrix.size,
          .bytes = s.factors->bytes() + (s.definite ? 0.0 : s.lu.bytes()),
          .iterations = s.factors->iterations()};
}

}  // namespace shoreline
