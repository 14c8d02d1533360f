#pragma once
// How far a study is.

#include <chrono>

#include "run_record.hpp"

namespace shoreline {

/// Tells of each run on standard error as it ends, a line each, with the time that the rest will take.
class StudyProgress {
 public:
  /// @param levels  entries of the axis that is refined, which runs fastest; 1 where there is none
  StudyProgress(const std::vector<PlannedRun>& plans, std::size_t levels, bool quiet)
      : plans_(plans), quiet_(quiet), wall_(levels, 0.0) {}

  /// @param number  of the run among the planned ones
  /// @param known   it was on record
  void finished(std::size_t number, const RunResult& result, bool known);

 private:
  [[nodiscard]] double seconds_left(std::size_t done) const;

  const std::vector<PlannedRun>& plans_;
  bool quiet_;
  std::vector<double> wall_;  ///< of all runs so far, by level [s]
};

}  // namespace shoreline
