#include "shoreline/boundary/fitted_weights.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "shoreline/bases/counters.hpp"
#include "shoreline/boundary/body_moments.hpp"
#include "shoreline/boundary/region.hpp"

namespace shoreline {
namespace {

constexpr Eigen::Index most = monomials(max_moment_order);
using Multipliers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;

constexpr double ridge = 1e-10;     ///< ε of (W.2)
constexpr double rounding = 1e-12;  ///< of the cell: what the moments of a small part carry of it
constexpr int most_steps = 25;

/// The order up to which there are so many moments.
int order_of(Eigen::Index moments) {
  int order = 0;
  while (monomials(order) < moments) ++order;
  return order;
}

/// The monomials at the points, (moments, n). The one of degree d and number b follows from those of degree d - 1.
Eigen::MatrixXd monomials_at(const Eigen::Ref<const Eigen::Matrix2Xd>& x, double size, int order) {
  Eigen::MatrixXd m(monomials(order), x.cols());
  for (Eigen::Index p = 0; p < x.cols(); ++p) {
    const Vec2 at = x.col(p) / size;
    double* const here = m.col(p).data();
    here[0] = 1.0;
    for (Eigen::Index degree = 1, k = 1; degree <= order; ++degree) {
      for (Eigen::Index b = 0; b < degree; ++b, ++k) here[k] = at.x() * here[k - degree];
      here[k] = at.y() * here[k - degree - 1];
      ++k;
    }
  }
  return m;
}

/// ∫ ξ^a η^b over the covered area, ξ and η in sizes of the cell.
Multipliers scaled(const Eigen::Ref<const Eigen::VectorXd>& moments, double size, int order) {
  Multipliers scaled = moments.head(monomials(order));
  double unit = moments[0];
  for (int degree = 0, k = 0; degree <= order; ++degree, unit *= size)
    for (int b = 0; b <= degree; ++b) scaled[k++] /= unit;
  return scaled;
}

/// Multipliers λ, and the factors 1 + Aᵀ λ by which plain weights grow where they stay above the bound.
struct Estimate {
  Multipliers multiplier;
  Eigen::VectorXd growth;
};

/// The problem (W.1) in shares of the covered area, for polynomials that are orthonormal on the points: what is asked
/// of them is independent, however thin the covered part is.
struct Problem {
  Eigen::MatrixXd value;  ///< (n, polynomials)
  Multipliers target;     ///< (polynomials)
  Eigen::VectorXd plain;  ///< (n) v, whose sum is 1

  [[nodiscard]] Eigen::VectorXd weights(const Eigen::VectorXd& growth) const {
    return plain.cwiseProduct(growth.cwiseMax(least_weight));
  }
  /// Φ of (W.2), whose gradient is A w − m + ε λ.
  [[nodiscard]] double merit(const Estimate& at) const {
    const auto above = at.growth.array().max(least_weight);
    const auto psi = 0.5 * above.square() + least_weight * (at.growth.array() - above);
    return (plain.array() * psi).sum() - target.dot(at.multiplier) + 0.5 * ridge * at.multiplier.squaredNorm();
  }
  /// The solution of H step = −gradient with its second derivative H. On all points the polynomials are orthonormal;
  /// those at the bound do not count.
  [[nodiscard]] Multipliers step(const Eigen::VectorXd& growth, const Multipliers& gradient) const {
    const auto bound = growth.array() <= least_weight;
    if (!bound.any()) return -gradient / (1.0 + ridge);
    Gram h = (1.0 + ridge) * Gram::Identity(gradient.size(), gradient.size());
    for (Eigen::Index p = 0; p < growth.size(); ++p)
      if (bound[p]) h.selfadjointView<Eigen::Lower>().rankUpdate(value.row(p).transpose(), -plain[p]);
    return -h.ldlt().solve(gradient);
  }
};

/// The monomials made orthonormal by Gram and Schmidt, the largest rest first; every step serves values at the points,
/// times √v, and moments alike. Those of which others leave no more than @p dependent are left out.
Problem make_problem(const Eigen::Ref<const Eigen::MatrixXd>& monomial, Multipliers moment,
                     const Eigen::VectorXd& plain, double dependent) {
  const Eigen::VectorXd root = plain.cwiseSqrt();
  Eigen::MatrixXd value = root.asDiagonal() * monomial.transpose();
  const auto take_out = [&](Eigen::Index done, Eigen::Index k) {
    const double share = value.col(done).dot(value.col(k));
    value.col(k) -= share * value.col(done);
    moment[k] -= share * moment[done];
  };
  const Eigen::Index all = value.cols();
  double least = 0.0;
  Eigen::Index rank = 0;
  for (; rank < all; ++rank) {
    Eigen::Index largest = 0;
    value.rightCols(all - rank).colwise().squaredNorm().maxCoeff(&largest);
    value.col(rank).swap(value.col(rank + largest));
    std::swap(moment[rank], moment[rank + largest]);
    const double size = value.col(rank).norm();
    if (rank == 0) least = dependent * size;
    if (rank > 0 && size <= least) break;
    value.col(rank) /= size;
    moment[rank] /= size;
    for (Eigen::Index k = rank + 1; k < all; ++k) take_out(rank, k);
  }
  return {
      .value = root.cwiseInverse().asDiagonal() * value.leftCols(rank), .target = moment.head(rank), .plain = plain};
}

/// Moments of the covered part in sizes of the cell, and how far weights may be from them, in parts of the area.
struct Wanted {
  Eigen::MatrixXd monomial;  ///< (moments, n) at the points
  Multipliers moment;        ///< (moments)
  double exact;              ///< so near they count as met without a fit
  double met;                ///< so near a fit must come

