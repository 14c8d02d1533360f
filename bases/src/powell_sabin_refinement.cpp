#include "shoreline/bases/powell_sabin_refinement.hpp"

#include "mesh_edges.hpp"

namespace shoreline {
namespace {

std::size_t at(Index number) { return static_cast<std::size_t>(number); }

Vec2 incentre(const std::array<Vec2, 3>& p) {
  const double a = (p[2] - p[1]).norm();
  const double b = (p[0] - p[2]).norm();
  const double c = (p[1] - p[0]).norm();
  return (a * p[0] + b * p[1] + c * p[2]) / (a + b + c);
}

/// Where the line from y to z crosses the line from a to b, on the latter to the last digit.
Vec2 crossing(const Vec2& a, const Vec2& b, const Vec2& y, const Vec2& z) {
  const double s = cross(y - a, z - y) / cross(b - a, z - y);
  return a + s * (b - a);
}

}  // namespace

TriangleMesh powell_sabin_refinement(const TriangleMesh& main) {
  TriangleMesh refined{main.vertex, {}};
  const auto triangles = static_cast<Index>(main.triangle.size());
  for (Index t = 0; t < triangles; ++t) refined.vertex.push_back(incentre(corners(main, t)));
  const auto centre = [&](Index t) { return static_cast<Index>(main.vertex.size()) + t; };

  std::vector<std::array<Index, 3>> edge_point(main.triangle.size());
  for_each_edge(sorted_half_edges(main), [&](std::span<const HalfEdge> edge) {
    const Vec2& a = main.vertex[at(edge[0].low)];
    const Vec2& b = main.vertex[at(edge[0].high)];
    for (const HalfEdge& half : edge)
      edge_point[at(half.triangle)][static_cast<std::size_t>(half.side)] = static_cast<Index>(refined.vertex.size());
    refined.vertex.push_back(edge.size() == 1 ? Vec2(0.5 * (a + b))
                                              : crossing(a, b, refined.vertex[at(centre(edge[0].triangle))],
                                                         refined.vertex[at(centre(edge[1].triangle))]));
  });
  for (Index t = 0; t < triangles; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = main.triangle[at(t)][k];
      refined.triangle.push_back({v, edge_point[at(t)][k], centre(t)});
      refined.triangle.push_back({v, centre(t), edge_point[at(t)][(k + 2) % 3]});
    }
  return refined;
}

}  // namespace shoreline
