#include "critical_step.hpp"

#include <cmath>
#include <limits>
#include <random>

namespace shoreline {
namespace {

constexpr double loose = 1e-4;      ///< of a right side: how far the mass is solved within the iteration
constexpr double settled = 1e-3;    ///< change of λ at which it ends
constexpr double admixture = 0.01;  ///< of every mode, so that one that is new is found

}  // namespace

double CriticalStep::measure(PointPasses& passes, const VibratingBody& body, int most) {
  std::minstd_rand random(1);
  const auto number = [&] { return 2.0 * static_cast<double>(random()) / std::minstd_rand::max() - 1.0; };
  const auto functions = static_cast<Index>(body.mass.row_sum().size());
  const bool fresh = mode_.cols() != functions;
  if (fresh) mode_ = Eigen::Matrix2Xd::Zero(2, functions);
  for (Index f = 0; f < functions; ++f)
    for (int k = 0; k < 2; ++k)
      mode_(k, f) = body.mass.row_sum()[f] > 0.0 ? mode_(k, f) + (fresh ? 1.0 : admixture) * number() : 0.0;
  double eigenvalue = 0.0;
  for (int k = 0; k < most; ++k, ++iterations_) {
    body.held.set(mode_, 1.0);
    passes.stiffness_times(body.points, body.cells, body.law, mode_, force_);
    const double stiffness = mode_.cwiseProduct(force_).sum();
    const double inertia = mode_.cwiseProduct(body.mass.times(mode_)).sum();
    const double before = std::exchange(eigenvalue, inertia > 0.0 ? stiffness / inertia : 0.0);
    if (!(eigenvalue > 0.0)) break;
    body.mass.solve(body.held, force_, mode_, loose);
    mode_ /= mode_.cwiseAbs().maxCoeff();
    if (std::abs(eigenvalue - before) < settled * eigenvalue) break;
  }
  return eigenvalue > 0.0 ? 2.0 / std::sqrt(eigenvalue) : std::numeric_limits<double>::infinity();
}

Index CriticalStep::most_moved() const {
  Eigen::Index most = 0;
  mode_.colwise().squaredNorm().maxCoeff(&most);
  return static_cast<Index>(most);
}

}  // namespace shoreline
