#include "shoreline/engine/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace shoreline {

std::string progress_line(int step, int steps, double elapsed) {
  std::string line = fmt::format("load step {} of {}", step, steps);
  if (step < 2) return line;
  const double left = elapsed / (step - 1) * (steps - step + 1);
  const auto seconds = static_cast<long>(std::ceil(left));
  if (seconds < 3600) return line + fmt::format(", {}:{:02} left", seconds / 60, seconds % 60);
  return line + fmt::format(", {}:{:02}:{:02} left", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

Progress::Progress(int steps, bool quiet)
    : steps_(steps), visible_(!quiet && isatty(STDERR_FILENO) == 1), start_(Clock::now()), next_(start_) {}

Progress::~Progress() {
  if (visible_) std::fputs("\r\033[K", stderr);  // back to the start, and clear
}

void Progress::begin(int step) {
  const Clock::time_point now = Clock::now();
  if (!visible_ || now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  std::fputs(("\r\033[K" + progress_line(step, steps_, elapsed)).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace shoreline
