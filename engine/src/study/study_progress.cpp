#include "study_progress.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "study_table.hpp"

namespace shoreline {

/// Runs ahead take the mean of those before on their level, or four times that of the level before where there are
/// none.
double StudyProgress::seconds_left(std::size_t done) const {
  const auto runs_on = [&](std::size_t level, std::size_t runs) {
    return (runs + wall_.size() - 1 - level) / wall_.size();
  };
  double left = 0.0;
  double mean = 0.0;
  for (std::size_t level = 0; level < wall_.size(); ++level) {
    const std::size_t before = runs_on(level, done);
    mean = before > 0 ? wall_[level] / static_cast<double>(before) : 4.0 * mean;
    left += mean * static_cast<double>(runs_on(level, plans_.size()) - before);
  }
  return left;
}

void StudyProgress::finished(std::size_t number, const RunResult& result, bool known) {
  wall_[number % wall_.size()] += result.wall;
  if (quiet_) return;
  const std::string what =
      result.completed ? fmt::format("{:.3g} s", spread_of(result.seconds).median) : "failed: " + result.reason;
  const double left = seconds_left(number + 1);
  std::fputs(fmt::format("{}/{}  {}: {}{}{}\n", number + 1, plans_.size(), fmt::join(plans_[number].labels, ", "), what,
                         known ? " (on record)" : "",
                         number + 1 < plans_.size() ? fmt::format("; about {:.0f} s left", left) : "")
                 .c_str(),
             stderr);
}

}  // namespace shoreline
