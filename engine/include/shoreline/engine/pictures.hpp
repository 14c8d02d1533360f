#pragma once
// Pictures of a run, drawn from its results.h5, and of a study, drawn from its study.json.

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

/// Draws what a study.json tells of its runs, a line of runs being those that differ in refinement alone:
/// error_time.png, errors over seconds; error_refinement.png, errors over refinement, where that is a number;
/// phases.png, what the finest runs spend their time on; memory.png, peak memory over unknowns.
///
/// Needs a Python with matplotlib, found as by make_pictures(). Nothing is thrown. What the study does not hold, as
/// errors of a case without an exact solution, has no picture and is no fault; pictures of a former study are removed.
///
/// @param folder  that holds study.json
/// @return        why there are no pictures, as where every run failed; nothing if there are some
[[nodiscard]] std::optional<std::string> make_study_pictures(const std::filesystem::path& folder);

}  // namespace shoreline
