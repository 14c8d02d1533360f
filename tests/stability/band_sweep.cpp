#include <fmt/format.h>

#include <cmath>

#include "bodies.hpp"
#include "sweeps.hpp"

namespace shoreline::test {

std::vector<Row> band_sweep(int offsets) {
  std::vector<Row> rows;
  for (const auto& [label, problem] :
       {std::pair("square at 33°", turned_compression()), std::pair("plate, tractions", plate_with_hole("neumann"))})
    for (const EssentialMethod method : both_methods())
      for (Discretisation on :
           {remedied(Case::BasisType::bilinear, 1, method), remedied(Case::BasisType::bspline, 2, method)})
        for (int decade = -1; decade >= -12; --decade) {
          on.band = std::pow(10.0, decade);
          on.narrows = false;
          rows.push_back(over_offsets(label, problem, on, offsets));
        }
  return rows;
}

}  // namespace shoreline::test
