#pragma once
// How far a run is, for someone who watches it.

#include <chrono>
#include <string>

namespace shoreline {

/// "load step 12 of 50, 1:05 left": the steps to come take as long as those behind took on average.
/// @param step     that begins, 1 to @p steps; the first one leaves no estimate
/// @param elapsed  since step 1 began [s]
[[nodiscard]] std::string progress_line(int step, int steps, double elapsed);

/// One line on stderr that follows the load steps, and vanishes at the end. Silent unless stderr is a terminal.
class Progress {
 public:
  /// @param quiet  silent on a terminal too
  Progress(int steps, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Step @p step begins. The line changes at most ten times a second.
  void begin(int step);

 private:
  using Clock = std::chrono::steady_clock;

  int steps_;
  bool visible_;
  Clock::time_point start_;
  Clock::time_point next_;
};

}  // namespace shoreline
