#include "../nearly_incompressible.hpp"
#include "sweeps.hpp"

namespace shoreline::test {

std::vector<PressureRow> pressure_sweep(Index cells) {
  const Held held{EssentialMethod::nitsche, 0.0};
  std::vector<PressureRow> rows;
  for (const auto& [name, grid] : grids_under_square(held.method, cells)) {
    PressureRow row{.basis = name};
    for (std::size_t k = 0; k < poissons_ratios.size(); ++k)
      for (const bool projected : {false, true}) {
        const Case problem = parse_case(manufactured_text(poissons_ratios[k]), "square.json", {});
        Scene scene = build_scene(on_grid(problem, grid, held, projected));
        RunRecord record;
        run_load_steps(scene, {}, record);
        (projected ? row.projected : row.plain)[k] = pressure_error(scene, poissons_ratios[k]);
      }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace shoreline::test
