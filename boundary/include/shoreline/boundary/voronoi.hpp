#pragma once
// How much of the body is nearer to a site than to all others.

#include <span>

#include "shoreline/boundary/spline.hpp"

namespace shoreline {

/// A_p = |{x ∈ Ω : |x − x_p| <= |x − x_q| for all q}|, the part of each site's Voronoi cell that lies inside the
/// outline, (V.6) [m²]. Cells tile the plane and their parts inside are integrated on the cubics themselves, by (R.4)
/// and (R.5): the areas sum to that of the region. Takes O(n log n) for n sites.
///
/// Sites are seen on a raster of 1e-9 of the body's extent. Those that coincide there share their cell in equal parts.
///
/// @param curves  that close into loops which do not cross
/// @param sites   (2, n) within the box that bounds the outline [m]
/// @return        (n); 0 for a site outside whose cell does not reach the body
/// @throws InvalidArgument naming the first site outside that box
[[nodiscard]] Eigen::VectorXd voronoi_areas(std::span<const SplineCurve> curves, const Eigen::Matrix2Xd& sites);

}  // namespace shoreline
