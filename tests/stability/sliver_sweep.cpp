#include "bodies.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "sweeps.hpp"

namespace shoreline::test {
namespace {

constexpr double h = 0.125;
constexpr double angle = 0.4;  ///< [rad]

/// A block of 8 × 8 cells with a round hole.
Case block_with_hole(const Vec2& centre, double radius) {
  std::vector<Piece> outline = sides(rectangle(8.0 * h, 8.0 * h, angle));
  outline.push_back(circle(centre, radius, 16, true));
  return bending(std::move(outline), h);
}

/// Towards the middle of its side.
Vec2 along(double distance) { return distance * Vec2(std::cos(angle), std::sin(angle)); }

}  // namespace

std::vector<Row> sliver_sweep(int offsets) {
  const Case strip = bending(sides(rectangle(8.0 * h, 1e-3 * h, angle)), h);
  const Case small_hole = block_with_hole(Vec2::Zero(), 0.2 * h);
  const Case thin_wall = block_with_hole(along(3.4 * h), 0.5 * h);  // 0.1 h thick
  std::vector<Row> rows;
  for (const auto& [label, problem] :
       {std::pair("body 1e-3 h thick", strip), std::pair("hole of radius 0.2 h", small_hole),
        std::pair("wall 0.1 h thick", thin_wall)})
    for (const EssentialMethod method : both_methods())
      for (const Discretisation& on : every_basis(method)) rows.push_back(over_offsets(label, problem, on, offsets));
  return rows;
}

}  // namespace shoreline::test
