#pragma once
// What was built, and with what.

#include <string>

namespace shoreline {

/// "MAJOR.MINOR.PATCH".
[[nodiscard]] std::string version();

/// Version, build type and compiler, and the libraries with their versions, on a few lines.
[[nodiscard]] std::string version_report();

}  // namespace shoreline
