#include "move_points.hpp"

#include <array>

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

/// The motion in a cell whose functions are products: one polynomial, Σ c_rs ξ^r η^s.
template <int P>
class ProductMotion {
 public:
  ProductMotion(const StepMotion& motion, const ProductCell& cell, const ShortIndices& functions)
      : corner_(cell.corner), inverse_(cell.size.cwiseInverse()) {
    using Factors = Eigen::Matrix<double, P + 1, P + 1>;
    const Eigen::Map<const Factors> x(cell.x.data());
    const Eigen::Map<const Factors> y(cell.y.data());
    for (const Eigen::Index component : {0, 1}) {
      Factors d;
      for (Eigen::Index a = 0; a < functions.size(); ++a) d.data()[a] = motion.increment(component, functions[a]);
      const Factors in_x = x.transpose().lazyProduct(d);
      const Factors c = in_x.lazyProduct(y);
      for (int r = 0; r <= P; ++r)
        for (int s = 0; s <= P; ++s) coefficient_[r][s][component] = c(r, s);
    }
  }

  /// Horner's scheme in η for each power of ξ, and then in ξ.
  [[nodiscard]] Motion at(const Vec2& x) const {
    const Vec2 xi = (x - corner_).cwiseProduct(inverse_);
    Vec2 u = Vec2::Zero(), along_x = Vec2::Zero(), along_y = Vec2::Zero();
    for (int r = P; r >= 0; --r) {
      Vec2 f = coefficient_[r][P];
      Vec2 slope = Vec2::Zero();
      for (int s = P - 1; s >= 0; --s) {
        slope = slope * xi.y() + f;
        f = f * xi.y() + coefficient_[r][s];
      }
      along_x = along_x * xi.x() + u;
      along_y = along_y * xi.x() + slope;
      u = u * xi.x() + f;
    }
    Motion motion{u, {}};
    motion.gradient << along_x * inverse_.x(), along_y * inverse_.y();
    return motion;
  }

 private:
  Vec2 corner_;
  Vec2 inverse_;
  std::array<std::array<Vec2, P + 1>, P + 1> coefficient_;
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
      const Index cell = supports.cell[static_cast<std::size_t>(c)];
      const auto first = static_cast<std::size_t>(supports.first[static_cast<std::size_t>(c)]);
      const auto last = static_cast<std::size_t>(supports.first[static_cast<std::size_t>(c) + 1]);
      const auto move_by = [&](const auto& motion_at_point) {
        for (std::size_t k = first; k < last; ++k)
          move_point(motion_at_point(k), motion.material, supports.point[k], points);
      };
      const auto move_in = [&](const auto& here) {
        move_by([&](std::size_t k) { return here.at(supports.place[k]); });
      };
      const ShortIndices functions = motion.basis.functions_of(cell);
      if (linear) {
        move_in(LinearMotion(motion, cell, supports.place[first], functions));
      } else if (const auto product = motion.basis.product_cell(cell); product && functions.size() == 9) {
        move_in(ProductMotion<2>(motion, *product, functions));
      } else if (product && functions.size() == 16) {
        move_in(ProductMotion<3>(motion, *product, functions));
      } else {
        ShortGradients d(2, functions.size());
        for (Eigen::Index a = 0; a < functions.size(); ++a) d.col(a) = motion.increment.col(functions[a]);
        basis.evaluate(c);
        move_by([&](std::size_t k) {
          return motion_at(d, basis.value(static_cast<Index>(k)), basis.gradient(static_cast<Index>(k)));
        });
      }
    }
  }
}

}  // namespace shoreline
