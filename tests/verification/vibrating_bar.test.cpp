// The bar fixed at both ends: de Koster 2018, tables 4.2 and 4.3, and de Koster et al. 2020, §4.1.

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "../motion.hpp"

using namespace shoreline;

namespace {

double error_of_blocks(const std::string& basis, int blocks) {
  return test::Motion("vibrating_bar/small.json",
                      {"grid.basis=" + basis, "grid.cell_size=[" + std::to_string(25.0 / blocks) + ",2]"})
      .compute()
      .errors()
      .displacement_l2;
}

}  // namespace

// The figures are those of independent prototypes, against which the thesis's own (3.71e-4, 3.14e-5, 3.57e-6, 4.90e-7
// and 1.81e-4, 4.44e-5, 1.075e-5) differ by up to 5 %.
TEST_CASE("the small bar has the errors of the thesis's tables on Powell-Sabin splines and on linear triangles",
          "[verification][dynamics]") {
  for (const auto& [blocks, expected] : std::map<int, double>{{1, 3.80e-4}, {2, 3.22e-5}, {4, 3.62e-6}, {8, 4.71e-7}}) {
    CAPTURE(blocks);
    CHECK(error_of_blocks("powell_sabin", blocks) == Approx(expected).epsilon(0.06));
  }
  for (const auto& [blocks, expected] : std::map<int, double>{{4, 1.810e-4}, {8, 4.443e-5}, {16, 1.106e-5}}) {
    CAPTURE(blocks);
    CHECK(error_of_blocks("linear", blocks) == Approx(expected).epsilon(0.05));
  }
}

TEST_CASE("the bar at 7 % strain follows its exact motion for 20 s within 1 % and keeps its energy within 1 %",
          "[verification][dynamics]") {
  const test::Motion bar = test::Motion("vibrating_bar/large.json", {}).compute();
  const double amplitude = 0.1 / (M_PI * std::sqrt(2.0));
  CHECK(bar.over_time("displacement").rms <= 0.01 * amplitude);
  const double start = bar.record.history.front().total();
  for (const HistoryState& state : bar.record.history) CHECK(std::abs(state.total() - start) <= 0.01 * start);
  CHECK(bar.record.history.size() == 401);
}
