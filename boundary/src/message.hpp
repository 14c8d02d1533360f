#pragma once
// How messages write a place.

#include <sstream>
#include <string>

#include "shoreline/bases/types.hpp"

namespace shoreline {

/// "(x, y)" with six digits.
inline std::string text(const Vec2& x) {
  std::ostringstream out;
  out << '(' << x.x() << ", " << x.y() << ')';
  return out.str();
}

/// "piece 'name'".
inline std::string quoted(const std::string& name) { return "piece '" + name + "'"; }

}  // namespace shoreline
