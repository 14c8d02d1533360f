#pragma once
// Triangle meshes for tests: regular, jittered, graded, of slivers, with holes and re-entrant corners; any place and
// direction.

#include <cmath>
#include <numbers>
#include <string>

#include "../random.hpp"
#include "shoreline/bases/mesh_generators.hpp"

namespace shoreline::test {

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

inline constexpr double pi = std::numbers::pi;
inline constexpr double degree = pi / 180.0;

/// Turns by any angle and moves anywhere.
inline void place(TriangleMesh& mesh, Random& random) {
  const Vec2 x = random.direction();
  const Vec2 shift = random.vector(-5.0, 5.0);
  for (Vec2& v : mesh.vertex) v = Vec2(x.x() * v.x() - x.y() * v.y(), x.y() * v.x() + x.x() * v.y()) + shift;
}

inline bool is_valid(const TriangleMesh& mesh, double smallest_angle) {
  try {
    check(mesh, smallest_angle);
    return true;
  } catch (const MeshError&) {
    return false;
  }
}

/// Moves each vertex inside a unit lattice by up to 0.35 in each direction, unless an angle falls below 2°.
inline void jitter(TriangleMesh& mesh, Random& random) {
  const Box box = bounds(mesh);
  for (Vec2& v : mesh.vertex) {
    const Vec2 old = v;
    if ((v - box.lower).minCoeff() > 0.0 && (box.upper - v).minCoeff() > 0.0) v += random.vector(-0.35, 0.35);
    if (!is_valid(mesh, 2.0 * degree)) v = old;
  }
}

inline TriangleMesh lattice(Index columns, Index rows, TrianglePattern pattern, const Vec2& spacing = Vec2::Ones()) {
  return triangulate(QuadrilateralGrid(Vec2::Zero(), spacing, {columns, rows}), pattern);
}

/// Points of a unit lattice, inside moved by up to @p most in each direction, on its sides along them.
inline std::vector<Vec2> jittered_points(Index columns, Index rows, Random& random, double most = 0.35) {
  std::vector<Vec2> points = lattice(columns, rows, TrianglePattern::diagonal).vertex;
  for (Vec2& p : points) {
    const Vec2 move = random.vector(-most, most);
    if (p.x() > 0.0 && p.x() < columns) p.x() += move.x();
    if (p.y() > 0.0 && p.y() < rows) p.y() += move.y();
  }
  return points;
}

/// The mesh without some triangles and without the vertices that these leave unused.
inline TriangleMesh without(const TriangleMesh& mesh, const auto& dropped) {
  TriangleMesh rest;
  std::vector<Index> number(mesh.vertex.size(), -1);
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    if (dropped(static_cast<Index>(t))) continue;
    auto& triangle = rest.triangle.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      Index& n = number[static_cast<std::size_t>(mesh.triangle[t][k])];
      if (n < 0) {
        n = static_cast<Index>(rest.vertex.size());
        rest.vertex.push_back(mesh.vertex[static_cast<std::size_t>(mesh.triangle[t][k])]);
      }
      triangle[k] = n;
    }
  }
  return rest;
}

/// A fan of triangles around a point: a polygon with corners on a circle.
inline TriangleMesh fan(Index corners) {
  TriangleMesh mesh{{Vec2::Zero()}, {}};
  for (Index k = 0; k < corners; ++k) {
    const double angle = 2.0 * pi * k / corners;
    mesh.vertex.emplace_back(std::cos(angle), std::sin(angle));
    mesh.triangle.push_back({0, 1 + k, 1 + (k + 1) % corners});
  }
  return mesh;
}

/// A fan over three quarters of a turn, of uneven edges: its centre is a re-entrant corner.
inline TriangleMesh open_fan(Index triangles, Random& random) {
  TriangleMesh mesh{{Vec2::Zero()}, {}};
  for (Index k = 0; k <= triangles; ++k) {
    const double angle = 1.5 * pi * k / triangles;
    mesh.vertex.push_back(random.uniform(0.1, 1.0) * Vec2(std::cos(angle), std::sin(angle)));
    if (k > 0) mesh.triangle.push_back({0, k, k + 1});
  }
  return mesh;
}

/// One mesh of each kind.
inline std::vector<NamedMesh> meshes(Random& random) {
  std::vector<NamedMesh> all;
  for (const TrianglePattern pattern : {TrianglePattern::diagonal, TrianglePattern::four}) {
    const std::string cut = pattern == TrianglePattern::diagonal ? ", diagonal" : ", four";
    const Index columns = random.whole(3, 6);
    const Index rows = random.whole(3, 6);
    all.push_back({"regular" + cut, lattice(columns, rows, pattern, random.vector(0.05, 2.0))});
    all.push_back({"jittered" + cut, lattice(columns, rows, pattern)});
    jitter(all.back().mesh, random);
    all.push_back({"graded 1:100" + cut, lattice(12, 4, pattern)});
    for (Vec2& v : all.back().mesh.vertex)  // a quarter of a ring between radius 0.01 and 1
      v = std::pow(100.0, v.x() / 12.0 - 1.0) * Vec2(std::cos(v.y() * pi / 8.0), std::sin(v.y() * pi / 8.0));
    all.push_back({"slivers of 2 degrees" + cut, lattice(3, 3, pattern, {1.0, std::tan(2.0 * degree)})});
    const TriangleMesh square = lattice(4, 4, pattern);
    const Index per_cell = pattern == TrianglePattern::diagonal ? 2 : 4;
    all.push_back({"hole" + cut, without(square, [&](Index t) { return t / per_cell == 5; })});
    all.push_back({"re-entrant corner" + cut, without(square, [&](Index t) { return t / per_cell >= 10; })});
  }
  all.push_back({"Delaunay", delaunay(jittered_points(random.whole(3, 6), random.whole(3, 6), random))});
  all.push_back({"fan", fan(random.whole(3, 40))});
  all.push_back({"open fan", open_fan(random.whole(4, 9), random)});
  for (NamedMesh& named : all) place(named.mesh, random);
  return all;
}

/// A place in a triangle.
inline Vec2 inside(const std::array<Vec2, 3>& p, Random& random) {
  double r = random.uniform(0.0, 1.0);
  double s = random.uniform(0.0, 1.0);
  if (r + s > 1.0) {
    r = 1.0 - r;
    s = 1.0 - s;
  }
  return p[0] + r * (p[1] - p[0]) + s * (p[2] - p[0]);
}

}  // namespace shoreline::test
