#pragma once
// Rows of other programs: tables with commas, as study.csv is one.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace shoreline {

struct OutsideRow {
  std::string line;                  ///< what to call the method in pictures
  std::optional<double> refinement;  ///< on the axis that a study refines
  double points = 0.0;
  double unknowns = 0.0;
  double seconds = 0.0;
  std::map<std::string, double> norms;  ///< every other column that holds numbers
};

/// Reads a table whose first row names its columns; `line` and `seconds` must be among them, `refinement`, `points` and
/// `unknowns` may be. Rows whose `status` is not `completed` are left out, where there is such a column.
///
/// Cells may be quoted as in RFC 4180, so any study.csv can be read.
/// @throws CaseError with file and line
[[nodiscard]] std::vector<OutsideRow> read_outside_rows(const std::filesystem::path& file);

/// A cell of such a table, quoted where it must be.
[[nodiscard]] std::string csv_cell(const std::string& text);

}  // namespace shoreline
