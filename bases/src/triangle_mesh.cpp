#include "shoreline/bases/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh_edges.hpp"

namespace shoreline {

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
  const auto for_each = [&mesh](auto&& visit) {
    for (Index t = 0; t < static_cast<Index>(mesh.triangle.size()); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index from = mesh.triangle[static_cast<std::size_t>(t)][k];
        const Index to = mesh.triangle[static_cast<std::size_t>(t)][(k + 1) % 3];
        visit(HalfEdge{std::min(from, to), std::max(from, to), t, static_cast<int>(k), from < to});
      }
  };
  std::vector<std::size_t> first(mesh.vertex.size() + 1, 0);  // edges by their low vertex
  for_each([&](const HalfEdge& e) { ++first[static_cast<std::size_t>(e.low) + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<HalfEdge> edges(first.back());
  std::vector<std::size_t> next = first;
  for_each([&](const HalfEdge& e) { edges[next[static_cast<std::size_t>(e.low)]++] = e; });
  for (std::size_t v = 0; v + 1 < first.size(); ++v)
    std::ranges::stable_sort(std::span(edges).subspan(first[v], first[v + 1] - first[v]), {}, &HalfEdge::high);
  return edges;
}

std::vector<std::array<Index, 3>> neighbours(const TriangleMesh& mesh) {
  std::vector<std::array<Index, 3>> neighbour(mesh.triangle.size(), {-1, -1, -1});
  for_each_edge(sorted_half_edges(mesh), [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 2) return;
    for (const auto& [own, other] : {std::pair(edge[0], edge[1]), std::pair(edge[1], edge[0])})
      neighbour[static_cast<std::size_t>(own.triangle)][static_cast<std::size_t>(own.side)] = other.triangle;
  });
  return neighbour;
}

Box bounds(const TriangleMesh& mesh) {
  Box box{mesh.vertex.front(), mesh.vertex.front()};
  for (const Vec2& x : mesh.vertex) box = {box.lower.cwiseMin(x), box.upper.cwiseMax(x)};
  return box;
}

double smallest_angle(const std::array<Vec2, 3>& triangle) {
  double smallest = std::numbers::pi;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 next = triangle[(k + 1) % 3] - triangle[k];
    const Vec2 last = triangle[(k + 2) % 3] - triangle[k];
    smallest = std::min(smallest, std::atan2(cross(next, last), next.dot(last)));
  }
  return smallest;
}

}  // namespace shoreline
