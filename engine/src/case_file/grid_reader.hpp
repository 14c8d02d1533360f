#pragma once
// Grid and basis of a case.

#include <array>
#include <filesystem>

#include "node.hpp"
#include "shoreline/engine/case.hpp"

namespace shoreline {

/// A value given once for both directions, or once each.
template <class T>
std::array<T, 2> pair_of(const Node& node) {
  if (node.value.is_array()) return node.as<std::array<T, 2>>();
  return {node.as<T>(), node.as<T>()};
}

/// Reads the grid with its mesh, and checks that it can carry its basis.
/// @param folder  of the case, from which the path of a mesh starts
/// @throws CaseError for keys that contradict each other, too many cells, a mesh file that cannot be read, and
/// triangles
///         that break a rule of check(mesh)
[[nodiscard]] Case::Grid read_grid(const Node& node, const std::filesystem::path& folder);

[[nodiscard]] bool has_triangles(Case::BasisType basis);

/// Rectangles, or main triangles: what a lattice of material points fills.
[[nodiscard]] double cells_to_fill(const Case::Grid& grid);

}  // namespace shoreline
