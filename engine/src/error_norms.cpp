#include "shoreline/engine/error_norms.hpp"

#include <algorithm>
#include <cmath>

#include "shoreline/bases/counters.hpp"

namespace shoreline {
namespace {

constexpr double vanishing = 1e-12;  ///< of the largest exact value: below it no relative error is formed

/// Distances from the origin at 1000 points that are evenly spread over the knots' parameter.
Eigen::VectorXd sampled_radii(const SplineCurve& curve) {
  Eigen::VectorXd radii(1000);
  std::size_t span = 0;
  for (Eigen::Index k = 0; k < radii.size(); ++k) {
    const double at = curve.knots.back() * (static_cast<double>(k) + 0.5) / static_cast<double>(radii.size());
    while (curve.knots[span + 1] < at) ++span;
    const double u = (at - curve.knots[span]) / (curve.knots[span + 1] - curve.knots[span]);
    radii[k] = curve.spans[span].position(u).norm();
  }
  return radii;
}

struct L2 {
  double absolute = 0.0;
  std::optional<double> relative;
};

/// Norms of one field by component: the size of the errors and exact values, one column a point.
template <std::size_t Components>
std::array<ErrorNorms::Component, Components> component_norms(const Eigen::MatrixXd& difference,
                                                              const Eigen::MatrixXd& exact,
                                                              const Eigen::VectorXd& volume) {
  std::array<ErrorNorms::Component, Components> components;
  const double largest = exact.cwiseAbs().maxCoeff();
  for (std::size_t c = 0; c < Components; ++c) {
    const auto row = static_cast<Eigen::Index>(c);
    const Eigen::VectorXd error = difference.row(row);
    const Eigen::VectorXd size = exact.row(row).cwiseAbs();
    components[c].mean_absolute = error.dot(volume) / volume.sum();
    components[c].max_absolute = error.maxCoeff();
    if (size.minCoeff() > vanishing * largest)
      components[c].mean_relative = error.cwiseQuotient(size).dot(volume) / volume.sum();
  }
  return components;
}

/// Likewise of the whole vector.
L2 l2_norms(const Eigen::MatrixXd& difference, const Eigen::MatrixXd& exact, const Eigen::VectorXd& volume) {
  const double error = difference.colwise().squaredNorm().dot(volume);
  const double norm = exact.colwise().squaredNorm().dot(volume);
  const bool vanishes = norm <= vanishing * vanishing * error || norm == 0.0;  // but for rounding
  return {std::sqrt(error), vanishes ? std::nullopt : std::optional(std::sqrt(error / norm))};
}

}  // namespace

ErrorNorms error_norms(const MaterialPoints& points, const ExactSolution& exact, double t) {
  count(Work::exact_values, points.size());
  Eigen::MatrixXd displacement(2, points.size());
  Eigen::MatrixXd stress(3, points.size());
  for (Index p = 0; p < points.size(); ++p) {
    const Vec2 origin = points.position.col(p) - points.displacement.col(p);
    displacement.col(p) = exact.displacement(origin, t);
    stress.col(p) = exact.stress(origin, t);
  }
  ErrorNorms norms;
  norms.places = points.size();
  const Eigen::MatrixXd of_displacement = (points.displacement - displacement).cwiseAbs();
  const L2 l2_of_displacement = l2_norms(of_displacement, displacement, points.volume);
  norms.displacement = component_norms<2>(of_displacement, displacement, points.volume);
  norms.displacement_l2 = l2_of_displacement.absolute;
  norms.displacement_l2_relative = l2_of_displacement.relative;
  const Eigen::MatrixXd of_stress = (points.stress.topRows<3>() - stress).cwiseAbs();
  const L2 l2_of_stress = l2_norms(of_stress, stress, points.volume);
  norms.stress = component_norms<3>(of_stress, stress, points.volume);
  norms.stress_l2 = l2_of_stress.absolute;
  norms.stress_l2_relative = l2_of_stress.relative;
  return norms;
}

std::optional<RadiusError> radius_error(const SplineCurve& original, const SplineCurve& now, const ExactSolution& exact,
                                        double t) {
  constexpr double arc = 1e-3;
  const Vec2 start = original.spans.front().position(0.0);
  const Eigen::ArrayXd before = sampled_radii(original);
  if (!((before / start.norm() - 1.0).abs().maxCoeff() < arc)) return std::nullopt;
  const double radius = start.norm() + exact.displacement(start, t).dot(start.normalized());
  const Eigen::ArrayXd after = sampled_radii(now);
  return RadiusError{after.mean(), radius, (after - radius).abs().mean() / radius};
}

}  // namespace shoreline
