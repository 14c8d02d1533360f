#pragma once
// What every analysis builds of a case: grid and basis, outline, material points.

#include <memory>
#include <vector>

#include "shoreline/bases/basis.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/spline.hpp"
#include "shoreline/engine/case.hpp"
#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// @throws CaseError if the triangles of a case break a rule
[[nodiscard]] std::unique_ptr<const Basis> basis_of(const Case& problem);

struct Body {
  std::unique_ptr<const Basis> basis;
  std::vector<SplineCurve> curves;
  std::vector<std::vector<int>> loops;  ///< curves in order, joined end to start
  MaterialPoints points;                ///< by cell
};

/// What a place that a case gives lies outside of: "grid" or "outline"; none for a place in the body, or as near to its
/// outline as 0.01 of a cell, because a spline is no arc.
///
/// @param body  none: there is no outline
[[nodiscard]] const char* left_by(const Vec2& place, const Grid& grid, const Region* body);

/// @throws CaseError with the key at fault where the grid breaks a rule, the outline does not bound a body inside the
///         grid, or it holds no points
[[nodiscard]] Body build_body(const Case& problem);

}  // namespace shoreline
