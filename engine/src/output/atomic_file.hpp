#pragma once
// A text file that is there whole or not at all.

#include <filesystem>
#include <string_view>

namespace shoreline {

/// Writes @p text beside @p file and renames it: a reader sees the old text or the new one, never a part.
/// @throws OutputError with path and reason
void write_atomically(const std::filesystem::path& file, std::string_view text);

/// Makes a folder with those above it, where it is missing.
/// @throws OutputError with its path and the system's reason
void make_folder(const std::filesystem::path& folder);

}  // namespace shoreline
