#pragma once
// A grid of each basis over the same square.

#include <memory>

#include "bases/meshes.hpp"
#include "exact_points.hpp"
#include "shoreline/engine/scene.hpp"

namespace shoreline::test {

struct NamedGrid {
  std::string name;
  Case::Grid grid;
};

/// Delaunay triangles of jittered points over a square, straight along its sides.
inline std::shared_ptr<const TriangleMesh> jittered_square(const Vec2& lower, double side, Index cells) {
  Random random(3);
  std::vector<Vec2> points = jittered_points(cells, cells, random, 0.25);
  for (Vec2& p : points) p = lower + side / cells * p;
  return std::make_shared<TriangleMesh>(delaunay(points));
}

/// Every basis over the square from @p lower, with @p cells cells in its side.
inline std::vector<NamedGrid> every_grid(const Vec2& lower, double side, Index cells) {
  using Type = Case::BasisType;
  const Case::Grid grid{
      .lower = lower, .upper = lower + Vec2(side, side), .cell_size = Vec2(side, side) / static_cast<double>(cells)};
  std::vector<NamedGrid> all{{"bilinear", grid}};
  for (const auto& [name, type] : {std::pair("linear", Type::linear), std::pair("Powell-Sabin", Type::powell_sabin)}) {
    Case::Grid triangles = grid;
    triangles.basis = type;
    all.push_back({std::string(name) + ", diagonal", triangles});
    triangles.pattern = TrianglePattern::four;
    all.push_back({std::string(name) + ", four", triangles});
    triangles.mesh = jittered_square(lower, side, cells);
    all.push_back({std::string(name) + ", Delaunay", triangles});
  }
  for (const int p : {1, 2, 3}) {
    Case::Grid splines = grid;
    splines.basis = Type::bspline;
    splines.degree = p;
    all.push_back({"B-splines of degree " + std::to_string(p), splines});
  }
  return all;
}

/// The basis of a case's grid.
inline std::unique_ptr<const Basis> basis_of(const Case::Grid& grid) {
  Case problem;
  problem.material = {.youngs_modulus = 1.0, .poissons_ratio = 0.0, .density = {}};
  problem.grid = grid;
  const Vec2 middle = grid.mesh
                          ? (corners(*grid.mesh, 0)[0] + corners(*grid.mesh, 0)[1] + corners(*grid.mesh, 0)[2]) / 3.0
                          : Vec2(0.5 * (grid.lower + grid.upper));
  problem.material_points = std::vector<Case::ListedPoint>{{middle, 1.0}};
  return std::move(build_scene(problem).basis);
}

/// Points of a body with which every basis passes the patch test: exact for gradients of its functions.
inline std::vector<Case::ListedPoint> patch_points(const Case::Grid& grid, const std::vector<Vec2>& body) {
  const std::unique_ptr<const Basis> basis = basis_of(grid);
  return exact_points(basis->grid(), body, grid.basis == Case::BasisType::bspline ? grid.degree + 1 : 2);
}

}  // namespace shoreline::test
