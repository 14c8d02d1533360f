#include <fmt/format.h>

#include "../example_run.hpp"
#include "sweeps.hpp"

namespace shoreline::test {
namespace {

CantileverRow deflected(CantileverRow row) {
  const auto along = [](int points) { return fmt::format("{}", points); };
  try {
    ExampleRun run(
        "cantilever/clamped.json",
        {fmt::format("grid.cell_size={}", row.h), fmt::format("ghost={}", row.ghost), "analysis.load_steps=10",
         "boundaries.top.condition.value=3000", "boundaries.bottom.line.points=" + along(row.across),
         "boundaries.top.line.points=" + along(row.across), "boundaries.tip.line.points=" + along(row.high + 1),
         "boundaries.left.line.points=" + along(row.high),
         fmt::format("material_points.across=[{},{}]", row.across, row.high)});
    run.compute();
    row.tip = -run.scene.probes.at(0).history.back().displacement.y();
  } catch (const Error& error) {
    row.failure = error.what();
  }
  return row;
}

}  // namespace

std::vector<CantileverRow> cantilever_sweep(const std::vector<double>& ghosts) {
  std::vector<CantileverRow> rows;
  for (const double ghost : ghosts)
    for (const double h : {3.0, 1.5, 0.75, 0.375})
      for (const auto& [across, high] : {std::pair(28, 8), {56, 16}, {112, 32}, {224, 64}})
        rows.push_back(deflected({.h = h, .across = across, .high = high, .ghost = ghost}));
  return rows;
}

}  // namespace shoreline::test
