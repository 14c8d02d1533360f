#pragma once
// Why a system has no unique solution, in the user's words.

#include <optional>
#include <string>

#include "shoreline/engine/assembler.hpp"
#include "shoreline/engine/contribution.hpp"

namespace shoreline {

/// Parts of the body that can move as rigid bodies without resistance: a sentence on the first, or none.
///
/// A part is a set of cells joined by functions. Its rigid motions are tested against all blocks and constraints,
/// (L.4).
[[nodiscard]] std::optional<std::string> free_motion(const StepState& step, const ElementBlocks& blocks,
                                                     const std::vector<Constraint>& constraints);

/// Where an unknown sits, how much material its function sees, and the cell there that holds the fewest points.
/// @param unknown  2·function + component
[[nodiscard]] std::string weak_unknown(const StepState& step, Index unknown);

/// The material point that an increment moves farthest and its cell, where that is more than the size of the body.
/// @param increment  (2, functions) Δd [m]
[[nodiscard]] std::optional<std::string> stray_point(const StepState& step, const Eigen::Matrix2Xd& increment);

}  // namespace shoreline
