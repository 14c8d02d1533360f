#include "study_progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "study_table.hpp"

namespace shoreline {

/// Runs ahead take the mean of those before that are as fine as they are, or four times as long as the run before them
/// where there is none.
double StudyProgress::seconds_left(std::size_t done) const {
  double left = 0.0;
  double last = wall_.empty() ? 0.0 : wall_.back();
  for (std::size_t k = done; k < plans_.size(); ++k) {
    double sum = 0.0;
    int number = 0;
    for (std::size_t before = 0; before < done; ++before)
      if (plans_[before].refinement == plans_[k].refinement) {
        sum += wall_[before];
        ++number;
      }
    last = number > 0 ? sum / number : 4.0 * last;
    left += last;
  }
  return left;
}

void StudyProgress::finished(std::size_t number, const RunResult& result, bool known) {
  wall_.push_back(result.wall);
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
