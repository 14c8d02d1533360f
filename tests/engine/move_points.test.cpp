#include "../../engine/src/move_points.hpp"

#include <catch2/catch.hpp>

#include "../scattered_points.hpp"
#include "shoreline/engine/linear_elastic.hpp"

using namespace shoreline;

namespace {

/// Largest differences of what points gain to the field and its gradient there, over the field's size.
struct Difference {
  double displacement = 0.0;
  double strain = 0.0;
};

Difference difference(const Scene& scene, const Eigen::Matrix2Xd& field) {
  const PointSupports supports = locate_points(*scene.basis, scene.points);
  MaterialPoints moved = scene.points;
  moved.strain = Eigen::Matrix3Xd::Zero(3, moved.size());
  move_points({*scene.basis, *scene.material, field, nullptr}, supports, moved);
  Difference largest;
  for (std::size_t c = 0; c < supports.cell.size(); ++c)
    for (Index k = supports.first[c]; k < supports.first[c + 1]; ++k) {
      const Index p = supports.point[static_cast<std::size_t>(k)];
      const Support here = scene.basis->support(supports.cell[c], scene.points.position.col(p));
      const Mat2 g = here.gradient_of(field);
      const Vec3 strain(g(0, 0), g(1, 1), g(0, 1) + g(1, 0));
      const Vec2 u = here.interpolate(field);
      largest.displacement =
          std::max({largest.displacement, (moved.displacement.col(p) - scene.points.displacement.col(p) - u).norm(),
                    (moved.position.col(p) - scene.points.position.col(p) - u).norm()});
      largest.strain = std::max(largest.strain, (moved.strain.col(p) - strain).norm());
    }
  return largest;
}

}  // namespace

TEST_CASE("points move by the field and strain by its gradient where they were located, on every basis",
          "[engine][move_points]") {
  test::Random random(9);
  for (const test::NamedGrid& grid : test::every_grid(Vec2(-3.0, 5.0), 2.0, 4)) {
    CAPTURE(grid.name);
    Scene scene = test::scattered(grid.grid, 200, random);
    const Eigen::Matrix2Xd field = random.field(scene.basis->functions());  // numbers up to 1, gradients up to 10
    const Difference known = difference(scene, field);
    CHECK(known.displacement <= 1e-14);
    CHECK(known.strain <= 1e-12);
    scene.basis = std::make_unique<test::EvaluatedBasis>(std::move(scene.basis));
    const Difference evaluated = difference(scene, field);
    CHECK(evaluated.displacement <= 1e-14);
    CHECK(evaluated.strain <= 1e-12);
  }
}
