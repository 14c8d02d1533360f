#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

#include "mesh_edges.hpp"

namespace shoreline {
namespace {

constexpr double apart = 1e-10;  ///< of the mesh's extent: closer vertices are one

std::size_t at(Index number) { return static_cast<std::size_t>(number); }

double extent(const TriangleMesh& mesh) {
  const Box box = bounds(mesh);
  return (box.upper - box.lower).norm();
}

std::string text(double number) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", number);
  return buffer;
}

std::string text(const Vec2& x) { return "(" + text(x.x()) + ", " + text(x.y()) + ")"; }

/// Keeps the first breach of a rule and counts the others.
class Breaches {
 public:
  void add(const std::function<std::string()>& first) {
    if (count_++ == 0) first_ = first();
  }
  /// Throws if there were any.
  void report(const std::string& remedy) const {
    if (count_ == 0) return;
    const std::string others = count_ > 1 ? " (" + std::to_string(count_ - 1) + " more of the kind)" : "";
    throw MeshError("triangle mesh: " + first_ + others + "; " + remedy);
  }

 private:
  std::string first_;
  std::size_t count_ = 0;
};

std::string vertex_text(const TriangleMesh& mesh, Index v) {
  return "vertex " + std::to_string(v) + " at " + text(mesh.vertex[at(v)]);
}

std::string triangle_text(const TriangleMesh& mesh, Index t) {
  const auto& [a, b, c] = mesh.triangle[at(t)];
  const auto [p, q, r] = corners(mesh, t);
  return "triangle " + std::to_string(t) + " (vertices " + std::to_string(a) + ", " + std::to_string(b) + ", " +
         std::to_string(c) + ") at " + text((p + q + r) / 3.0);
}

std::string edge_text(const TriangleMesh& mesh, const HalfEdge& edge) {
  return "the edge from " + vertex_text(mesh, edge.low) + " to " + vertex_text(mesh, edge.high);
}

/// A direction along which vertices of regular meshes do not line up; lists sorted along it have short windows.
const Vec2 sweep(std::cos(1.0), std::sin(1.0));

/// Numbers of @p vertices, sorted along the sweep.
std::vector<Index> swept(const TriangleMesh& mesh, std::vector<Index> vertices) {
  std::ranges::sort(vertices, {}, [&](Index v) { return sweep.dot(mesh.vertex[at(v)]); });
  return vertices;
}

void check_lists(const TriangleMesh& mesh) {
  constexpr std::size_t most = std::numeric_limits<Index>::max() / 6;  // Powell-Sabin makes six of one
  if (mesh.triangle.empty() || mesh.triangle.size() > most || mesh.vertex.size() > most)
    throw MeshError("triangle mesh: need 1 to " + std::to_string(most) + " triangles and vertices, got " +
                    std::to_string(mesh.triangle.size()) + " and " + std::to_string(mesh.vertex.size()));
  const auto vertices = static_cast<Index>(mesh.vertex.size());
  for (Index v = 0; v < vertices; ++v)
    if (!mesh.vertex[at(v)].allFinite())
      throw MeshError("triangle mesh: " + vertex_text(mesh, v) + " is not finite; give numbers");
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t)
    for (const Index v : mesh.triangle[t])
      if (v < 0 || v >= vertices)
        throw MeshError("triangle mesh: triangle " + std::to_string(t) + " refers to vertex " + std::to_string(v) +
                        "; vertices are numbered 0 to " + std::to_string(vertices - 1));
}

void check_vertices(const TriangleMesh& mesh) {
  std::vector<Index> order(mesh.vertex.size());
  std::iota(order.begin(), order.end(), 0);
  order = swept(mesh, std::move(order));
  const double tolerance = apart * extent(mesh);
  Breaches duplicate;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const Vec2 gap = mesh.vertex[at(order[j])] - mesh.vertex[at(order[i])];
      if (sweep.dot(gap) > tolerance) break;
      if (gap.norm() > tolerance) continue;
      const auto [low, high] = std::minmax({order[i], order[j]});
      duplicate.add([&mesh, v = low, w = high] {
        return "vertex " + std::to_string(v) + " and " + vertex_text(mesh, w) + " are the same place";
      });
    }
  duplicate.report("give every place one vertex");

  std::vector<char> used(mesh.vertex.size(), 0);
  for (const auto& triangle : mesh.triangle)
    for (const Index v : triangle) used[at(v)] = 1;
  Breaches unused;
  for (Index v = 0; v < static_cast<Index>(mesh.vertex.size()); ++v)
    if (used[at(v)] == 0) unused.add([&] { return vertex_text(mesh, v) + " belongs to no triangle"; });
  unused.report("remove it");
}

