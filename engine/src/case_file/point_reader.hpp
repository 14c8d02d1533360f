#pragma once
// Material points of a case.

#include "node.hpp"
#include "shoreline/engine/case.hpp"

namespace shoreline {

/// @throws CaseError for what the grid does not have (rectangles, or cells that are cut differently in two directions),
///         more points than a machine holds, and lists of points and volumes that do not match
[[nodiscard]] Case::MaterialPoints read_material_points(const Node& node, const Case::Grid& grid);

}  // namespace shoreline
