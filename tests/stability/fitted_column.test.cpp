// The column under its own weight with weights that are fitted to its outline at every step.

#include <catch2/catch.hpp>
#include <cmath>

#include "../moving_bodies.hpp"
#include "../self_weight_column.hpp"
#include "sweeps.hpp"

using namespace shoreline;

TEST_CASE(
    "with fitted weights the column's errors fall with the grid: u 0.25 %, v 1.4 %, stress 1.6 % on 8 blocks, "
    "0.1 %, 0.45 % and 0.45 % on 16, with volumes velocities do not gain",
    "[stability][dynamics][fitted]") {
  const test::ColumnErrors coarse = test::column_errors(8, "fitted");
  CHECK(coarse.u <= 0.0025);
  CHECK(coarse.v <= 0.014);
  CHECK(coarse.stress <= 0.016);
  const test::ColumnErrors fine = test::column_errors(16, "fitted");
  CHECK(fine.u <= 0.001);
  CHECK(fine.v <= 0.0045);
  CHECK(fine.stress <= 0.0045);
  CHECK(coarse.v > 1.8 * fine.v);
  for (const test::ColumnErrors& fitted : {coarse, fine}) CHECK(fitted.energy < 0.005);
  const test::ColumnErrors plain = test::column_errors(8, "clipped");
  const test::ColumnErrors plain_fine = test::column_errors(16, "clipped");
  CAPTURE(plain.u, plain.v, plain.stress, plain_fine.u, plain_fine.v, plain_fine.stress, coarse.energy);
  CHECK(plain.v < 1.3 * plain_fine.v);
}

TEST_CASE("fitted weights keep the balance of momentum of the column", "[stability][dynamics][fitted]") {
  DynamicScene scene = build_dynamic_scene(
      test::column_case(8, {"material_points.volumes=fitted", "analysis.time_step=1e-3", "analysis.end_time=0.1"}));
  CHECK(test::worst_imbalance(scene) < 5e-12);
}

TEST_CASE("on linear triangles with a lumped mass fitted weights make the column converge, which without it does not",
          "[stability][dynamics][fitted]") {
  const std::vector<std::string> cheap{"grid.basis=linear", "analysis.mass=lumped", "analysis.transfer=flip"};
  const auto error = [&](int rows, const std::string& volumes) {
    std::vector<std::string> keys = cheap;
    keys.push_back("material_points.volumes=" + volumes);
    const test::Motion motion = test::Motion(build_dynamic_scene(test::column_case(rows, keys))).compute();
    return motion.over_time("displacement").mean_rms / test::column_kappa;
  };
  const double coarse = error(8, "fitted"), fine = error(16, "fitted");
  CHECK(coarse < 0.02);
  CHECK(fine < 0.4 * coarse);
  const double plain = error(8, "clipped");
  CHECK(plain > 0.05);
  CHECK(error(16, "clipped") > plain);
}

TEST_CASE(
    "the squeezed column stays at rest with fitted weights, with volumes it is torn by more than g/2, twice that "
    "on every finer grid",
    "[stability][dynamics][fitted]") {
  double before = 0.0;
  for (const int rows : {8, 16, 32}) {
    const double plain = test::spurious_acceleration(rows, "clipped");
    const double fitted = test::spurious_acceleration(rows, "fitted");
    CAPTURE(rows, plain, fitted);
    CHECK(fitted < 0.02);
    CHECK(plain > 0.5);
    CHECK(plain > 1.7 * before);
    before = plain;
  }
}
