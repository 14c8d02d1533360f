#pragma once
// From the conditions that a case states to functions on a boundary piece.

#include "shoreline/engine/case.hpp"
#include "shoreline/engine/effects.hpp"

namespace shoreline {

using LoadFactor = std::function<double(double)>;

/// What the conditions of a piece refer to.
struct OnPiece {
  std::shared_ptr<const SplineCurve> original;  ///< where the material was at the start, by (span, u)
  LoadFactor factor;
  const std::optional<ExactSolution>& exact;
};

/// @throws InvalidArgument if the condition takes its value from an exact solution and there is none
[[nodiscard]] Condition to_condition(const Case::Condition& condition, const OnPiece& on_piece);

/// The exact displacement of the material at a boundary point.
[[nodiscard]] DisplacementOnPiece exact_displacement(std::shared_ptr<const SplineCurve> original,
                                                     const ExactSolution& exact);

}  // namespace shoreline
