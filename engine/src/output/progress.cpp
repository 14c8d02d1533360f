#include "shoreline/engine/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace shoreline {

namespace {

/// @param seconds  that are left
std::string left(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 3600) return fmt::format(", {}:{:02} left", whole / 60, whole % 60);
  return fmt::format(", {}:{:02}:{:02} left", whole / 3600, whole / 60 % 60, whole % 60);
}

void show(const std::string& line) {
  std::fputs(("\r\033[K" + line).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::string progress_line(int step, int steps, double elapsed, const std::string& noun) {
  const std::string line = fmt::format("{} {} of {}", noun, step, steps);
  return step < 2 ? line : line + left(elapsed / (step - 1) * (steps - step + 1));
}

std::string progress_line(double t, double end, double elapsed) {
  const std::string line = fmt::format("t = {:.3g} of {:.6g} s", t, end);
  return t > 0.0 ? line + left(elapsed / t * (end - t)) : line;
}

Progress::Progress(bool quiet) : visible_(!quiet && isatty(STDERR_FILENO) == 1), start_(Clock::now()), next_(start_) {}

Progress::~Progress() {
  if (visible_) std::fputs("\r\033[K", stderr);  // back to the start, and clear
}

std::optional<double> Progress::due() {
  const Clock::time_point now = Clock::now();
  if (!visible_ || now < next_) return std::nullopt;
  next_ = now + std::chrono::milliseconds(100);
  return std::chrono::duration<double>(now - start_).count();
}

void Progress::begin(int step, int steps, const std::string& noun) {
  if (const auto elapsed = due()) show(progress_line(step, steps, *elapsed, noun));
}

void Progress::reach(double t, double end) {
  if (const auto elapsed = due()) show(progress_line(t, end, *elapsed));
}

}  // namespace shoreline
