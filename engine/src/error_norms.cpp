#include "shoreline/engine/error_norms.hpp"

#include <algorithm>
#include <cmath>

namespace shoreline {
namespace {

constexpr double vanishing = 1e-12;  ///< of the largest exact value: below it no relative error is formed

/// Norms of one field: computed and exact values, one column a point.
template <std::size_t Components>
void field_norms(const Eigen::MatrixXd& computed, const Eigen::MatrixXd& exact, const Eigen::VectorXd& volume,
                 std::array<ErrorNorms::Component, Components>& components, std::optional<double>& l2_relative) {
  const Eigen::MatrixXd difference = (computed - exact).cwiseAbs();
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
  const double norm = exact.colwise().squaredNorm().dot(volume);
  if (norm > 0.0) l2_relative = std::sqrt(difference.colwise().squaredNorm().dot(volume) / norm);
}

}  // namespace

ErrorNorms error_norms(const MaterialPoints& points, const ExactSolution& exact, double t) {
  Eigen::MatrixXd displacement(2, points.size());
  Eigen::MatrixXd stress(3, points.size());
  for (Index p = 0; p < points.size(); ++p) {
    const Vec2 origin = points.position.col(p) - points.displacement.col(p);
    displacement.col(p) = exact.displacement(origin, t);
    stress.col(p) = exact.stress(origin, t);
  }
  ErrorNorms norms;
  field_norms(points.displacement, displacement, points.volume, norms.displacement, norms.displacement_l2_relative);
  field_norms(points.stress.topRows<3>(), stress, points.volume, norms.stress, norms.stress_l2_relative);
  return norms;
}

double boundary_error(const SplineCurve& original, const SplineCurve& now, bool normal_only, const ExactSolution& exact,
                      double t) {
  const QuadratureRule rule = gauss(4);
  double sum = 0.0;
  for (std::size_t k = 0; k < now.spans.size(); ++k)
    for (Eigen::Index q = 0; q < rule.point.size(); ++q) {
      const double u = rule.point[q];
      const Vec2 origin = original.spans[k].position(u);
      const Vec2 tangent = now.spans[k].derivative(u);
      const Vec2 error = now.spans[k].position(u) - origin - exact.displacement(origin, t);
      const double size = normal_only ? cross(tangent, error) / tangent.norm() : error.norm();
      sum += rule.weight[q] * tangent.norm() * size * size;
    }
  return std::sqrt(sum);
}

}  // namespace shoreline
