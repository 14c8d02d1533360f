#include "ghost_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ranges>
#include <set>

#include "shoreline/bases/counters.hpp"
#include "shoreline/bases/derivatives.hpp"

namespace shoreline {
namespace {

/// Width of the element of a cell along a direction [m].
double width(const Grid& grid, Index cell, const Vec2& direction) {
  const Index first = cell - cell % grid.parts();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (Index part = first; part < first + grid.parts(); ++part)
    for (const Vec2& v : grid.polygon(part)) {
      low = std::min(low, direction.dot(v));
      high = std::max(high, direction.dot(v));
    }
  return high - low;
}

/// All cells of the elements that the boundary cuts, or that serve one of its segments.
std::set<Index> cells_at_boundary(const Grid& grid, const std::vector<Edge>& edges) {
  const Index parts = grid.parts();
  std::set<Index> cells;
  const auto insert = [&](Index cell) {
    for (Index part = 0; part < parts; ++part) cells.insert(cell - cell % parts + part);
  };
  for (const Edge& edge : edges) {
    for (const Segment& segment : edge.segments) insert(segment.cell);
    std::ranges::for_each(edge.support_cell, insert);
  }
  return cells;
}

/// Faces of cells between active ones, each once, in the order of their two cells.
template <class Cells>
std::vector<Face> active_faces(const Grid& grid, const std::vector<char>& is_active, const Cells& cells) {
  std::map<std::pair<Index, Index>, Face> found;
  const auto active = [&](Index cell) { return is_active[static_cast<std::size_t>(cell)] != 0; };
  for (const Index cell : cells) {
    if (!active(cell)) continue;
    for (Face face : grid.faces(cell)) {
      if (!active(face.neighbour)) continue;
      if (face.cell > face.neighbour) face = {face.neighbour, face.cell, face.b, face.a};
      found.emplace(std::pair(face.cell, face.neighbour), face);
    }
  }
  std::vector<Face> faces;
  for (const auto& [pair, face] : found) faces.push_back(face);
  return faces;
}

}  // namespace

FaceJumps face_jumps(const Basis& basis, const Face& face, double scale, int power) {
  FaceJumps jumps;
  const ShortIndices here = basis.functions_of(face.cell);
  const ShortIndices there = basis.functions_of(face.neighbour);
  jumps.functions.assign(here.begin(), here.end());
  jumps.functions.insert(jumps.functions.end(), there.begin(), there.end());
  std::ranges::sort(jumps.functions);
  jumps.functions.erase(std::ranges::unique(jumps.functions).begin(), jumps.functions.end());

  const Vec2 along = face.b - face.a;
  const Vec2 normal = Vec2(along.y(), -along.x()).normalized();
  const double h = width(basis.grid(), face.cell, normal);
  const QuadratureRule rule = gauss(basis.degree() + 1);
  count(Work::normal_derivatives, 2 * rule.point.size());
  for (Eigen::Index q = 0; q < rule.point.size(); ++q) {
    const Vec2 x = face.a + rule.point[q] * along;
    FaceJumps::Jump jump = FaceJumps::Jump::Zero(static_cast<Eigen::Index>(jumps.functions.size()));
    for (const auto& [cell, sign] : {std::pair(face.cell, 1.0), std::pair(face.neighbour, -1.0)}) {
      const ShortIndices& functions = cell == face.cell ? here : there;
      const ShortVector derivative = directional_derivative(basis, cell, x, normal, basis.degree());
      for (Eigen::Index a = 0; a < functions.size(); ++a)
        jump[std::ranges::lower_bound(jumps.functions, functions[a]) - jumps.functions.begin()] += sign * derivative[a];
    }
    jumps.jump.push_back(std::move(jump));
    jumps.weight.push_back(scale * std::pow(h, power) * rule.weight[q] * along.norm());
  }
  return jumps;
}

std::vector<Face> faces_at_boundary(const Grid& grid, const std::vector<char>& active, const std::vector<Edge>& edges) {
  return active_faces(grid, active, cells_at_boundary(grid, edges));
}

std::vector<Face> faces_inside(const Grid& grid, const std::vector<char>& active) {
  return active_faces(grid, active, std::views::iota(Index{0}, grid.cells()));
}

}  // namespace shoreline
