#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <set>
#include <string>

#include "shoreline/bases/mesh_generators.hpp"

namespace shoreline {
namespace {

namespace polygon = boost::polygon;

std::size_t at(Index number) { return static_cast<std::size_t>(number); }

[[noreturn]] void fail(const std::string& problem) { throw MeshError("delaunay: " + problem); }

/// The points on a raster of 2³⁰ steps, on which Boost.Polygon computes without error.
std::vector<polygon::point_data<int>> on_raster(const std::vector<Vec2>& points, const Box& box) {
  const double steps_per_metre = std::ldexp(1.0, 30) / (box.upper - box.lower).maxCoeff();
  std::vector<polygon::point_data<int>> raster;
  raster.reserve(points.size());
  for (const Vec2& p : points) {
    const Vec2 steps = steps_per_metre * (p - box.lower);
    raster.emplace_back(static_cast<int>(std::lround(steps.x())), static_cast<int>(std::lround(steps.y())));
  }
  return raster;
}

/// The triangles around each Voronoi vertex: the points whose cells meet there, as a fan.
std::vector<std::array<Index, 3>> dual_triangles(const std::vector<polygon::point_data<int>>& points) {
  polygon::voronoi_diagram<double> diagram;
  polygon::construct_voronoi(points.begin(), points.end(), &diagram);
  std::vector<std::array<Index, 3>> triangles;
  for (const auto& vertex : diagram.vertices()) {
    std::vector<Index> around;
    const auto* const first = vertex.incident_edge();
    const auto* edge = first;
    do {
      around.push_back(static_cast<Index>(edge->cell()->source_index()));
      edge = edge->rot_next();
    } while (edge != first);
    for (std::size_t k = 1; k + 1 < around.size(); ++k) triangles.push_back({around[0], around[k], around[k + 1]});
  }
  return triangles;
}

/// Takes triangles with a border edge and a small angle away, until there are none.
void peel(TriangleMesh& mesh) {
  const auto on_border = [](const std::array<Index, 3>& across) { return std::ranges::count(across, -1) > 0; };
  for (bool peeled = true; peeled;) {
    const std::vector<std::array<Index, 3>> neighbour = neighbours(mesh);
    std::vector<std::array<Index, 3>> kept;
    for (Index t = 0; t < static_cast<Index>(mesh.triangle.size()); ++t)
      if (!on_border(neighbour[at(t)]) || smallest_angle(corners(mesh, t)) >= smallest_allowed_angle)
        kept.push_back(mesh.triangle[at(t)]);
    peeled = kept.size() < mesh.triangle.size();
    mesh.triangle = std::move(kept);
  }
}

using DirectedEdge = std::pair<Index, Index>;

/// The edges of an outline, with the meshed area to their left.
std::set<DirectedEdge> edges_of(const std::vector<Index>& outline, const std::vector<Vec2>& points) {
  std::set<DirectedEdge> edges;
  double twice = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const DirectedEdge edge{outline[k], outline[(k + 1) % outline.size()]};
    for (const Index number : {edge.first, edge.second})
      if (number < 0 || at(number) >= points.size())
        fail("the outline names point " + std::to_string(number) + ", expected 0 to " +
             std::to_string(points.size() - 1));
    edges.insert(edge);
    twice += cross(points[at(edge.first)], points[at(edge.second)]);
  }
  if (twice <= 0.0) fail("the outline runs clockwise or encloses nothing, expected counter-clockwise");
  return edges;
}

/// Leaves out the triangles that are not inside an outline.
void keep_inside(const std::set<DirectedEdge>& outline, TriangleMesh& mesh) {
  const std::vector<std::array<Index, 3>> neighbour = neighbours(mesh);
  const auto edge = [&](Index t, std::size_t k) -> DirectedEdge {
    return {mesh.triangle[at(t)][k], mesh.triangle[at(t)][(k + 1) % 3]};
  };
  std::set<DirectedEdge> missing = outline;
  std::vector<char> inside(mesh.triangle.size(), 0);
  std::vector<Index> front;
  const auto reach = [&](Index t) {
    if (t >= 0 && std::exchange(inside[at(t)], 1) == 0) front.push_back(t);
  };
  for (Index t = 0; t < static_cast<Index>(mesh.triangle.size()); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (missing.erase(edge(t, k)) > 0) reach(t);
  if (!missing.empty())
    fail("the outline from point " + std::to_string(missing.begin()->first) + " to point " +
         std::to_string(missing.begin()->second) + " is no edge of the triangulation; put more points on it");
  while (!front.empty()) {
    const Index t = front.back();
    front.pop_back();
    for (std::size_t k = 0; k < 3; ++k)
      if (!outline.contains(edge(t, k))) reach(neighbour[at(t)][k]);
  }
  std::vector<std::array<Index, 3>> kept;
  for (std::size_t t = 0; t < inside.size(); ++t)
    if (inside[t] != 0) kept.push_back(mesh.triangle[t]);
  mesh.triangle = std::move(kept);
}

}  // namespace

TriangleMesh delaunay(const std::vector<Vec2>& points, const std::vector<Index>& outline) {
  if (points.size() < 3) fail("need at least 3 points, got " + std::to_string(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!points[k].allFinite()) fail("point " + std::to_string(k) + " is not finite");
  TriangleMesh mesh{points, {}};
  if (const Box box = bounds(mesh); box.lower != box.upper) mesh.triangle = dual_triangles(on_raster(points, box));
  peel(mesh);
  if (mesh.triangle.empty()) fail("all points lie on one line");
  if (!outline.empty()) keep_inside(edges_of(outline, points), mesh);
  check(mesh);
  return mesh;
}

}  // namespace shoreline
