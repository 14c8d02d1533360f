#include "consistent_weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "shoreline/boundary/fitted_weights.hpp"
#include "shoreline/engine/failures.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

constexpr double tolerance = 1e-6;   ///< of the residual, in parts of the largest right side
constexpr double firm = 1e-8;        ///< ε of (W.7), in parts of the largest diagonal of its rows
constexpr double soft = 1e-3;        ///< and of (W.8)
constexpr double contraction = 0.5;  ///< of the residual in an iteration, for which old factors are good enough
constexpr double flat = 0.1;         ///< slope at the end of a search, in parts of that at its start
constexpr int most_iterations = 100;
constexpr int most_bisections = 30;

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

  [[nodiscard]] double size() const { return residual.cwiseAbs().maxCoeff(); }
};

void ConsistentWeights::evaluate(const WeightConstraints& constraints, const Eigen::VectorXd& plain,
                                 State& state) const {
  const Eigen::ArrayXd change = constraints.at_points(state.multiplier).array();
  const Eigen::ArrayXd free = (1.0 + change).max(least_weight);
  state.weight = plain.array() * free;
  state.residual = constraints.sums(state.weight) - right_side_ + softness_.cwiseProduct(state.multiplier);
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
  assemble(constraints, (state.weight.array() > least_weight * plain.array()).select(plain, 0.0));
  for (Index e = 0; e < matrix_.size; ++e) matrix_.value[at(matrix_.column[at(e)])] += softness_[assembler_.unknown(e)];
  if (!std::exchange(analysed_, true)) solver_.analyse(matrix_);
  solver_.factorize(matrix_);
  ++report_.factorisations;
}

Eigen::VectorXd ConsistentWeights::newton_step(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd reduced(assembler_.equations());
  for (Index e = 0; e < assembler_.equations(); ++e) reduced[e] = residual[assembler_.unknown(e)];
  reduced = solver_.refined(reduced, Eigen::VectorXd::Zero(reduced.size()));
  Eigen::VectorXd step = Eigen::VectorXd::Zero(residual.size());
  for (Index e = 0; e < assembler_.equations(); ++e) step[assembler_.unknown(e)] = -reduced[e];
  return step;
}

/// The place along a direction of descent where the energy is least, nearly: its slope there, which grows along the
/// way, is below a tenth of that at the start.
ConsistentWeights::State ConsistentWeights::search(const WeightConstraints& constraints, const Eigen::VectorXd& plain,
                                                   const State& from, const Eigen::VectorXd& step) const {
  const double slope = step.dot(from.residual);
  double low = 0.0, high = 1.0, share = 1.0;
  State next;
  for (int k = 0; k < most_bisections; ++k) {
    next.multiplier = from.multiplier + share * step;
    evaluate(constraints, plain, next);
    const double here = step.dot(next.residual);
    if (std::abs(here) <= flat * std::abs(slope) || (share == 1.0 && here < 0.0)) break;
    (here < 0.0 ? low : high) = share;
    share = 0.5 * (low + high);
  }
  return next;
}

/// One iteration; with old factors that do not serve it changes nothing but that they are to be renewed.
void ConsistentWeights::advance(const WeightConstraints& constraints, const Eigen::VectorXd& plain, State& state) {
  if (std::exchange(has_factors_, true)) {
    State next{.multiplier = state.multiplier + newton_step(state.residual), .weight = {}, .residual = {}};
    evaluate(constraints, plain, next);
    has_factors_ = next.size() <= contraction * state.size();
    if (has_factors_) state = std::move(next);
    return;
  }
  factorise(constraints, plain, state);
  const double before = state.size();
  state = search(constraints, plain, state, newton_step(state.residual));
  has_factors_ = state.size() <= contraction * before;
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
  trend_.setZero(constraints.rows());
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

  State state{.multiplier = multiplier_ + trend_, .weight = {}, .residual = {}};
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
  trend_ = state.multiplier - multiplier_;
  multiplier_ = state.multiplier;
  report_.bounded = static_cast<Index>((state.weight.array() <= least_weight * plain.array()).count());
  report_.changed = static_cast<double>(((state.weight - plain).array().abs() > 0.1 * plain.array()).count()) /
                    static_cast<double>(std::max<Index>(1, points.size()));
  report_.unmet = (state.residual - softness_.cwiseProduct(multiplier_)).cwiseAbs().maxCoeff() / largest;
  Eigen::VectorXd weight(points.size());
  for (Index k = 0; k < points.size(); ++k) weight[supports.point[at(k)]] = state.weight[k];
  return weight;
}

}  // namespace shoreline
