#pragma once
// What the body covers of any convex cells.

#include "contour_moments.hpp"
#include "shoreline/boundary/region.hpp"
#include "span_tree.hpp"

namespace shoreline {

class Cover {
 public:
  /// @param curves  that close into loops which do not cross
  explicit Cover(std::span<const SplineCurve> curves);

  [[nodiscard]] const Region& region() const { return region_; }

  /// ∫ {1, ξ, η, ξ², ξη, η²} dA over K ∩ Ω by (R.5) with the cell K in the place of the triangle.
  /// @param corners   of K, about the centre [m]
  /// @param centre    of the coordinates ξ, η [m]
  /// @param shortest  side that has a direction [m]
  [[nodiscard]] Moments moments(Corners corners, const Vec2& centre, double shortest) const;

 private:
  Region region_;
  std::vector<CubicSpan> spans_;
  SpanTree tree_;
};

}  // namespace shoreline
