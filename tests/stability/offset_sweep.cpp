#include "bodies.hpp"
#include "sweeps.hpp"

namespace shoreline::test {

std::vector<Row> offset_sweep(const OffsetChoice& choice) {
  std::vector<Row> rows;
  for (const auto& [label, problem] :
       {std::pair("square at 33°", turned_compression()), std::pair("plate, tractions", plate_with_hole("neumann")),
        std::pair("plate, displacements", plate_with_hole("dirichlet")), std::pair("ring sector", ring_sector())})
    for (const EssentialMethod method : both_methods())
      for (Discretisation on : every_basis(method)) {
        if (!choice.ghost) on.ghost = 0.0;
        on.fitted = choice.fitted;
        rows.push_back(over_offsets(label, problem, on, choice.offsets));
      }
  return rows;
}

}  // namespace shoreline::test
