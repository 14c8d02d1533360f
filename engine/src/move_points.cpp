#include "move_points.hpp"

#include "threads.hpp"

namespace shoreline {
namespace {

/// Brings stresses, which a step updates with the points' own dilatation, to the projected one, (I.6).
void project_stresses(const StepMotion& motion, const PointSupports& supports, MaterialPoints& points) {
  const Eigen::RowVectorXd correction = motion.dilatation->correction(points, supports, motion.increment);
  for (const Eigen::Index normal : {0, 1, 3}) points.stress.row(normal) += correction;
}

}  // namespace

void move_points(const StepMotion& motion, const PointSupports& supports, MaterialPoints& points) {
  if (motion.dilatation != nullptr) project_stresses(motion, supports, points);
  const auto n = static_cast<std::size_t>(supports.functions);
#pragma omp parallel for schedule(static) if (worth_threads(supports.point.size()))
  for (Index c = 0; c < supports.cells(); ++c) {
    const auto cell = static_cast<std::size_t>(c);
    const ShortIndices functions = motion.basis.functions_of(supports.cell[cell]);
    for (auto k = static_cast<std::size_t>(supports.first[cell]);
         k < static_cast<std::size_t>(supports.first[cell + 1]); ++k) {
      Vec2 displacement = Vec2::Zero();
      Vec3 strain = Vec3::Zero();
      for (std::size_t a = 0; a < n; ++a) {
        const Vec2 d = motion.increment.col(functions[static_cast<Eigen::Index>(a)]);
        const double gx = supports.gradient[2 * (k * n + a)];
        const double gy = supports.gradient[2 * (k * n + a) + 1];
        displacement += supports.value[k * n + a] * d;
        strain += Vec3(gx * d.x(), gy * d.y(), gy * d.x() + gx * d.y());
      }
      const Index p = supports.point[k];
      points.position.col(p) += displacement;
      points.displacement.col(p) += displacement;
      points.strain.col(p) += strain;
      points.stress.col(p) = motion.material.updated(points.stress.col(p), strain);
    }
  }
}

}  // namespace shoreline
