#pragma once
// Points in the part of a rectangle that lies inside the outline, however small it is.

#include <array>
#include <memory>
#include <span>

#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// Points with the areas for which they stand.
struct AreaPoints {
  Eigen::Matrix2Xd position;  ///< (2, n) [m]
  Eigen::VectorXd area;       ///< (n) [m²]
};

class CutPoints {
 public:
  /// @param curves  that close into loops which do not cross
  explicit CutPoints(std::span<const SplineCurve> curves);
  ~CutPoints();
  CutPoints(CutPoints&&) noexcept;
  CutPoints& operator=(CutPoints&&) noexcept;

  /// A point at the centroid of each covered part of the sub-rectangles of a box, with its area, (V.8). The box is the
  /// rectangle; or, while that gives less than a quarter of all sub-rectangles a point, the smallest box of them that
  /// holds the part inside.
  ///
  /// @param divisions  sub-rectangles in each direction
  [[nodiscard]] AreaPoints in(const Box& rectangle, const std::array<int, 2>& divisions) const;

 private:
  struct Body;
  std::unique_ptr<const Body> body_;
};

}  // namespace shoreline
