#pragma once
// How far a run is, for someone who watches it.

#include <chrono>
#include <optional>
#include <string>

namespace shoreline {

/// "load step 12 of 50, 1:05 left": the steps to come take as long as those behind took on average.
/// @param step     that begins, 1 to @p steps; the first one leaves no estimate
/// @param elapsed  since step 1 began [s]
/// @param noun     what a step is called
[[nodiscard]] std::string progress_line(int step, int steps, double elapsed, const std::string& noun = "load step");

/// "t = 0.31 of 2.5 s, 0:12 left": the time to come costs as much a second as that behind.
/// @param t        reached, 0 to @p end [s]; 0 leaves no estimate
/// @param elapsed  since t was 0 [s]
[[nodiscard]] std::string progress_line(double t, double end, double elapsed);

/// One line on stderr that follows the run, and vanishes at the end. Silent unless stderr is a terminal.
class Progress {
 public:
  /// @param quiet  silent on a terminal too
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Step @p step begins. The line changes at most ten times a second.
  void begin(int step, int steps, const std::string& noun = "load step");

  /// A run whose number of steps is not known has reached @p t of @p end [s]. Likewise.
  void reach(double t, double end);

 private:
  using Clock = std::chrono::steady_clock;

  /// Seconds since the start where the line is to change now.
  [[nodiscard]] std::optional<double> due();

  bool visible_;
  Clock::time_point start_;
  Clock::time_point next_;
};

}  // namespace shoreline
