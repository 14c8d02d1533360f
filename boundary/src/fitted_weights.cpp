#include "shoreline/boundary/fitted_weights.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>

#include "shoreline/boundary/body_moments.hpp"
#include "shoreline/boundary/region.hpp"

namespace shoreline {
namespace {

constexpr Eigen::Index most = monomials(max_moment_order);
using Multipliers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;

constexpr double ridge = 1e-10;     ///< ε of (W.2)
constexpr double rounding = 1e-14;  ///< of the cell: what the moments of a small part carry of it
constexpr int most_steps = 25;

/// The order up to which there are so many moments.
int order_of(Eigen::Index moments) {
  int order = 0;
  while (monomials(order) < moments) ++order;
  return order;
}

/// The monomials at the points, (moments, n).
Eigen::MatrixXd monomials_at(const Eigen::Ref<const Eigen::Matrix2Xd>& x, double size, int order) {
  Eigen::MatrixXd m(monomials(order), x.cols());
  for (Eigen::Index p = 0; p < x.cols(); ++p) {
    const Vec2 at = x.col(p) / size;
    Eigen::Index k = 0;
    for (int degree = 0; degree <= order; ++degree)
      for (int b = 0; b <= degree; ++b) m(k++, p) = std::pow(at.x(), degree - b) * std::pow(at.y(), b);
  }
  return m;
}

/// ∫ ξ^a η^b over the covered area, ξ and η in sizes of the cell.
Multipliers scaled(const Eigen::Ref<const Eigen::VectorXd>& moments, double size, int order) {
  Multipliers scaled = moments.head(monomials(order)) / moments[0];
  for (int degree = 0, k = 0; degree <= order; ++degree)
    for (int b = 0; b <= degree; ++b) scaled[k++] /= std::pow(size, degree);
  return scaled;
}

/// The problem (W.1) in shares of the covered area. Its rows are polynomials that are orthonormal on the points: what
/// is asked of them is independent, however thin the covered part is.
struct Problem {
  Eigen::MatrixXd row;    ///< (polynomials, n)
  Multipliers target;     ///< (polynomials)
  Eigen::VectorXd plain;  ///< (n) v, whose sum is 1

  [[nodiscard]] Eigen::VectorXd growth(const Multipliers& multiplier) const {
    return Eigen::VectorXd::Ones(plain.size()) + row.transpose() * multiplier;
  }
  [[nodiscard]] Eigen::VectorXd weights(const Eigen::VectorXd& growth) const {
    return plain.cwiseProduct(growth.cwiseMax(least_weight));
  }
  [[nodiscard]] Multipliers rest(const Eigen::VectorXd& growth) const { return row * weights(growth) - target; }
  /// Φ of (W.2), whose gradient is A w − m + ε λ.
  [[nodiscard]] double merit(const Multipliers& multiplier) const {
    const Eigen::ArrayXd s = growth(multiplier);
    const Eigen::ArrayXd above = s.max(least_weight);
    const Eigen::ArrayXd value = 0.5 * above.square() + least_weight * (s - above);
    return plain.dot(value.matrix()) - target.dot(multiplier) + 0.5 * ridge * multiplier.squaredNorm();
  }
};

/// Monomials that depend on others on these points are left out.
Problem make_problem(const Eigen::MatrixXd& monomial, const Multipliers& moments, const Eigen::VectorXd& plain) {
  constexpr double dependent = 1e-10;
  const Eigen::VectorXd root = plain.cwiseSqrt();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(root.asDiagonal() * monomial.transpose());
  qr.setThreshold(dependent);
  const Eigen::Index rank = qr.rank();
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(plain.size(), rank);
  const Eigen::VectorXd ordered = qr.colsPermutation().transpose() * moments;
  return {
      .row = (root.cwiseInverse().asDiagonal() * q).transpose(),
      .target =
          qr.matrixR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>().transpose().solve(ordered.head(rank)),
      .plain = plain};
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
void advance(const Problem& problem, const Eigen::VectorXd& growth, const Multipliers& gradient,
             Multipliers& multiplier) {
  const Eigen::VectorXd free =
      (growth.array() > least_weight).select(problem.plain, Eigen::VectorXd::Zero(growth.size()));
  Gram hessian = problem.row * free.asDiagonal() * problem.row.transpose();
  hessian.diagonal().array() += ridge;
  const Multipliers step = -hessian.ldlt().solve(gradient);
  const double before = problem.merit(multiplier);
  double share = 1.0;
  while (share > 1e-6 && problem.merit(multiplier + share * step) > before + 1e-4 * share * gradient.dot(step))
    share *= 0.5;
  multiplier += share * step;
}

/// Weights that reproduce all moments up to an order, or none where no weights above the bound do.
std::optional<Eigen::VectorXd> weights_for(const Wanted& wanted, int order, const Eigen::VectorXd& plain) {
  const Eigen::Index rows = monomials(order);
  const Problem problem = make_problem(wanted.monomial.topRows(rows), wanted.moment.head(rows), plain);
  Multipliers multiplier = Multipliers::Zero(problem.target.size());
  for (int k = 0; k < most_steps; ++k) {
    const Eigen::VectorXd growth = problem.growth(multiplier);
    const Multipliers rest = problem.rest(growth);
    if (rest.cwiseAbs().maxCoeff() <= wanted.met) {
      Eigen::VectorXd weight = problem.weights(growth);
      const Multipliers missed = wanted.monomial.topRows(rows) * weight - wanted.moment.head(rows);
      if (missed.cwiseAbs().maxCoeff() > wanted.met) return std::nullopt;  // one that was left out
      return weight;
    }
    advance(problem, growth, rest + ridge * multiplier, multiplier);
  }
  return std::nullopt;
}

}  // namespace

int fit_weights(const Eigen::Ref<const Eigen::Matrix2Xd>& x, double size,
                const Eigen::Ref<const Eigen::VectorXd>& moments, Eigen::Ref<Eigen::VectorXd> weight) {
  const Eigen::VectorXd plain = weight / weight.sum();
  const Wanted wanted(x, size, moments);
  weight = moments[0] * plain;
  for (int order = order_of(moments.size()); order > 0; --order) {
    if (wanted.reproduced(order, plain)) return order;
    if (points_for(order) > x.cols()) continue;
    if (const auto fitted = weights_for(wanted, order, plain)) {
      weight = moments[0] * *fitted;
      return order;
    }
  }
  return 0;
}

}  // namespace shoreline
