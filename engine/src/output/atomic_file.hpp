#pragma once
// A text file that is there whole or not at all.

#include <filesystem>
#include <string_view>

namespace shoreline {

/// Writes @p text beside @p file and renames it: a reader sees the old text or the new one, never a part.
/// @throws OutputError with path and reason
void write_atomically(const std::filesystem::path& file, std::string_view text);

}  // namespace shoreline
