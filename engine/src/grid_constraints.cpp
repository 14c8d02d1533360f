#include "grid_constraints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "constraint_rows.hpp"
#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

constexpr double on_line = 1e-9;      ///< of a cell
constexpr double shortest = 1e-6;     ///< of a cell: a piece that ends as little beyond a vertex ends there
constexpr double negligible = 1e-12;  ///< value of a function that vanishes, but for rounding

InvalidArgument refused(const BoundaryPiece& piece, const Vec2& x, const char* problem, const char* remedy) {
  return InvalidArgument(
      fmt::format("piece \"{}\" has method \"grid\" but {} near ({:.6g}, {:.6g}); use method \"implicit_boundary\" or "
                  "\"nitsche\", or {}",
                  piece.piece.name, problem, x.x(), x.y(), remedy));
}

/// An edge of a cell, from a to b.
struct CellEdge {
  Vec2 a;
  Vec2 b;
};

/// The edge of a cell on which points of the cell lie.
std::optional<CellEdge> edge_under(const Grid& grid, Index cell, std::span<const BoundaryPoint> points) {
  const std::vector<Vec2> polygon = grid.polygon(cell);
  const double tolerance = on_line * grid.size(cell);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2& a = polygon[k];
    const Vec2& b = polygon[(k + 1) % polygon.size()];
    const Vec2 along = (b - a).normalized();
    if (std::ranges::all_of(points,
                            [&](const BoundaryPoint& p) { return std::abs(cross(along, p.x - a)) <= tolerance; }))
      return CellEdge{a, b};
  }
  return std::nullopt;
}

/// Whether an edge parts two cells of one element.
bool inside_element(const Grid& grid, const HeldCellEdge& edge) {
  if (grid.parts() == 1) return false;
  const std::vector<Face> faces = grid.faces(edge.cell);
  return std::ranges::any_of(faces, [&](const Face& face) {
    return face.a == edge.a && face.b == edge.b && face.neighbour / grid.parts() == edge.cell / grid.parts();
  });
}

/// Whether points lie beside the grid, where no edge is under them; by more than border_slack they are not traced.
bool beyond(const Grid& grid, Index cell, std::span<const BoundaryPoint> points) {
  const Vec2& x = points[points.size() / 2].x;
  const Box box = grid.bounds();
  return std::max((box.lower - x).maxCoeff(), (x - box.upper).maxCoeff()) > on_line * grid.size(cell);
}

/// What a piece asks for.
struct Held {
  int piece;
  bool normal_only;
  const Eigen::Matrix2Xd* prescribed;  ///< (2, functions) [m], or none: zero
};

/// The condition on one component of u, in direction n, at a place.
ConstraintRow row_at(const Support& support, const Vec2& n, const Held& held) {
  ConstraintRow row{.coefficient = {}, .value = 0.0, .piece = held.piece};
  for (Eigen::Index a = 0; a < support.value.size(); ++a)
    for (const int component : {0, 1}) {
      const double coefficient = support.value[a] * n[component];
      if (std::abs(coefficient) < negligible) continue;
      row.coefficient.emplace(2 * support.function[a] + component, coefficient);
      if (held.prescribed != nullptr) row.value += coefficient * (*held.prescribed)(component, support.function[a]);
    }
  return row;
}

ConstraintRow row_of(const Constraint& c) {
  ConstraintRow row{.coefficient = {{2 * c.function + c.component, 1.0}}, .value = c.value, .piece = c.piece};
  for (const ComponentTerm& m : c.masters) row.coefficient.emplace(2 * m.function + m.component, -m.coefficient);
  return row;
}

/// The conditions along one edge: at degree + 1 places, which settle the polynomial.
///
/// They are solved among themselves first. Were each solved after those of the edges before, rounding errors would grow
/// from edge to edge, as they do in an extrapolation.
void add_rows(const Basis& basis, const HeldCellEdge& edge, const Held& held, ConstraintRows& rows) {
  const Vec2 along = (edge.b - edge.a).normalized();
  std::vector<Vec2> directions{Vec2::UnitX(), Vec2::UnitY()};
  if (held.normal_only) directions = {Vec2(-along.y(), along.x())};
  ConstraintRows here;
  for (int q = 0; q <= basis.degree(); ++q) {
    const Vec2 x = edge.a + static_cast<double>(q) / basis.degree() * (edge.b - edge.a);
    const Support support = basis.support(edge.cell, x);
    for (const Vec2& n : directions) here.add(row_at(support, n, held));
  }
  for (const Constraint& c : here.solved()) rows.add(row_of(c));
}

}  // namespace

std::vector<HeldCellEdge> held_cell_edges(const Basis& basis, const std::vector<BoundaryPiece>& boundary,
                                          const std::vector<Edge>& edges) {
  const Grid& grid = basis.grid();
  std::vector<HeldCellEdge> held;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const auto* condition = std::get_if<Essential>(&boundary[k].condition);
    if (condition == nullptr || condition->method != EssentialMethod::grid) continue;
    const Edge& edge = edges[k];
    for (std::size_t s = 0; s < edge.segments.size(); ++s) {
      const auto n = static_cast<std::size_t>(edge.points_per_segment);
      const std::span points(&edge.points[s * n], n);
      const Index cell = edge.segments[s].cell;
      double length = 0.0;
      for (const BoundaryPoint& p : points) length += p.weight;
      if (length < shortest * grid.size(cell) || beyond(grid, cell, points)) continue;
      const std::optional<CellEdge> under = edge_under(grid, cell, points);
      if (!under) throw refused(boundary[k], points.front().x, "leaves the grid lines", "move the grid");
      held.push_back({static_cast<int>(k), cell, under->a, under->b, points.front().x});
    }
  }
  return held;
}

std::vector<Constraint> constraints_along(const std::vector<HeldCellEdge>& held, const Basis& basis,
                                          const std::vector<BoundaryPiece>& boundary,
                                          const Eigen::Matrix2Xd& prescribed) {
  ConstraintRows rows;
  for (const HeldCellEdge& edge : held) {
    const BoundaryPiece& piece = boundary[static_cast<std::size_t>(edge.piece)];
    const auto& condition = std::get<Essential>(piece.condition);
    if (inside_element(basis.grid(), edge))
      throw refused(piece, edge.near, "runs through the inside of a triangle", "a mesh with edges along the piece");
    const bool moves = condition.value && prescribed.cols() > 0;
    add_rows(basis, edge, {edge.piece, condition.normal_only, moves ? &prescribed : nullptr}, rows);
  }
  return rows.solved();
}

std::vector<Constraint> grid_constraints(const Basis& basis, const std::vector<BoundaryPiece>& boundary,
                                         const std::vector<Edge>& edges, const Eigen::Matrix2Xd& prescribed) {
  return constraints_along(held_cell_edges(basis, boundary, edges), basis, boundary, prescribed);
}

}  // namespace shoreline
