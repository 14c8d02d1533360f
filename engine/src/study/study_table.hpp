#pragma once
// The rows of a study with their errors and rates, as JSON, CSV and Markdown.

#include <span>

#include "outside_rows.hpp"
#include "run_record.hpp"

namespace shoreline {

struct StudyRow {
  PlannedRun plan;
  RunResult result;
  std::map<std::string, double> norms;  ///< errors, by dotted name
  std::map<std::string, double> rates;  ///< against the row before on the same line
};

/// Median, least and greatest of repeated times [s].
struct Spread {
  double median;
  double least;
  double greatest;
};
[[nodiscard]] Spread spread_of(std::vector<double> seconds);

struct StudyTable {
  std::string title;
  std::string device;             ///< where errors are measured
  std::vector<std::string> axes;  ///< names
  std::optional<std::size_t> refine;
  std::vector<std::string> errors;  ///< norms to show
  std::vector<StudyRow> rows;
  std::vector<OutsideRow> outside;
};

/// Fills the rates: log(e₁/e₂)/|log(h₁/h₂)| between neighbours of one line, in the order of the axis.
void add_rates(std::vector<StudyRow>& rows);

/// Norms that any row has, in the order of the alphabet.
[[nodiscard]] std::vector<std::string> norms_in(std::span<const StudyRow> rows);

/// study.json (docs/results.md).
[[nodiscard]] Json json_of(const StudyTable& table);

/// study.csv: one row a run, every number that there is.
[[nodiscard]] std::string csv_of(const StudyTable& table);

/// study.md: the axes, sizes, time, memory and the norms to show.
[[nodiscard]] std::string markdown_of(const StudyTable& table);

}  // namespace shoreline
