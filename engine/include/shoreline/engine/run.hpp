#pragma once
// One case from start to end.

#include <filesystem>
#include <string>

#include "shoreline/engine/case.hpp"
#include "shoreline/engine/results.hpp"

namespace shoreline {

struct RunOptions {
  std::filesystem::path output;  ///< folder for summary.json, results.h5, results.xdmf and pictures
  bool quiet = false;            ///< no progress on a terminal
};

/// Computes a case and writes its results.
///
/// @throws CaseError         if the case cannot be made into a scene (an outline that does not close, …)
/// @throws ComputationError  if a step fails; the summary with status "failed" and all steps before are on disk
/// @throws OutputError       if the folder cannot be written
Summary run(const Case& problem, const RunOptions& options);

/// Checks that the solver that a case names is installed.
///
/// @throws CaseError with what is missing and how to get it
void require_solver(const Case& problem);

/// What a run of this case would build and what not, its sizes, and the memory that it would take; as text.
///
/// @throws CaseError as run does
[[nodiscard]] std::string plan(const Case& problem);

}  // namespace shoreline
