#pragma once
// Pictures of a run, drawn from its results.h5.

#include <filesystem>
#include <optional>
#include <string>

namespace shoreline {

/// Draws deformed.png: the material points of the last saved step coloured by a stress component and by the
/// displacement, with the boundary as it is and as it was. Or field.png, a projected field and its error.
///
/// Needs a Python with matplotlib and h5py: $SHORELINE_PYTHON, else python3 of the path, else that of the system.
/// A run is worth as much without its picture, so nothing is thrown.
///
/// @param folder  that holds results.h5
/// @return        why there is no picture; nothing if there is one
[[nodiscard]] std::optional<std::string> make_pictures(const std::filesystem::path& folder);

}  // namespace shoreline
