// The column under its own weight with weights that are fitted to its outline at every step.

#include <catch2/catch.hpp>
#include <cmath>

#include "../self_weight_column.hpp"

using namespace shoreline;

namespace {

/// Root of the mean over the points of their acceleration in the squeezed column at rest, in parts of g.
double spurious_acceleration(int rows, const std::string& volumes) {
  Case problem = test::column_case(rows, {"analysis.time_step=1e-7", "analysis.end_time=1e-7", "analysis.transfer=flip",
                                          "material_points.volumes=" + volumes});
  test::Motion motion(build_dynamic_scene(problem));
  test::squeeze(motion.scene);
  motion.compute();
  const auto points = static_cast<double>(motion.scene.body.points.size());
  return motion.scene.motion.velocity.norm() / std::sqrt(points) / 1e-7 / 9.81;
}

}  // namespace

TEST_CASE(
    "the squeezed column stays at rest with fitted weights; with volumes it is torn by more than g/2, twice that "
    "on every finer grid",
    "[verification][dynamics][fitted]") {
  double before = 0.0;
  for (const int rows : {8, 16, 32}) {
    const double plain = spurious_acceleration(rows, "clipped");
    const double fitted = spurious_acceleration(rows, "fitted");
    CAPTURE(rows, plain, fitted);
    CHECK(fitted < 0.02);
    CHECK(plain > 0.5);
    CHECK(plain > 1.7 * before);
    before = plain;
  }
}
