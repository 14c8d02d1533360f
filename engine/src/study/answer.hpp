#pragma once
// The cheapest setting that meets a tolerance, what the next digits cost, and what the error there is made of.

#include <functional>

#include "run_record.hpp"
#include "study_table.hpp"

namespace shoreline {

struct Answer {
  std::optional<std::size_t> chosen;         ///< row
  std::map<std::string, double> error_left;  ///< with each part of its discretisation refined
  std::string dominant;                      ///< the part that leaves the least, "" where none takes a tenth away
  std::string text;                          ///< for people
};

/// Makes a run beside the rows of a study, of a row's case with further settings, with its errors as rows have them.
using RunMore = std::function<StudyRow(const PlannedRun& plan, const std::vector<std::string>& more)>;

/// Looks for the cheapest row whose error is within the tolerance and stays so on a shifted grid (where the grid can be
/// shifted), and refines each part
/// of its discretisation in turn: the part whose refinement leaves the least error dominates.
///
/// @param base_of  the case of a plan, as it ran
/// @param run      makes the runs that this takes
/// @throws CaseError if no row has the norm; names the nearest
[[nodiscard]] Answer answer(const StudyTable& table, const Tolerance& tolerance,
                            const std::function<Json(const PlannedRun&)>& base_of, const RunMore& run);

}  // namespace shoreline
