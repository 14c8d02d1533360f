#pragma once
// Where the system of a load step is weak.

#include <optional>

#include "shoreline/bases/types.hpp"

namespace shoreline {

/// Weak places of the system of the last load step; found only where a case asks for them.
struct Diagnostics {
  /// The element that holds some of the body, but the smallest share of itself, (R.6).
  struct Cut {
    double fraction;
    Index element;
    Vec2 centre;  ///< [m]
  };
  /// The smallest pivot of the scaled matrix, (L.2); 0 where Cholesky's factorisation does not exist.
  struct Pivot {
    double value;
    Vec2 control_point;  ///< of its function [m]
    int component;       ///< 0 or 1
  };
  std::optional<Cut> smallest_cut{};      ///< missing without an outline
  std::optional<Pivot> smallest_pivot{};  ///< missing where every function is held
  Index stray_points = 0;                 ///< material points that alone see two functions or more, (L.6)
  std::optional<Vec2> first_stray{};      ///< position of the first [m]
  Index fewest_points = 0;                ///< in an element that holds any
};

}  // namespace shoreline
