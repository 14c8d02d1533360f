#pragma once
// Rows of studies that never ran: their errors, times and sizes are what a test says.

#include <utility>

#include "study/study_table.hpp"

namespace shoreline::test {

/// A completed run; unknowns grow as h⁻².
inline StudyRow study_row(const std::string& line, double h, std::map<std::string, double> norms, double seconds) {
  StudyRow row;
  row.plan.labels = {line, Json(h).dump()};
  row.plan.refinement = h;
  row.plan.line = line;
  row.plan.settings = {"grid.cell_size=" + Json(h).dump()};
  row.result.completed = true;
  row.result.summary = {{"material_points", 100},
                        {"degrees_of_freedom", static_cast<long>(8.0 / h / h)},
                        {"steps", 1},
                        {"threads", 1},
                        {"peak_memory_bytes", 5'000'000},
                        {"warnings", Json::array()}};
  row.result.quantities = Json::object();
  row.result.seconds = {seconds};
  row.norms = std::move(norms);
  return row;
}

/// The same run, had it failed.
inline StudyRow failed(StudyRow row, const std::string& reason) {
  row.result = RunResult{};
  row.result.reason = reason;
  row.norms.clear();
  return row;
}

inline StudyTable study_table(std::vector<StudyRow> rows) {
  return {.title = "a study",
          .device = "errors of a test",
          .axes = {"basis", "grid.cell_size"},
          .refine = 1,
          .errors = {},
          .rows = std::move(rows),
          .outside = {}};
}

}  // namespace shoreline::test
