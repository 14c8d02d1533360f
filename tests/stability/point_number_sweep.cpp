#include <fmt/format.h>

#include "bodies.hpp"
#include "sweeps.hpp"

namespace shoreline::test {

std::vector<Row> point_number_sweep(const std::vector<int>& per_cell, bool fitted, int offsets) {
  const Case plate = plate_with_hole("neumann");
  std::vector<Row> rows;
  for (Discretisation on : every_basis(EssentialMethod::nitsche))
    for (const int n : per_cell) {
      on.per_cell = n;
      on.fitted = fitted;
      rows.push_back(over_offsets(fmt::format("plate, per_cell {}", n), plate, on, offsets));
    }
  return rows;
}

}  // namespace shoreline::test
