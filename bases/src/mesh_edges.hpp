#pragma once
// The edges of a triangle mesh, sorted so that the triangles that share one stand together.

#include <span>
#include <vector>

#include "shoreline/bases/triangle_mesh.hpp"

namespace shoreline {

/// An edge as one triangle sees it: from its vertex @ref side to the next one.
struct HalfEdge {
  Index low;  ///< the smaller number of the edge's two vertices
  Index high;
  Index triangle;
  int side;
  bool rises;  ///< the triangle runs from low to high
};

/// The half-edges of all triangles, sorted by their vertices.
[[nodiscard]] std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh);

/// Calls @p visit with the half-edges of each edge.
template <class Visit>
void for_each_edge(std::span<const HalfEdge> half_edges, Visit&& visit) {
  for (std::size_t begin = 0; begin < half_edges.size();) {
    std::size_t end = begin + 1;
    while (end < half_edges.size() && half_edges[end].low == half_edges[begin].low &&
           half_edges[end].high == half_edges[begin].high)
      ++end;
    visit(half_edges.subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace shoreline
