#include "shoreline/engine/macro_elements.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shoreline {
namespace {

std::size_t at(Index number) { return static_cast<std::size_t>(number); }

/// Numbers of the elements that share a face with one, each as often as it does.
std::vector<Index> neighbours_of(const Grid& grid, Index element) {
  std::vector<Index> found;
  for (Index part = 0; part < grid.parts(); ++part)
    for (const Face& face : grid.faces(element * grid.parts() + part))
      if (const Index other = face.neighbour / grid.parts(); other != element) found.push_back(other);
  return found;
}

/// Blocks of about 3 × 3 cells of a regular grid of rectangles, as even as its numbers of columns and rows allow.
MacroElements blocks(const Grid& grid, PolynomialSpace polynomials) {
  constexpr Index side = 3;
  const std::vector<Vec2> cell = grid.polygon(0);
  const Vec2 extent = (grid.bounds().upper - grid.bounds().lower).cwiseQuotient(cell[2] - cell[0]);
  const auto columns = static_cast<Index>(std::lround(extent.x()));
  const auto rows = static_cast<Index>(std::lround(extent.y()));
  const Index across = std::max(columns / side, Index{1});
  const Index up = std::max(rows / side, Index{1});
  MacroElements groups{{}, across * up, polynomials};
  for (Index c = 0; c < grid.cells(); ++c)
    groups.of_element.push_back((c % columns) * across / columns + (c / columns) * up / rows * across);
  return groups;
}

/// The elements around each vertex of a grid of triangles, in the order of elements.
struct Vertices {
  std::vector<std::vector<Index>> elements;    ///< around a vertex, ascending
  std::vector<std::vector<Index>> of_element;  ///< the vertices of an element and of its parts
};

Vertices vertices_of(const Grid& grid) {
  Vertices vertices{{}, std::vector<std::vector<Index>>(at(grid.cells() / grid.parts()))};
  std::map<std::pair<double, double>, Index> number;
  for (Index cell = 0; cell < grid.cells(); ++cell)
    for (const Vec2& x : grid.polygon(cell)) {
      const auto [found, is_new] = number.try_emplace({x.x(), x.y()}, static_cast<Index>(number.size()));
      if (is_new) vertices.elements.emplace_back();
      const Index element = cell / grid.parts();
      std::vector<Index>& around = vertices.elements[at(found->second)];
      if (!around.empty() && around.back() == element) continue;
      around.push_back(element);
      vertices.of_element[at(element)].push_back(found->second);
    }
  return vertices;
}

/// Stars: all elements around a vertex, which share no vertex with one another. −1 for elements of none.
MacroElements stars(const Grid& grid, PolynomialSpace polynomials) {
  constexpr std::size_t fewest = 4;  // at the border there are stars of fewer; so have inner vertices of parts
  const Vertices vertices = vertices_of(grid);
  MacroElements groups{std::vector<Index>(vertices.of_element.size(), -1), 0, polynomials};
  std::vector<char> taken(vertices.elements.size(), 0);
  for (const std::vector<Index>& star : vertices.elements) {
    const auto touches = [&](Index element) {
      return std::ranges::any_of(vertices.of_element[at(element)], [&](Index v) { return taken[at(v)] != 0; });
    };
    if (star.size() < fewest || std::ranges::any_of(star, touches)) continue;
    for (const Index element : star) {
      groups.of_element[at(element)] = groups.count;
      for (const Index v : vertices.of_element[at(element)]) taken[at(v)] = 1;
    }
    ++groups.count;
  }
  return groups;
}

/// Gives each element without a group to the smallest one beside it, round by round outward, until all have one; where
/// none is beside any, one more begins.
void fill_between(const Grid& grid, MacroElements& groups) {
  std::vector<Index> size(at(groups.count), 0);
  for (const Index group : groups.of_element)
    if (group >= 0) ++size[at(group)];
  for (bool complete = false; !complete;) {
    const std::vector<Index> before = groups.of_element;
    complete = true;
    Index unreached = -1;
    bool grown = false;
    for (std::size_t e = 0; e < before.size(); ++e) {
      if (before[e] >= 0) continue;
      Index& group = groups.of_element[e];
      for (const Index other : neighbours_of(grid, static_cast<Index>(e)))
        if (const Index theirs = before[at(other)]; theirs >= 0 && (group < 0 || size[at(theirs)] < size[at(group)]))
          group = theirs;
      complete = complete && group >= 0;
      grown = grown || group >= 0;
      if (group >= 0)
        ++size[at(group)];
      else if (unreached < 0)
        unreached = static_cast<Index>(e);
    }
    if (complete || grown) continue;
    groups.of_element[at(unreached)] = groups.count++;
    size.push_back(1);
  }
}

double area(const std::vector<Vec2>& polygon) {
  double twice = 0.0;
  for (std::size_t k = 2; k < polygon.size(); ++k) twice += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  return 0.5 * twice;
}

/// The group with which one shares most faces of elements in use; −1 where there is none.
Index most_shared(const MacroElements& groups, const Grid& grid, const std::vector<double>& volume, Index group) {
  std::map<Index, int> shared;
  for (std::size_t e = 0; e < groups.of_element.size(); ++e) {
    if (groups.of_element[e] != group || volume[e] == 0.0) continue;
    for (const Index other : neighbours_of(grid, static_cast<Index>(e)))
      if (groups.of_element[at(other)] != group && volume[at(other)] > 0.0) ++shared[groups.of_element[at(other)]];
  }
  const auto most = std::ranges::max_element(shared, {}, [](const auto& entry) { return entry.second; });
  return most == shared.end() ? -1 : most->first;
}

}  // namespace

Eigen::VectorXd PolynomialSpace::operator()(const Vec2& x) const {
  Eigen::VectorXd value(size());
  Eigen::Index k = 0;
  double row = 1.0;
  for (int b = 0; b <= degree; ++b, row *= x.y()) {
    double term = row;
    for (int a = 0; a <= (tensor ? degree : degree - b); ++a, term *= x.x()) value[k++] = term;
  }
  return value;
}

MacroElements macro_elements(const Basis& basis) {
  const int p = basis.degree();
  const Grid& grid = basis.grid();
  if (grid.polygon(0).size() == 4) return blocks(grid, p < 3 ? PolynomialSpace{p} : PolynomialSpace{p - 1, true});
  MacroElements groups = stars(grid, {p});
  fill_between(grid, groups);
  return groups;
}

MacroElements without_slivers(MacroElements groups, const Grid& grid, const std::vector<double>& volume) {
  constexpr double enough = 0.5;
  std::vector<double> whole(at(groups.count), 0.0);
  std::vector<double> held(at(groups.count), 0.0);
  for (Index cell = 0; cell < grid.cells(); ++cell)
    whole[at(groups.of_element[at(cell / grid.parts())])] += area(grid.polygon(cell));
  for (std::size_t e = 0; e < volume.size(); ++e) held[at(groups.of_element[e])] += volume[e];
  std::vector<std::pair<double, Index>> slivers;
  for (std::size_t g = 0; g < held.size(); ++g)
    if (held[g] > 0.0 && held[g] < enough * whole[g]) slivers.emplace_back(held[g] / whole[g], static_cast<Index>(g));
  std::ranges::sort(slivers);
  for (const auto& [share, group] : slivers)
    if (const Index other = most_shared(groups, grid, volume, group); other >= 0)
      std::ranges::replace(groups.of_element, group, other);
  return groups;
}

}  // namespace shoreline
