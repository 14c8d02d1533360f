#pragma once
// Numbers and places in messages.

#include <cstdio>
#include <string>

#include "shoreline/bases/types.hpp"

namespace shoreline {

inline std::string text(double number) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", number);
  return buffer;
}

inline std::string text(const Vec2& x) { return "(" + text(x.x()) + ", " + text(x.y()) + ")"; }

}  // namespace shoreline
