// Where the grid lies must not matter.
#include <algorithm>
#include <catch2/catch.hpp>

#include "../example_run.hpp"
#include "../random.hpp"

using namespace shoreline;

TEST_CASE("the grid's origin changes the plate's error by at most a factor of two", "[stability][plate]") {
  constexpr double h = 0.125;
  for (const char* file : {"plate_with_hole/neumann.json", "plate_with_hole/dirichlet.json"}) {
    test::Random random(11);
    std::vector<double> u, v;
    for (int draw = 0; draw < 20; ++draw) {
      const Vec2 lower = h * random.vector(-1.0, 0.0);
      CAPTURE(file, lower.transpose());
      const ErrorNorms norms = test::errors_of_example(
          file, {"grid.cell_size=0.125", "ghost=0.001",
                 "grid.lower=[" + std::to_string(lower.x()) + "," + std::to_string(lower.y()) + "]"});
      u.push_back(norms.displacement[0].mean_absolute);
      v.push_back(norms.displacement[1].mean_absolute);
    }
    for (const auto& errors : {u, v}) {
      CAPTURE(file, errors);
      CHECK(std::ranges::max(errors) <= 2.0 * std::ranges::min(errors));
    }
  }
}
