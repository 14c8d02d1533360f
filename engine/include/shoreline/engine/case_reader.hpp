#pragma once
// From a case file to a Case: read, checked against the table of keys, complete.

#include <filesystem>
#include <string>
#include <vector>

#include "shoreline/engine/case.hpp"

namespace shoreline {

/// Reads and checks a case file.
///
/// @param file       JSON, one case (docs/case_format.md)
/// @param overrides  "path=value": dotted path, list entries by number or by their name; the value is JSON, or else a
///                   string as it stands. Applied in order before anything is checked.
/// @throws CaseError "FILE: /json/pointer: what was found, what was expected", at the first thing that is wrong
[[nodiscard]] Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// Checks a case given as text.
/// @param name  stands for the file in messages and in Case::file
[[nodiscard]] Case parse_case(const std::string& text, const std::filesystem::path& name,
                              const std::vector<std::string>& overrides = {});

/// The JSON Schema (draft 2020-12) of a case file.
[[nodiscard]] std::string case_schema();

/// The reference page of the case file in Markdown, docs/case_format.md.
[[nodiscard]] std::string case_format();

}  // namespace shoreline