  Wanted(const Eigen::Ref<const Eigen::Matrix2Xd>& x, double size, const Eigen::Ref<const Eigen::VectorXd>& moments)
      : monomial(monomials_at(x, size, order_of(moments.size()))),
        moment(scaled(moments, size, order_of(moments.size()))),
        exact(1e-12 + rounding * size * size / moments[0]),
        met(1e-9 + rounding * size * size / moments[0]) {}

  /// @param weight  in parts of the area
  [[nodiscard]] bool reproduced(int order, const Eigen::VectorXd& weight) const {
    const Eigen::Index rows = monomials(order);
    return (monomial.topRows(rows) * weight - moment.head(rows)).cwiseAbs().maxCoeff() <= exact;
  }
};

/// One Newton step of (W.2) with as much of it as lowers Φ.
/// @return whether any of it does
bool advance(const Problem& problem, const Multipliers& gradient, Estimate& at) {
  const Multipliers step = problem.step(at.growth, gradient);
  const Eigen::VectorXd growing = problem.value * step;
  const double before = problem.merit(at);
  const double rounded = 1e-14 * (1.0 + std::abs(before));
  for (double share = 1.0; share > 1e-6; share *= 0.5) {
    Estimate next{at.multiplier + share * step, at.growth + share * growing};
    if (problem.merit(next) > before + 1e-4 * share * gradient.dot(step) + rounded) continue;
    at = std::move(next);
    return true;
  }
  return false;
}

/// Weights that reproduce all moments up to an order by (W.2), or none where no weights above the bound do.
std::optional<Eigen::VectorXd> newton(const Wanted& wanted, int order, const Eigen::VectorXd& plain) {
  const Eigen::Index rows = monomials(order);
  const Problem problem =
      make_problem(wanted.monomial.topRows(rows), wanted.moment.head(rows), plain, 0.1 * wanted.met);
  const double least = 1.0 - 0.5 / plain.minCoeff();  // of Φ where weights exist, (W.3)
  Estimate at{Multipliers::Zero(problem.target.size()), Eigen::VectorXd::Ones(plain.size())};
  for (int k = 0; k < most_steps && problem.merit(at) >= least; ++k) {
    Eigen::VectorXd weight = problem.weights(at.growth);
    const Multipliers rest = problem.value.transpose() * weight - problem.target;
    if (rest.cwiseAbs().maxCoeff() <= wanted.met) {
      const Multipliers missed = wanted.monomial.topRows(rows) * weight - wanted.moment.head(rows);
      if (missed.cwiseAbs().maxCoeff() > wanted.met) return std::nullopt;  // one that was left out
      return weight;
    }
    if (!advance(problem, rest + ridge * at.multiplier, at)) return std::nullopt;
  }
  return std::nullopt;
}

/// Weights that reproduce all moments up to an order: the plain ones if they do, or fitted ones of enough points.
std::optional<Eigen::VectorXd> weights_for(const Wanted& wanted, int order, const Eigen::VectorXd& plain) {
  if (wanted.reproduced(order, plain)) return plain;
  if (points_for(order) > plain.size()) return std::nullopt;
  return newton(wanted, order, plain);
}

}  // namespace

int fit_weights(const Eigen::Ref<const Eigen::Matrix2Xd>& x, double size,
                const Eigen::Ref<const Eigen::VectorXd>& moments, Eigen::Ref<Eigen::VectorXd> weight) {
  count(Work::weight_fits);
  const Eigen::VectorXd plain = weight / weight.sum();
  const Wanted wanted(x, size, moments);
  weight = moments[0] * plain;
  for (int order = order_of(moments.size()); order > 0; --order)
    if (const auto found = weights_for(wanted, order, plain)) {
      weight = moments[0] * *found;
      return order;
    }
  return 0;
}

bool can_meet(const Eigen::Ref<const Eigen::Matrix2Xd>& x, double size,
              const Eigen::Ref<const Eigen::VectorXd>& moments, const Eigen::Ref<const Eigen::VectorXd>& plain) {
  const Wanted wanted(x, size, moments);
  return weights_for(wanted, order_of(moments.size()), plain / plain.sum()).has_value();
}

}  // namespace shoreline
