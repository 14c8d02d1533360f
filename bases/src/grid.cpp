#include "shoreline/bases/grid.hpp"

namespace shoreline {

void Grid::locate_all(std::span<const Vec2> x, Index hint, Index* cell) const {
  for (const Vec2& place : x) {
    *cell = locate(place, hint).value_or(-1);
    if (*cell >= 0) hint = *cell;
    ++cell;
  }
}

}  // namespace shoreline
