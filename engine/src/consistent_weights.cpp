#include "consistent_weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "shoreline/engine/failures.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

constexpr double bound = 0.05;       ///< β: least weight, in parts of the plain one
constexpr double tolerance = 1e-9;   ///< of the residual, in parts of the largest right side
constexpr double firm = 1e-8;       ///< ε of (W.7), in parts of the largest diagonal of its rows
constexpr double soft = 1e-3;        ///< and of (W.8)
constexpr double contraction = 0.5;  ///< of the residual in an iteration, for which old factors are good enough
constexpr double sufficient = 1e-4;  ///< share of the slope by which a step must lower the energy
constexpr int most_iterations = 100;
constexpr int most_halvings = 30;

}  // namespace

void WeightReport::add(const WeightReport& other) {
  changed = std::max(changed, other.changed);
  bounded = std::max(bounded, other.bounded);
  unmet = std::max(unmet, other.unmet);
  iterations += other.iterations;
  factorisations += other.factorisations;
}

/// One place of the iteration.
struct ConsistentWeights::State {
  Eigen::VectorXd multiplier;
  Eigen::VectorXd weight;    ///< in the order of cells
  Eigen::VectorXd residual;  ///< A w − r + ε λ
  double energy = 0.0;       ///< of which it is the gradient

  [[nodiscard]] double size() const { return residual.cwiseAbs().maxCoeff(); }
};

void ConsistentWeights::evaluate(const WeightConstraints& constraints, const Eigen::VectorXd& plain,
                                 State& state) const {
  const Eigen::ArrayXd change = constraints.at_points(state.multiplier).array();
  const Eigen::ArrayXd free = (1.0 + change).max(bound);
  state.weight = plain.array() * free;
  state.residual = constraints.sums(state.weight) - right_side_ + softness_.cwiseProduct(state.multiplier);
  // ∫ max(β, 1 + s) ds from the kink s = β − 1
  const Eigen::ArrayXd bent = change - (bound - 1.0);
  state.energy = (plain.array() * (bound * bent + 0.5 * bent.max(0.0).square())).sum() -
                 right_side_.dot(state.multiplier) + 0.5 * softness_.dot(state.multiplier.cwiseAbs2());
}

/// A diag(w) Aᵀ.
void ConsistentWeights::assemble(const WeightConstraints& constraints, const Eigen::VectorXd& weight) {
  constraints.blocks(weight, blocks_);
  analysed_ &= assembler_.prepare(blocks_, {}, static_cast<Index>(constraints.rows() / 2));
  Eigen::VectorXd unused;
  assembler_.assemble(blocks_, matrix_, unused);
}

void ConsistentWeights::factorise(const WeightConstraints& constraints, const Eigen::VectorXd& plain,
                                  const State& state) {
  assemble(constraints, (state.weight.array() > bound * plain.array()).select(plain, 0.0));
  for (Index e = 0; e < matrix_.size; ++e) matrix_.value[at(matrix_.column[at(e)])] += softness_[assembler_.unknown(e)];
  if (!std::exchange(analysed_, true)) solver_.analyse(matrix_);
  solver_.factorize(matrix_);
  ++report_.factorisations;
}

Eigen::VectorXd ConsistentWeights::newton_step(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd reduced(assembler_.equations());
  for (Index e = 0; e < assembler_.equations(); ++e) reduced[e] = residual[assembler_.unknown(e)];
  reduced = solver_.solve(reduced);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(residual.size());
  for (Index e = 0; e < assembler_.equations(); ++e) step[assembler_.unknown(e)] = -reduced[e];
  return step;
}

/// One iteration; with old factors that do not serve it changes nothing but that they are to be renewed.
void ConsistentWeights::advance(const WeightConstraints& constraints, const Eigen::VectorXd& plain, State& state) {
  const bool old = has_factors_;
  if (!old) factorise(constraints, plain, state);
  const Eigen::VectorXd step = newton_step(state.residual);
  State next{.multiplier = state.multiplier + step, .weight = {}, .residual = {}};
  evaluate(constraints, plain, next);
  const auto contracts = [&] { return next.size() <= contraction * state.size(); };
  const double slope = sufficient * step.dot(state.residual);
  double share = 1.0;
  for (int k = 0; !old && k < most_halvings && !contracts() && next.energy > state.energy + share * slope; ++k) {
    share *= 0.5;
    next.multiplier = state.multiplier + share * step;
    evaluate(constraints, plain, next);
  }
  has_factors_ = contracts();
  if (has_factors_ || !old) state = std::move(next);
}

void ConsistentWeights::find_softness(const WeightConstraints& constraints, const Eigen::VectorXd& plain) {
  assemble(constraints, plain);
  double largest[2] = {0.0, 0.0};
  for (Index e = 0; e < matrix_.size; ++e) {
    double& here = largest[constraints.is_linear(assembler_.unknown(e)) ? 1 : 0];
    here = std::max(here, matrix_.value[at(matrix_.column[at(e)])]);
  }
  softness_.resize(constraints.rows());
  for (Eigen::Index row = 0; row < softness_.size(); ++row)
    softness_[row] = constraints.is_linear(row) ? soft * largest[1] : firm * largest[0];
}

void ConsistentWeights::start(const WeightConstraints& constraints, const Eigen::VectorXd& plain) {
  report_ = {};
  if (softness_.size() == 0) {
    find_softness(constraints, plain);
    multiplier_ = Eigen::VectorXd::Zero(constraints.rows());
  }
  if (seen_ == constraints.seen()) return;
  has_factors_ = false;
  seen_ = constraints.seen();
  for (Eigen::Index row = 0; row < multiplier_.size(); ++row)
    if (seen_[static_cast<std::size_t>(row / (2 * constraints.moments()))] == 0) multiplier_[row] = 0.0;
}

Eigen::VectorXd ConsistentWeights::fit(const Basis& basis, const MaterialPoints& points, const PointSupports& supports,
                                       const std::vector<Edge>& edges) {
  const WeightConstraints constraints(consistency_, basis, points, supports);
  Eigen::VectorXd plain(points.size());
  for (Index k = 0; k < points.size(); ++k) plain[k] = points.volume[supports.point[at(k)]];
  right_side_ = constraints.right_side(edges);
  start(constraints, plain);

  State state{.multiplier = multiplier_, .weight = {}, .residual = {}};
  evaluate(constraints, plain, state);
  const double largest = right_side_.cwiseAbs().maxCoeff();
  for (; state.size() > tolerance * largest; ++report_.iterations) {
    if (report_.iterations == most_iterations)
      throw ComputationError(fmt::format(
          "fitted weights: found {:.1e} of the largest right side left after {} iterations, expected {:.0e}; take more "
          "material points, or \"volumes\": \"clipped\"",
          state.size() / largest, most_iterations, tolerance));
    advance(constraints, plain, state);
  }
  multiplier_ = state.multiplier;
  report_.bounded = static_cast<Index>((state.weight.array() <= bound * plain.array()).count());
  report_.changed = static_cast<double>(((state.weight - plain).array().abs() > 0.1 * plain.array()).count()) /
                    static_cast<double>(std::max<Index>(1, points.size()));
  report_.unmet = (state.residual - softness_.cwiseProduct(multiplier_)).cwiseAbs().maxCoeff() / largest;
  Eigen::VectorXd weight(points.size());
  for (Index k = 0; k < points.size(); ++k) weight[supports.point[at(k)]] = state.weight[k];
  return weight;
}

}  // namespace shoreline
