#pragma once
// Errors of runs without an exact solution: against the finest run, the limit of a line of runs, or a run of its own.

#include "study_table.hpp"

namespace shoreline {

/// What runs are compared with.
struct Comparison {
  std::string with;  ///< in words, or why there is nothing to compare with
  Json quantities;   ///< vectors of numbers by name, as quantities_of gives them; null where there are none
  std::optional<std::size_t> row{};  ///< that is the reference itself
};

/// The completed run with the most unknowns; of several the last.
[[nodiscard]] Comparison finest_run(const std::vector<StudyRow>& rows);

/// The limit of the three last completed runs on the line of the finest one, by Richardson's extrapolation, (N.11), for
/// each quantity whose differences fall; sizes must shrink by one ratio r, to 1 %.
[[nodiscard]] Comparison richardson_limit(const std::vector<StudyRow>& rows);

/// Adds to a row |q − q_ref|/|q_ref|, (N.10), of every quantity that both have, in equally many numbers; where the
/// reference vanishes, |q|.
void compare(const Comparison& comparison, StudyRow& row);

}  // namespace shoreline
