#include "move_points.hpp"

#include "linear_cell.hpp"
#include "threads.hpp"

namespace shoreline {
namespace {

/// Brings stresses, which a step updates with the points' own dilatation, to the projected one, (I.6).
void project_stresses(const StepMotion& motion, const PointSupports& supports, MaterialPoints& points) {
  const Eigen::RowVectorXd correction = motion.dilatation->correction(points, supports, motion.increment);
  for (const Eigen::Index normal : {0, 1, 3}) points.stress.row(normal) += correction;
}

/// Displacement [m] and its gradient, ∂u_i/∂x_j, at one place.
struct Motion {
  Vec2 displacement;
  Mat2 gradient;
};

/// The motion in a cell with linear gradients. A quadratic displacement follows from the mean of its gradients at both
/// ends of a line: u(x) = u(x₀) + ½ (∇u(x₀) + ∇u(x)) (x − x₀).
class LinearMotion {
 public:
  LinearMotion(const StepMotion& motion, Index cell, const Vec2& origin, const ShortIndices& functions)
      : cell_(motion.basis, cell, origin) {
    for (Eigen::Index a = 0; a < functions.size(); ++a) {
      const Vec2 d = motion.increment.col(functions[a]);
      start_ += cell_.value[static_cast<std::size_t>(a)] * d;
      for (std::size_t place = 0; place < 3; ++place)
        gradient_[place] += d * Eigen::Map<const Eigen::RowVector2d>(
                                    &cell_.gradient[2 * (place * static_cast<std::size_t>(functions.size()) +
                                                         static_cast<std::size_t>(a))]);
    }
    gradient_[1] -= gradient_[0];
    gradient_[2] -= gradient_[0];
  }

  [[nodiscard]] Motion at(const Vec2& x) const {
    const Vec2 xi = cell_.local(x);
    const Mat2 gradient = gradient_[0] + xi.x() * gradient_[1] + xi.y() * gradient_[2];
    return {start_ + 0.5 * (gradient_[0] + gradient) * (x - cell_.origin), gradient};
  }

 private:
  LinearCell cell_;
  Vec2 start_ = Vec2::Zero();
  std::array<Mat2, 3> gradient_{Mat2::Zero(), Mat2::Zero(), Mat2::Zero()};  ///< at the origin, and what ξ, η add
};

/// @param d  (2, n) increments of the functions here
Motion motion_at(const ShortGradients& d, const double* value, const double* gradient) {
  Motion sum{Vec2::Zero(), Mat2::Zero()};
  for (Eigen::Index a = 0; a < d.cols(); ++a) {
    sum.displacement += value[a] * d.col(a);
    sum.gradient.col(0) += gradient[2 * a] * d.col(a);
    sum.gradient.col(1) += gradient[2 * a + 1] * d.col(a);
  }
  return sum;
}

void move_point(const Motion& motion, const Material& material, Index p, MaterialPoints& points) {
  const Mat2& g = motion.gradient;
  const Vec3 strain(g(0, 0), g(1, 1), g(0, 1) + g(1, 0));
  points.position.col(p) += motion.displacement;
  points.displacement.col(p) += motion.displacement;
  if (points.strain.cols() > 0) points.strain.col(p) += strain;
  points.stress.col(p) = material.updated(points.stress.col(p), strain);
}

}  // namespace

void move_points(const StepMotion& motion, const PointSupports& supports, MaterialPoints& points) {
  if (motion.dilatation != nullptr) project_stresses(motion, supports, points);
  const bool linear = motion.basis.gradient_degree() <= 1;
#pragma omp parallel if (worth_threads(supports.point.size()))
  {
    BasisAtPoints basis(motion.basis, supports);
#pragma omp for schedule(static)
    for (Index c = 0; c < supports.cells(); ++c) {
      const auto cell = static_cast<std::size_t>(c);
      const auto first = static_cast<std::size_t>(supports.first[cell]);
      const auto last = static_cast<std::size_t>(supports.first[cell + 1]);
      const ShortIndices functions = motion.basis.functions_of(supports.cell[cell]);
      if (linear) {
        const LinearMotion here(motion, supports.cell[cell], supports.place[first], functions);
        for (std::size_t k = first; k < last; ++k)
          move_point(here.at(supports.place[k]), motion.material, supports.point[k], points);
        continue;
      }
      ShortGradients d(2, functions.size());
      for (Eigen::Index a = 0; a < functions.size(); ++a) d.col(a) = motion.increment.col(functions[a]);
      basis.evaluate(c);
      for (std::size_t k = first; k < last; ++k) {
        const auto at = static_cast<Index>(k);
        move_point(motion_at(d, basis.value(at), basis.gradient(at)), motion.material, supports.point[k], points);
      }
    }
  }
}

}  // namespace shoreline
