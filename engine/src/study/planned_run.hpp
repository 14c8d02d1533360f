#pragma once
// The runs of a study: where each stands among the axes, and the case that it computes.

#include "case_file/json_text.hpp"
#include "shoreline/engine/study.hpp"

namespace shoreline {

struct PlannedRun {
  std::vector<std::string> labels;    ///< one an axis
  std::optional<double> refinement;   ///< its number on the axis that is refined
  std::string line;                   ///< the other labels: runs that differ in refinement alone share it
  std::vector<std::string> settings;  ///< changes to the case, in order
};

/// Every entry of an axis with every entry of the others, the axis to refine fastest.
[[nodiscard]] std::vector<PlannedRun> planned_runs(const Study& study);

/// A case with everything that a study changes in it.
struct PreparedCase {
  Json json;
  std::string fault;  ///< why it cannot be made; else empty
};

/// The study's own changes (no pictures, first and last step saved, threads fixed, sample points, probes at their
/// places, strain energy where runs are compared with a reference), then @p settings.
///
/// @param base     the case file as JSON
/// @param threads  of the run, 0: all cores; none: as the case says, else all cores
[[nodiscard]] PreparedCase prepared_case(const Study& study, const Json& base, std::optional<int> threads,
                                         const std::vector<std::string>& settings);

/// Whether runs are compared with a reference; @p base the case file as JSON.
[[nodiscard]] std::optional<Study::Reference> reference_of(const Study& study, const Json& base);

}  // namespace shoreline
