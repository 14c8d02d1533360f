#pragma once
// What holds for the segments of a curve in any grid.

#include <algorithm>
#include <string>

#include "shoreline/boundary/short_forms.hpp"
#include "shoreline/boundary/trace.hpp"

namespace shoreline::test {

/// How far x lies outside a cell, in units of its size.
inline double outside(const Grid& grid, Index cell, const Vec2& x) {
  const std::vector<Vec2> polygon = grid.polygon(cell);
  double farthest = -1.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 side = polygon[(k + 1) % polygon.size()] - polygon[k];
    farthest = std::max(farthest, cross(x - polygon[k], side) / side.norm() / grid.size(cell));
  }
  return farthest;
}

/// What is wrong with a trace; empty if nothing is.
inline std::string fault(const SplineCurve& curve, const Grid& grid, const std::vector<Segment>& segments) {
  int span = -1;
  double end = 1.0;
  Index cell = -1;
  for (const Segment& s : segments) {
    if (end == 1.0 ? s.span != span + 1 || s.begin != 0.0 : s.span != span || s.begin != end) return "gap or overlap";
    if (s.span == span && s.cell == cell) return "same cell twice in a row";
    if (!(s.begin < s.end)) return "no width";
    for (int k = 0; k <= 8; ++k) {
      const double u = s.begin + (s.end - s.begin) * k / 8.0;
      if (outside(grid, s.cell, curve.spans[static_cast<std::size_t>(s.span)].position(u)) > 1e-8) return "outside";
    }
    span = s.span;
    end = s.end;
    cell = s.cell;
  }
  return end == 1.0 && span + 1 == static_cast<int>(curve.spans.size()) ? "" : "ends early";
}

inline std::vector<Index> cells_of(const std::vector<Segment>& segments) {
  std::vector<Index> cells;
  for (const Segment& s : segments) cells.push_back(s.cell);
  return cells;
}

inline SplineCurve straight(const Vec2& from, const Vec2& to) { return fit_spline(line(from, to)); }

}  // namespace shoreline::test
