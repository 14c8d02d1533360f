#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bodies.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "sweeps.hpp"

namespace shoreline::test {
namespace {

constexpr double h = 0.125;
constexpr double width = 8.0 * h;

/// A block whose upper side is a bow of a given radius.
Case bowed_block(double radius) {
  const double half = std::asin(0.5 * width / radius) * 180.0 / std::numbers::pi;
  const Vec2 centre(0.0, 0.5 * width - std::sqrt(radius * radius - 0.25 * width * width));
  Piece bow = arc(centre, radius, 90.0 - half, 90.0 + half, 17);
  const Vec2 left(-0.5 * width, -0.5 * width);
  const Vec2 right(0.5 * width, -0.5 * width);
  std::vector<Piece> outline{line(left, right), line(right, bow.points.front()), bow, line(bow.points.back(), left)};
  return bending(std::move(outline), h);
}

Case block_with_hole(double radius) {
  std::vector<Piece> outline = sides(rectangle(width, width, 0.0));
  outline.push_back(circle({0.31 * h, 0.17 * h}, radius, 32, true));
  return bending(std::move(outline), h);
}

}  // namespace

std::vector<Row> curvature_sweep(int offsets) {
  std::vector<Row> rows;
  for (const EssentialMethod method : both_methods())
    for (const Discretisation& on : every_basis(method)) {
      for (const double radius : {100.0, 30.0, 10.0, 5.0})
        rows.push_back(over_offsets(fmt::format("bow of radius {:g} h", radius), bowed_block(radius * h), on, offsets));
      for (const double radius : {3.0, 1.0, 0.5, 0.25})
        rows.push_back(
            over_offsets(fmt::format("hole of radius {:g} h", radius), block_with_hole(radius * h), on, offsets));
    }
  return rows;
}

}  // namespace shoreline::test
