#pragma once
// Numbers that suit a basis where a case leaves them out.

#include "shoreline/engine/case.hpp"

namespace shoreline {

/// γ of the ghost penalty, (G.1), with which Nitsche's method is positive definite however the boundary cuts the grid,
/// and the penalty costs next to no accuracy.
/// @param degree  of a B-spline; of no matter to other bases
[[nodiscard]] constexpr double ghost_for_nitsche(Case::BasisType basis, int degree = 2) {
  switch (basis) {
    case Case::BasisType::linear:
      return 1e-2;
    case Case::BasisType::powell_sabin:
      return 1e-4;
    case Case::BasisType::bspline:
      return degree == 3 ? 1e-5 : degree == 2 ? 5e-4 : 1e-3;
    case Case::BasisType::bilinear:
      break;
  }
  return 1e-3;
}

/// Width δ/h of the band of Nitsche's method, (D.3), in cells, before thin layers narrow it, (D.10).
[[nodiscard]] constexpr double nitsche_band(Case::BasisType basis) {
  return basis == Case::BasisType::powell_sabin ? 0.02 : 0.01;
}

}  // namespace shoreline
