#pragma once
// summary.json: what a run was, what it cost and how well it did.

#include <filesystem>

#include "shoreline/engine/results.hpp"

namespace shoreline {

/// Writes summary.json into @p folder, whole or not at all.
///
/// Keys are those of docs/results.md. A missing relative error and a number that is not finite become null;
/// "errors" and "condition_estimate" are there only if they were computed. Peak memory is the process's so far.
///
/// @throws OutputError with path and reason
void write_summary(const Summary& summary, const std::filesystem::path& folder);

}  // namespace shoreline
