#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>

#include "shoreline/bases/mesh_generators.hpp"

namespace shoreline {
namespace {

namespace polygon = boost::polygon;

std::size_t at(Index number) { return static_cast<std::size_t>(number); }

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

}  // namespace

TriangleMesh delaunay(const std::vector<Vec2>& points) {
  const auto fail = [](const std::string& problem) { throw MeshError("delaunay: " + problem); };
  if (points.size() < 3) fail("need at least 3 points, got " + std::to_string(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!points[k].allFinite()) fail("point " + std::to_string(k) + " is not finite");
  TriangleMesh mesh{points, {}};
  if (const Box box = bounds(mesh); box.lower != box.upper) mesh.triangle = dual_triangles(on_raster(points, box));
  peel(mesh);
  if (mesh.triangle.empty()) fail("all points lie on one line");
  check(mesh);
  return mesh;
}

}  // namespace shoreline
