#pragma once
// A whole text file.

#include <filesystem>
#include <string>

namespace shoreline {

/// @param expected  what the file should be, for messages: "a case file"
/// @throws CaseError if it cannot be read
[[nodiscard]] std::string text_of(const std::filesystem::path& file, const std::string& expected);

}  // namespace shoreline
