#pragma once
// The L2 projection of sin πx sin πy onto a basis of triangles, integrated exactly to degree 11.

#include <Eigen/SparseCholesky>
#include <cmath>
#include <numbers>

#include "shoreline/bases/basis.hpp"
#include "shoreline/bases/quadrature.hpp"

namespace shoreline::test {

struct ProjectionError {
  double value;    ///< ‖f_h − f‖ in L2
  double x_slope;  ///< ‖∂x f_h − ∂x f‖
};

/// Calls visit(cell, support, x, weight) at the points of a Gauss rule on each triangle, collapsed from the square.
void integrate(const Basis& basis, auto&& visit) {
  const QuadratureRule rule = gauss(7);
  for (Index cell = 0; cell < basis.grid().cells(); ++cell) {
    const std::vector<Vec2> p = basis.grid().polygon(cell);
    const double twice_area = cross(p[1] - p[0], p[2] - p[0]);
    for (Eigen::Index i = 0; i < rule.point.size(); ++i)
      for (Eigen::Index j = 0; j < rule.point.size(); ++j) {
        const double r = rule.point[i];
        const Vec2 x = p[0] + r * (p[1] - p[0] + rule.point[j] * (p[2] - p[1]));
        visit(basis.support(cell, x), x, rule.weight[i] * rule.weight[j] * r * twice_area);
      }
  }
}

inline ProjectionError project_sines(const Basis& basis) {
  const auto f = [](const Vec2& x) { return std::sin(std::numbers::pi * x.x()) * std::sin(std::numbers::pi * x.y()); };
  const auto f_x = [](const Vec2& x) {
    return std::numbers::pi * std::cos(std::numbers::pi * x.x()) * std::sin(std::numbers::pi * x.y());
  };
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(basis.functions());
  integrate(basis, [&](const Support& support, const Vec2& x, double weight) {
    for (Eigen::Index a = 0; a < support.value.size(); ++a) {
      load[support.function[a]] += weight * support.value[a] * f(x);
      for (Eigen::Index b = 0; b < support.value.size(); ++b)
        entries.emplace_back(support.function[a], support.function[b], weight * support.value[a] * support.value[b]);
    }
  });
  Eigen::SparseMatrix<double> mass(basis.functions(), basis.functions());
  mass.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd coefficient = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(mass).solve(load);

  ProjectionError square{0.0, 0.0};
  integrate(basis, [&](const Support& support, const Vec2& x, double weight) {
    double value = -f(x);
    double slope = -f_x(x);
    for (Eigen::Index a = 0; a < support.value.size(); ++a) {
      value += coefficient[support.function[a]] * support.value[a];
      slope += coefficient[support.function[a]] * support.gradient(0, a);
    }
    square.value += weight * value * value;
    square.x_slope += weight * slope * slope;
  });
  return {std::sqrt(square.value), std::sqrt(square.x_slope)};
}

}  // namespace shoreline::test
