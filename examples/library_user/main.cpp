// A code with a material law of its own that takes only its boundary from Shoreline: no engine, no case file.
//
// A body with a curved edge is stretched uniformly. The tractions of the stress that follows are integrated along the
// edge as forces on the grid. They must have no resultant, and their work must be the work of the stress in the body.

#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "shoreline/bases/bilinear.hpp"
#include "shoreline/boundary/trace.hpp"

using shoreline::Mat2;
using shoreline::Vec2;

/// Our own law: compressible neo-Hookean, Cauchy stress [Pa] of a deformation gradient.
static Mat2 cauchy_stress(const Mat2& f) {
  const double mu = 4e6;
  const double lambda = 6e6;
  const double j = f.determinant();
  return (mu * (f * f.transpose() - Mat2::Identity()) + lambda * std::log(j) * Mat2::Identity()) / j;
}

int main() {
  // The edge: 24 points of a flower, the material to its left.
  shoreline::Piece edge{.name = "flower", .closed = true};
  for (int k = 0; k < 24; ++k) {
    const double angle = 2 * std::numbers::pi * k / 24;
    edge.points.emplace_back((1 + 0.2 * std::cos(4 * angle)) * Vec2(std::cos(angle), std::sin(angle)));
  }

  // The grid and its basis; a grid of our own would do as well, derived from shoreline::Grid and shoreline::Basis.
  const shoreline::BilinearBasis basis({Vec2(-1.5, -1.5), Vec2(0.25, 0.25), {12, 12}});

  const shoreline::SplineCurve curve = fit_spline(edge);
  const auto points = boundary_points(curve, trace(curve, basis.grid(), edge.name), shoreline::gauss(4));

  // The motion u = H x by its coefficients on the grid, and its stress.
  Mat2 h;
  h << 0.1, 0.05, 0.0, -0.02;
  Eigen::Matrix2Xd u(2, basis.functions());
  for (shoreline::Index i = 0; i < basis.functions(); ++i) u.col(i) = h * basis.control_point(i);
  const Mat2 stress = cauchy_stress(Mat2::Identity() + h);

  Eigen::Matrix2Xd force = Eigen::Matrix2Xd::Zero(2, basis.functions());
  double area = 0.0;
  for (const shoreline::BoundaryPoint& p : points) {
    const Vec2 outward = -p.normal;
    const shoreline::Support support = basis.support(p.cell, p.x);
    for (Eigen::Index a = 0; a < support.function.size(); ++a)
      force.col(support.function[a]) += support.value[a] * p.weight * (stress * outward);
    area += 0.5 * p.weight * p.x.dot(outward);
  }

  const Vec2 resultant = force.rowwise().sum();
  const double work = force.cwiseProduct(u).sum();
  const double expected = area * stress.cwiseProduct(h).sum();
  std::printf("area %.4f from %zu boundary points\n", area, points.size());
  std::printf("resultant %.4f %.4f\n", std::abs(resultant.x()), std::abs(resultant.y()));
  std::printf("work on the edge %.6e, in the body %.6e\n", work, expected);
  return std::abs(work - expected) < 1e-9 * std::abs(expected) ? 0 : 1;
}
