#pragma once
// Warnings that load steps repeat.

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

namespace shoreline {

/// Says once what happens in several load steps, with their number.
class StepWarnings {
 public:
  /// @param kind      warnings of one kind share a line
  /// @param text      of the first step; later ones only count
  /// @param warnings  where the line stands
  void add(const std::string& kind, int step, const std::string& text, std::vector<std::string>& warnings) {
    const auto [found, is_new] = lines_.try_emplace(kind, Line{warnings.size(), {}, 0});
    Line& line = found->second;
    if (is_new) {
      line.text = fmt::format("load step {}: {}", step, text);
      warnings.push_back(line.text);
    } else {
      ++line.later;
      warnings[line.place] =
          fmt::format("{} (and in {} later load step{})", line.text, line.later, line.later == 1 ? "" : "s");
    }
  }

 private:
  struct Line {
    std::size_t place;
    std::string text;
    int later;
  };
  std::map<std::string, Line> lines_;
};

}  // namespace shoreline
