#pragma once
// Passive points: carried along with the material, with displacement and stress there; they add nothing to it.

#include <functional>
#include <string>

#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// What messages call a point, by its number: "sample point 7".
using NameOfPoint = std::function<std::string(std::size_t)>;

/// The cells whose polynomials serve passive points: the cell in which a point lies or, where that
/// holds no material, the nearest one that does, continued to the point, as for boundary segments.
///
/// @param active  (cells of the grid) those of the material points
/// @throws ComputationError naming the first point outside the grid and its position
[[nodiscard]] PointSupports locate_passive(const Basis& basis, const std::vector<char>& active,
                                           const MaterialPoints& points, const NameOfPoint& name);

}  // namespace shoreline
