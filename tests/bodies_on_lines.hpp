#pragma once
// A square whose sides lie on lines of grids of every kind: on the border, or inside.

#include <Eigen/Geometry>

#include "../engine/src/make_basis.hpp"
#include "bases/meshes.hpp"
#include "exact_points.hpp"
#include "shoreline/engine/quasi_static.hpp"

namespace shoreline::test {

inline constexpr int square_side = 3;  ///< of the body, in cells of 1 m

/// A basis with a square on its lines.
struct Setting {
  std::string name;
  Case::Grid grid{};
  double angle = 0.0;  ///< by which grid and body are turned [rad]

  [[nodiscard]] Vec2 turned(double x, double y) const { return Eigen::Rotation2Dd(angle) * Vec2(x, y); }
};

/// A mesh of unit squares cut in two or four, whose vertices are moved, those on the body's sides along them.
inline TriangleMesh jittered_around_body(TrianglePattern pattern, int margin, Random& random) {
  const int cells = square_side + 2 * margin;
  TriangleMesh mesh = triangulate(QuadrilateralGrid(Vec2::Constant(-margin), Vec2::Ones(), {cells, cells}), pattern);
  const auto on_side = [](double across, double along) {
    return (across == 0.0 || across == square_side) && along >= 0.0 && along <= square_side;
  };
  for (Vec2& v : mesh.vertex) {
    const Vec2 old = v;
    Vec2 move = random.vector(-0.35, 0.35);
    const bool border = (v.array() + margin).minCoeff() == 0.0 || (square_side + margin - v.array()).minCoeff() == 0.0;
    if (border && margin > 0) continue;
    if (on_side(v.x(), v.y())) move.x() = 0.0;
    if (on_side(v.y(), v.x())) move.y() = 0.0;
    v += move;
    if (!is_valid(mesh, 5.0 * degree)) v = old;
  }
  return mesh;
}

inline void turn(TriangleMesh& mesh, double angle) {
  for (Vec2& v : mesh.vertex) v = Eigen::Rotation2Dd(angle) * v;
}

/// Every basis with the square on the border and inside; on moved vertices, also turned.
inline std::vector<Setting> settings(Random& random) {
  using enum Case::BasisType;
  std::vector<Setting> all;
  for (const int margin : {0, 2}) {
    const std::string where = margin == 0 ? ", border" : ", inside";
    const Case::Grid grid{
        .lower = Vec2::Constant(-margin), .upper = Vec2::Constant(square_side + margin), .cell_size = Vec2::Ones()};
    const auto add = [&](std::string name, Case::BasisType basis, int p, TrianglePattern pattern) {
      all.push_back({std::move(name) + where, grid});
      all.back().grid.basis = basis;
      all.back().grid.degree = p;
      all.back().grid.pattern = pattern;
    };
    add("bilinear", bilinear, 1, TrianglePattern::diagonal);
    for (const int p : {2, 3}) add("B-spline of degree " + std::to_string(p), bspline, p, TrianglePattern::diagonal);
    for (const Case::BasisType basis : {linear, powell_sabin}) {
      const std::string name = name_of(basis);
      add(name + ", diagonal", basis, 1, TrianglePattern::diagonal);
      add(name + ", four", basis, 1, TrianglePattern::four);
      const auto add_mesh = [&](const std::string& kind, TriangleMesh mesh, double angle) {
        turn(mesh, angle);
        all.push_back({name + ", " + kind + where, {.basis = basis}, angle});
        all.back().grid.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
      };
      add_mesh("moved", jittered_around_body(TrianglePattern::diagonal, margin, random), 0.0);
      add_mesh("moved and turned", jittered_around_body(TrianglePattern::four, margin, random), 0.4);
      if (margin == 0) add_mesh("Delaunay", delaunay(jittered_points(square_side, square_side, random)), 0.0);
    }
  }
  return all;
}

/// The square, with material points that integrate what its basis needs exactly. Nothing acts on it.
inline Case body_on_lines(const Setting& setting) {
  constexpr double s = square_side;
  const std::vector<Vec2> corner{setting.turned(0, 0), setting.turned(s, 0), setting.turned(s, s),
                                 setting.turned(0, s)};
  Case problem;
  problem.file = "square.json";
  problem.material = {.youngs_modulus = 1e6, .poissons_ratio = 0.3, .density = {}};
  problem.grid = setting.grid;
  const char* name[] = {"bottom", "right", "top", "left"};
  for (std::size_t k = 0; k < 4; ++k)
    problem.boundaries.push_back({{.name = name[k], .points = {corner[k], corner[(k + 1) % 4]}}, Case::Free{}});
  const auto basis = make_basis(setting.grid);
  problem.material_points = exact_points(basis->grid(), corner, basis->degree() + 1);
  return problem;
}

}  // namespace shoreline::test
