#include "body.hpp"

#include <fmt/format.h>

#include "make_basis.hpp"
#include "shoreline/boundary/outline.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/trace.hpp"
#include "shoreline/engine/failures.hpp"

namespace shoreline {
namespace {

constexpr double on_outline = 1e-9;  ///< of a cell: a point this near to the outline lies on it

CaseError piece_error(const Case& problem, int piece, const std::string& message) {
  return {problem.file.string(), fmt::format("/boundaries/{}", piece), message};
}

std::vector<SplineCurve> fit_all(const Case& problem) {
  std::vector<SplineCurve> curves;
  for (std::size_t k = 0; k < problem.boundaries.size(); ++k) try {
      curves.push_back(fit_spline(problem.boundaries[k].piece));
    } catch (const InvalidArgument& error) {
      throw piece_error(problem, static_cast<int>(k), error.what());
    }
  return curves;
}

/// Closes and checks the outline, and that it lies in the grid.
std::vector<std::vector<int>> close_outline(const Case& problem, const std::vector<SplineCurve>& curves,
                                            const Grid& grid) {
  std::vector<Piece> pieces;
  for (const Case::Boundary& b : problem.boundaries) pieces.push_back(b.piece);
  try {
    std::vector<std::vector<int>> loops = close_loops(pieces);
    check_outline(pieces, curves, loops);
    for (std::size_t k = 0; k < curves.size(); ++k) try {
        static_cast<void>(trace(curves[k], grid, pieces[k].name));
      } catch (const OutsideGrid& error) {
        throw OutlineError(static_cast<int>(k),
                           std::string(error.what()) +
                               (problem.grid.mesh ? "; enlarge the mesh" : "; enlarge grid.lower and grid.upper"));
      }
    return loops;
  } catch (const OutlineError& error) {
    throw piece_error(problem, error.piece(), error.what());
  }
}

/// Points listed by hand.
/// @throws InvalidArgument naming the first point outside the grid or outside the outline
MaterialPoints listed_points(const std::vector<Case::ListedPoint>& listed, const Grid& grid, const Region* body) {
  Eigen::Matrix2Xd position(2, static_cast<Eigen::Index>(listed.size()));
  Eigen::VectorXd volume(position.cols());
  for (std::size_t p = 0; p < listed.size(); ++p) {
    const Vec2& x = listed[p].position;
    if (const char* left = left_by(x, grid, body))
      throw InvalidArgument(fmt::format("point {} at ({:.6g}, {:.6g}) lies outside the {}", p, x.x(), x.y(), left));
    position.col(static_cast<Eigen::Index>(p)) = x;
    volume[static_cast<Eigen::Index>(p)] = listed[p].volume;
  }
  return points_at(std::move(position), std::move(volume));
}

/// Calls fill(grid) with the grid as what it is.
template <class Fill>
MaterialPoints on_cells(const Grid& grid, Fill&& fill) {
  if (const auto* triangles = dynamic_cast<const TriangleGrid*>(&grid)) return fill(*triangles);
  return fill(dynamic_cast<const QuadrilateralGrid&>(grid));
}

/// The points that a case asks for, in any order.
MaterialPoints points_of(const Case& problem, const std::vector<SplineCurve>& curves, const Basis& basis,
                         const Region* body) {
  const Grid& grid = basis.grid();
  using Listed = std::vector<Case::ListedPoint>;
  return std::visit(
      Overloaded{[&](const LatticeFill& f) {
                   return on_cells(grid, [&](const auto& cells) {
                     return f.volumes == VolumeRule::fitted ? fill_fitted(curves, cells, f.per_cell, basis.degree())
                                                            : fill_lattice(curves, cells, f);
                   });
                 },
                 [&](const BlockFill& f) {
                   if (problem.grid.mesh)
                     throw InvalidArgument("points per block need rectangles, and the grid is a mesh");
                   return fill_lattice(curves, rectangles(problem.grid), LatticeFill{f.per_block, f.volumes});
                 },
                 [&](const AcrossFill& f) { return fill_lattice(curves, f); },
                 [&](const VertexFill& f) {
                   if (problem.grid.mesh && !f.across)
                     throw InvalidArgument(
                         "vertices per cell need rectangles of one size, and the grid is a mesh; give points across "
                         "the body");
                   return fill_vertex(curves, problem.grid.cell_size, f);
                 },
                 [&](const PolarFill& f) { return fill_polar(curves, f); },
                 [&](const RandomFill& f) {
                   return on_cells(grid, [&](const auto& cells) { return fill_random(curves, cells, f); });
                 },
                 [&](const Listed& listed) { return listed_points(listed, grid, body); }},
      problem.material_points);
}

MaterialPoints fill(const Case& problem, const std::vector<SplineCurve>& curves, const Basis& basis) {
  const std::string file = problem.file.string();
  using Listed = std::vector<Case::ListedPoint>;
  if (curves.empty() && !std::holds_alternative<Listed>(problem.material_points))
    throw CaseError(file, "/material_points", "a fill needs an outline, and /boundaries is empty");
  try {
    const std::optional<Region> body = curves.empty() ? std::nullopt : std::optional<Region>(std::in_place, curves);
    MaterialPoints points = points_of(problem, curves, basis, body ? &*body : nullptr);
    if (points.size() == 0) throw InvalidArgument("no material point lies in the body; use more points per cell");
    const bool unmarked = std::holds_alternative<VertexFill>(problem.material_points) ||
                          std::holds_alternative<Listed>(problem.material_points);
    if (unmarked && body) mark_outline(*body, on_outline * basis.grid().size(0), points);
    sort_by_cell(basis, points);
    return points;
  } catch (const InvalidArgument& error) {
    throw CaseError(file, "/material_points", error.what());
  }
}

}  // namespace

const char* left_by(const Vec2& place, const Grid& grid, const Region* body) {
  constexpr double beside_outline = 0.01;  // of a cell
  const std::optional<Index> cell = grid.locate(place, 0);
  const auto beside = [&] { return body->near_outline(place, beside_outline * grid.size(cell.value_or(0))); };
  if (body != nullptr && !body->contains(place) && !beside()) return "outline";
  return cell ? nullptr : "grid";
}

std::unique_ptr<const Basis> basis_of(const Case& problem) {
  try {
    return make_basis(problem.grid);
  } catch (const MeshError& error) {
    throw CaseError(problem.file.string(), "/grid", error.what());
  }
}

Body build_body(const Case& problem) {
  Body body;
  body.basis = basis_of(problem);
  body.curves = fit_all(problem);
  body.loops = close_outline(problem, body.curves, body.basis->grid());
  body.points = fill(problem, body.curves, *body.basis);
  return body;
}

}  // namespace shoreline
