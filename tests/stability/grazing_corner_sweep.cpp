#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bodies.hpp"
#include "sweeps.hpp"

namespace shoreline::test {

std::vector<Row> grazing_corner_sweep(bool ghost) {
  constexpr double h = 0.125;
  const Case diamond = bending(sides(rectangle(1.0, 1.0, 0.25 * std::numbers::pi)), h);
  const double tip = 0.5 * std::numbers::sqrt2;  // x of its right corner
  std::vector<Row> rows;
  for (const EssentialMethod method : both_methods())
    for (Discretisation on : every_basis(method)) {
      if (!ghost) on.ghost = 0.0;
      std::vector<Outcome> outcomes;
      for (int decade = -2; decade >= -12; --decade) {
        Case problem = discretised(diamond, on);
        problem.grid.lower.x() = tip - std::pow(10.0, decade) * h - 14.0 * h;  // a line just left of the corner
        problem.grid.lower.y() -= 0.37 * h;
        outcomes.push_back(compute(problem));
        outcomes.back().place = fmt::format("reaches in by 1e{} h", decade);
      }
      rows.push_back(summarised("corner of a diamond", on, outcomes));
    }
  return rows;
}

}  // namespace shoreline::test
