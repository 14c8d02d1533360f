#pragma once
// A program that runs beside this one, within limits, and cannot take this one down.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace shoreline {

struct Limits {
  std::optional<double> seconds;  ///< of wall clock
  std::optional<double> memory;   ///< that it holds at once [bytes]
};

struct ChildOutcome {
  bool succeeded = false;
  std::string reason;    ///< why not: the first line of what it said, its signal, or the limit that it met
  double seconds = 0.0;  ///< of wall clock
};

/// Runs a program to its end, with standard output thrown away.
///
/// The child dies with this process, however that ends, and where it meets a limit.
///
/// @param words     the program and its arguments
/// @param complaint file for what the child writes to standard error; replaced
/// @throws OutputError if no process can be made or the file cannot be written
[[nodiscard]] ChildOutcome run_child(const std::vector<std::string>& words, const std::filesystem::path& complaint,
                                     const Limits& limits);

}  // namespace shoreline
