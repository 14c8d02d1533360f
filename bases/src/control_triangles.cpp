#include "control_triangles.hpp"

#include <cmath>
#include <numbers>

#include "shoreline/bases/control_triangle.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"

namespace shoreline {
namespace {

constexpr double straight = 1e-6;                  ///< the border turns by less: rounding of its vertices [rad]
constexpr double corner = std::numbers::pi / 6.0;  ///< turns that make a corner [rad]: less would make long triangles

std::size_t at(Index number) { return static_cast<std::size_t>(number); }

/// What a control triangle must respect, as seen from its vertex.
struct Surroundings {
  std::vector<Vec2> points;  ///< Powell-Sabin points
  std::vector<Vec2> before;  ///< of them those on the border before and after the vertex, the mesh on the left
  std::vector<Vec2> after;
};

std::vector<Surroundings> surroundings(const TriangleMesh& main, const TriangleMesh& refined) {
  std::vector<Surroundings> around(main.vertex.size(), {{Vec2::Zero()}, {}, {}});
  const std::vector<std::array<Index, 3>> neighbour = neighbours(main);
  for (Index cell = 0; cell < static_cast<Index>(refined.triangle.size()); ++cell) {
    const auto [v, p, q] = corners(refined, cell);
    const Vec2 first = 0.5 * (p - v);
    const Vec2 second = 0.5 * (q - v);
    Surroundings& here = around[at(refined.triangle[at(cell)][0])];
    here.points.insert(here.points.end(), {first, second});
    const std::size_t k = at(cell % powell_sabin_parts / 2);
    const auto& across = neighbour[at(cell / powell_sabin_parts)];
    if (cell % 2 == 0 && across[k] < 0) here.after.push_back(first);
    if (cell % 2 == 1 && across[(k + 2) % 3] < 0) here.before.push_back(second);
  }
  return around;
}

/// The line from a to b; the normal points to its left.
Line line_from(const Vec2& a, const Vec2& b) {
  const Vec2 normal = Vec2(a.y() - b.y(), b.x() - a.x()).normalized();
  return {normal, normal.dot(a)};
}

/// Lines of the border on which the control triangle must have a side.
std::vector<Line> border_sides(const Surroundings& here) {
  if (here.before.size() != 1) return {};  // inside, or where parts of the border touch
  const Vec2& before = here.before[0];
  const Vec2& after = here.after[0];
  const double turn = std::atan2(-cross(before, after), -before.dot(after));
  if (turn < -straight) return {};
  if (turn <= 0.0) return {line_from(before, after)};
  if (turn < corner) return {line_from(Vec2::Zero(), after)};
  return {line_from(before, Vec2::Zero()), line_from(Vec2::Zero(), after)};
}

}  // namespace

std::vector<std::array<Vec2, 3>> control_triangles(const TriangleMesh& main, const TriangleMesh& refined) {
  std::vector<std::array<Vec2, 3>> triangles;
  triangles.reserve(main.vertex.size());
  for (const Surroundings& here : surroundings(main, refined))
    triangles.push_back(control_triangle(here.points, border_sides(here)));
  return triangles;
}

}  // namespace shoreline
