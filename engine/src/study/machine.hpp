#pragma once
// On what a study ran.

#include <string>

namespace shoreline {

/// Processor, cores and memory: "AMD EPYC 7763, 2 cores, 24 GiB".
[[nodiscard]] std::string machine_name();

/// "shoreline 0.1.0, Release build, GCC 11.4.0".
[[nodiscard]] std::string program_name();

}  // namespace shoreline
