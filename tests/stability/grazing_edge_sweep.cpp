#include <fmt/format.h>

#include <cmath>

#include "bodies.hpp"
#include "sweeps.hpp"

namespace shoreline::test {
namespace {

Row beside_a_line(const std::string& label, const Case& plate, const Discretisation& on) {
  std::vector<Outcome> outcomes;
  for (int decade = -1; decade >= -12; --decade) {
    Case problem = discretised(plate, on);
    const double h = problem.grid.cell_size.x();
    problem.grid.lower = Vec2(std::pow(10.0, decade) - 2.0, -1.37) * h;  // the plate's left edge lies on x = 0
    outcomes.push_back(compute(problem));
    outcomes.back().place = fmt::format("1e{} h beyond the line", decade);
  }
  return summarised(label, on, outcomes);
}

}  // namespace

std::vector<Row> grazing_edge_sweep(bool ghost) {
  const Case plate = plate_with_hole("neumann");
  Case stiff = plate;
  stiff.plane = Plane::strain;
  stiff.material.poissons_ratio = 0.4;
  std::vector<Row> rows;
  for (const EssentialMethod method : both_methods())
    for (Discretisation on : every_basis(method)) {
      if (!ghost) on.ghost = 0.0;
      rows.push_back(beside_a_line("plate, ν = 0.2", plate, on));
      rows.push_back(beside_a_line("plate, ν = 0.4, plane strain", stiff, on));
    }
  return rows;
}

}  // namespace shoreline::test
