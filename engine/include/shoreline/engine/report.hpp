#pragma once
// The summary of a run as text for people.

#include <filesystem>
#include <string>

#include "shoreline/engine/results.hpp"

namespace shoreline {

/// Sizes, errors against the exact solution (if there is one), what each phase cost, warnings, where the results lie.
/// @param output  folder of the results
[[nodiscard]] std::string report(const Summary& summary, const std::filesystem::path& output);

}  // namespace shoreline
