#pragma once
// What the records of load steps and of time steps have in common, in the form of the summary.

#include "shoreline/bases/counters.hpp"
#include "shoreline/engine/results.hpp"

namespace shoreline {

/// What was done since @p before, by name.
inline std::map<std::string, long> counts_since(const Counts& before) {
  const Counts now = counted();
  std::map<std::string, long> counts;
  for (std::size_t k = 0; k < now.size(); ++k) counts[std::string(name_of(static_cast<Work>(k)))] = now[k] - before[k];
  return counts;
}

/// @param total  since the start of the run [s]
template <class Record>
void take_over_common(const Record& record, double total, Summary& summary) {
  summary.steps = record.steps;
  summary.degrees_of_freedom = record.degrees_of_freedom;
  summary.effects.clear();
  for (const auto& e : record.effects.entries()) summary.effects.push_back({e.name, e.calls, e.seconds});
  summary.timings = {{"total", total}};
  for (const auto& e : record.phases.entries()) summary.timings.emplace_back(e.name, e.seconds);
  summary.loads = record.resultants.loads;
  summary.reactions = record.resultants.reactions;
  summary.displacement_fit = record.fit_errors;
  summary.fitted_weights = record.weights;
  summary.error_estimate = record.error_estimate;
  summary.warnings = record.warnings;
}

}  // namespace shoreline
