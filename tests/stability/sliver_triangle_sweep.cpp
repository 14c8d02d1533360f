#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bodies.hpp"
#include "sweeps.hpp"

namespace shoreline::test {

std::vector<Row> sliver_triangle_sweep(int offsets) {
  constexpr double width = 0.125;
  std::vector<Row> rows;
  for (const EssentialMethod method : both_methods())
    for (const Case::BasisType basis : {Case::BasisType::linear, Case::BasisType::powell_sabin})
      for (const double degrees : {45.0, 20.0, 10.0, 5.0, 2.0, 1.001, 0.9}) {
        Case problem = bending(sides(rectangle(4.0 * width, 4.0 * width, 0.4)), width);
        problem.grid.cell_size.y() = width * std::tan(degrees * std::numbers::pi / 180.0);
        Discretisation on = remedied(basis, 1, method);
        on.per_cell = 2;
        rows.push_back(over_offsets(fmt::format("smallest angle {:g}°", degrees), problem, on, offsets));
      }
  return rows;
}

}  // namespace shoreline::test
