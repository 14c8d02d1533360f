#pragma once
// What can be read back of results.h5.

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>

namespace shoreline {

/// Displacements from the first to the last saved step of the points that draw each boundary curve, (2, m) [m], by the
/// curve's name in the file; without curves that have other points than at the start.
/// @throws OutputError if the file cannot be read
[[nodiscard]] std::map<std::string, Eigen::Matrix2Xd> curve_displacements(const std::filesystem::path& file);

}  // namespace shoreline