void check_triangles(const TriangleMesh& mesh, double limit) {
  constexpr double degree = std::numbers::pi / 180.0;
  Breaches inverted;
  Breaches flat;
  Breaches sliver;
  for (Index t = 0; t < static_cast<Index>(mesh.triangle.size()); ++t) {
    const std::array<Vec2, 3> p = corners(mesh, t);
    const double area = twice_area(p[0], p[1], p[2]);
    const double angle = smallest_angle(p);
    if (area < 0.0) inverted.add([&] { return triangle_text(mesh, t) + " is inverted: its vertices run clockwise"; });
    if (area == 0.0) flat.add([&] { return triangle_text(mesh, t) + " is flat: its area is zero"; });
    if (area > 0.0 && angle < limit)
      sliver.add([&] {
        return triangle_text(mesh, t) + " is a sliver: its smallest angle is " + text(angle / degree) +
               " degrees, the limit is " + text(limit / degree);
      });
  }
  inverted.report("list the vertices of every triangle counter-clockwise");
  flat.report("remove it or move a vertex");
  sliver.report("mesh anew or move a vertex");
}

/// Whether @p x is in the interior of the edge ab, within @p tolerance.
bool in_interior(const Vec2& x, const Vec2& a, const Vec2& b, double tolerance) {
  const Vec2 along = (b - a).normalized();
  const double s = along.dot(x - a);
  return s > tolerance && s < (b - a).norm() - tolerance && std::abs(cross(along, x - a)) <= tolerance;
}

/// The vertices of a sorted list in the interior of an edge: the first, if any.
std::optional<Index> hanging_on(const TriangleMesh& mesh, const std::vector<Index>& sorted, const HalfEdge& edge,
                                double tolerance) {
  const auto key = [&](Index v) { return sweep.dot(mesh.vertex[at(v)]); };
  const auto [from, to] = std::minmax({key(edge.low), key(edge.high)});
  for (auto v = std::ranges::lower_bound(sorted, from - tolerance, {}, key); v != sorted.end(); ++v) {
    if (key(*v) > to + tolerance) break;
    if (in_interior(mesh.vertex[at(*v)], mesh.vertex[at(edge.low)], mesh.vertex[at(edge.high)], tolerance)) return *v;
  }
  return std::nullopt;
}

void check_edges(const TriangleMesh& mesh) {
  Breaches crowded;
  std::vector<HalfEdge> border;
  for_each_edge(sorted_half_edges(mesh), [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) border.push_back(edge[0]);
    if (edge.size() > 2 || (edge.size() == 2 && edge[0].rises == edge[1].rises))
      crowded.add([&] {
        return edge_text(mesh, edge[0]) + " has two triangles on one side, " + triangle_text(mesh, edge[0].triangle) +
               " and " + triangle_text(mesh, edge[1].triangle) + " among its " + std::to_string(edge.size());
      });
  });
  crowded.report("remove the triangles that overlap");

  std::vector<Index> on_border;
  for (const HalfEdge& edge : border) on_border.insert(on_border.end(), {edge.low, edge.high});
  std::ranges::sort(on_border);
  on_border.erase(std::unique(on_border.begin(), on_border.end()), on_border.end());
  on_border = swept(mesh, std::move(on_border));
  const double tolerance = apart * extent(mesh);
  Breaches hanging;
  for (const HalfEdge& edge : border)
    if (const auto v = hanging_on(mesh, on_border, edge, tolerance))
      hanging.add([&] {
        return vertex_text(mesh, *v) + " hangs on " + edge_text(mesh, edge) + " of " +
               triangle_text(mesh, edge.triangle);
      });
  hanging.report("split that triangle at the vertex");
}

void check_components(const TriangleMesh& mesh) {
  const std::vector<std::array<Index, 3>> neighbour = neighbours(mesh);
  std::vector<char> seen(mesh.triangle.size(), 0);
  std::vector<Index> stack{0};
  seen[0] = 1;
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    for (const Index other : neighbour[at(t)])
      if (other >= 0 && seen[at(other)] == 0) {
        seen[at(other)] = 1;
        stack.push_back(other);
      }
  }
  Breaches apart_from_first;
  for (Index t = 0; t < static_cast<Index>(mesh.triangle.size()); ++t)
    if (seen[at(t)] == 0)
      apart_from_first.add([&] {
        return "several parts share no edge: " + triangle_text(mesh, t) + " does not hang together with " +
               triangle_text(mesh, 0);
      });
  apart_from_first.report("keep one part, or join them by common vertices");
}

}  // namespace

void check(const TriangleMesh& mesh, double angle_limit) {
  check_lists(mesh);
  check_vertices(mesh);
  check_triangles(mesh, angle_limit);
  check_edges(mesh);
  check_components(mesh);
}

}  // namespace shoreline
