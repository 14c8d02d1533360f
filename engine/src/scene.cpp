#include "shoreline/engine/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "conditions_on_piece.hpp"
#include "shoreline/bases/bilinear.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/engine/effects.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/fill.hpp"
#include "shoreline/engine/linear_elastic.hpp"

namespace shoreline {
namespace {

constexpr double on_outline = 1e-9;      ///< of a cell: a point this near to the outline lies on it
constexpr double beside_outline = 0.01;  ///< of a cell: as far outside a listed point may lie, as a spline is no arc

CaseError piece_error(const Case& problem, int piece, const std::string& message) {
  return {problem.file.string(), fmt::format("/boundaries/{}", piece), message};
}

QuadrilateralGrid make_grid(const Case::Grid& grid) {
  constexpr double whole = 1e-9;  // of a cell: an extent this little over whole cells is whole
  const Vec2 count = (grid.upper - grid.lower).cwiseQuotient(grid.cell_size);
  const auto cells = [](double n) { return std::max(static_cast<Index>(std::ceil(n - whole)), Index{1}); };
  return {grid.lower, grid.cell_size, {cells(count.x()), cells(count.y())}};
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
        throw OutlineError(static_cast<int>(k), std::string(error.what()) + "; enlarge grid.lower and grid.upper");
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
    const char* missed = nullptr;
    if (!grid.locate(x, 0)) missed = "grid";
    if (body != nullptr && !body->contains(x) && !body->near_outline(x, beside_outline * grid.size(0)))
      missed = "outline";
    if (missed != nullptr)
      throw InvalidArgument(fmt::format("point {} at ({:.6g}, {:.6g}) lies outside the {}", p, x.x(), x.y(), missed));
    position.col(static_cast<Eigen::Index>(p)) = x;
    volume[static_cast<Eigen::Index>(p)] = listed[p].volume;
  }
  return points_at(std::move(position), std::move(volume));
}

MaterialPoints fill(const Case& problem, const std::vector<SplineCurve>& curves, const BilinearBasis& basis) {
  const QuadrilateralGrid& grid = basis.grid();
  const std::string file = problem.file.string();
  using Listed = std::vector<Case::ListedPoint>;
  if (curves.empty() && !std::holds_alternative<Listed>(problem.material_points))
    throw CaseError(file, "/material_points", "a fill needs an outline, and /boundaries is empty");
  try {
    const std::optional<Region> body = curves.empty() ? std::nullopt : std::optional<Region>(std::in_place, curves);
    MaterialPoints points = std::visit(
        Overloaded{[&](const LatticeFill& f) { return fill_lattice(curves, grid, f); },
                   [&](const VertexFill& f) { return fill_vertex(curves, grid.spacing(), f); },
                   [&](const PolarFill& f) { return fill_polar(curves, f); },
                   [&](const Listed& listed) { return listed_points(listed, grid, body ? &*body : nullptr); }},
        problem.material_points);
    if (points.size() == 0) throw InvalidArgument("no material point lies in the body; use more points per cell");
    const bool unmarked = std::holds_alternative<VertexFill>(problem.material_points) ||
                          std::holds_alternative<Listed>(problem.material_points);
    if (unmarked && body) mark_outline(*body, on_outline * grid.size(0), points);
    sort_by_cell(basis, points);
    return points;
  } catch (const InvalidArgument& error) {
    throw CaseError(file, "/material_points", error.what());
  }
}

void add_boundary_effects(Scene& scene) {
  for (std::size_t k = 0; k < scene.boundary.size(); ++k) {
    const auto piece = static_cast<int>(k);
    const std::string& name = scene.boundary[k].piece.name;
    auto& effects = scene.contributions;
    std::visit(
        Overloaded{[](const Free&) {}, [&](const Traction& c) { effects.push_back(traction_on(piece, name, c)); },
                   [&](const Pressure& c) { effects.push_back(pressure_on(piece, name, c)); },
                   [&](const Essential& c) {
                     if (c.method != EssentialMethod::grid)
                       effects.push_back(essential_on(piece, name, c, scene.material));
                     if (scene.exact)
                       effects.push_back(boundary_error(piece, name, c.normal_only,
                                                        exact_displacement(scene.boundary[k].original, *scene.exact)));
                   }},
        scene.boundary[k].condition);
  }
}

/// Body force and weight of a case [N/m³]; plain numbers, and so gravity, ramp with the load factor.
std::function<Vec2(const PlaceTime&)> force_per_volume(const Case& problem, LoadFactor factor) {
  const Vec2 weight = problem.gravity.value_or(Vec2::Zero()) * problem.material.density.value_or(0.0);
  return [value = problem.body_force, weight, ramp = std::move(factor)](PlaceTime at) -> Vec2 {
    at.factor = ramp(at.t);
    const Vec2 force = weight * at.factor;
    return value ? Vec2(force + Vec2((*value)[0](at), (*value)[1](at))) : force;
  };
}

LoadFactor load_factor(const Case& problem) {
  if (!problem.load) return [](double t) { return t; };
  return [load = *problem.load](double t) { return load({.t = t}); };
}

/// Refuses pieces with method grid that do not lie on grid lines, before anything is computed.
void check_grid_pieces(const Case& problem, const Scene& scene, const Basis& basis) {
  const QuadratureRule rule = gauss(2);
  std::vector<Edge> edges;
  for (const BoundaryPiece& b : scene.boundary) {
    Edge edge{.curve = fit_spline(b.piece), .points_per_segment = static_cast<int>(rule.point.size())};
    edge.segments = trace(edge.curve, basis.grid(), b.piece.name);
    edge.points = boundary_points(edge.curve, edge.segments, rule);
    edges.push_back(std::move(edge));
  }
  try {
    static_cast<void>(grid_constraints(basis, scene.boundary, edges, Eigen::Matrix2Xd(2, 0)));
  } catch (const InvalidArgument& error) {
    throw CaseError(problem.file.string(), "/boundaries", error.what());
  }
}

ExactSolution by_expressions(const Case::ExactExpressions& exact) {
  return {.displacement = [u = exact.displacement](const Vec2& origin, double t) -> Vec2 {
            const PlaceTime at{.x = origin, .origin = origin, .t = t};
            return {u[0](at), u[1](at)};
          },
          .stress = [s = exact.stress](const Vec2& origin, double t) -> Vec3 {
            const PlaceTime at{.x = origin, .origin = origin, .t = t};
            return {s[0](at), s[1](at), s[2](at)};
          }};
}

ExactSolution to_solution(const Case& problem, const LoadFactor& factor) {
  const ElasticConstants material{problem.material.youngs_modulus, problem.material.poissons_ratio, problem.plane};
  return std::visit(Overloaded{[](const Case::ExactExpressions& exact) { return by_expressions(exact); },
                               [&](const auto& closed_form) { return exact_solution(closed_form, material, factor); }},
                    *problem.exact);
}

}  // namespace

Scene build_scene(const Case& problem) {
  Scene scene;
  auto basis = std::make_unique<const BilinearBasis>(make_grid(problem.grid));
  const std::vector<SplineCurve> curves = fit_all(problem);
  scene.loops = close_outline(problem, curves, basis->grid());
  scene.points = fill(problem, curves, *basis);
  scene.material =
      std::make_shared<LinearElastic>(problem.material.youngs_modulus, problem.material.poissons_ratio, problem.plane);
  scene.loading = problem.loading;
  scene.load_steps = problem.load_steps;
  scene.respacing = problem.respacing;
  const LoadFactor factor = load_factor(problem);
  if (problem.exact) scene.exact = to_solution(problem, factor);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const auto original = std::make_shared<SplineCurve>(curves[k]);
    const auto& [piece, condition] = problem.boundaries[k];
    scene.boundary.push_back({piece, to_condition(condition, {original, factor, scene.exact}), original});
  }
  check_grid_pieces(problem, scene, *basis);

  scene.contributions.push_back(stiffness_of(scene.material));
  if (problem.body_force || problem.gravity)
    scene.contributions.push_back(body_force(force_per_volume(problem, factor)));
  add_boundary_effects(scene);
  if (problem.ghost > 0.0) scene.contributions.push_back(ghost_penalty(problem.ghost, scene.material));
  scene.basis = std::move(basis);
  scene.probes = place_probes(problem, scene);
  return scene;
}

}  // namespace shoreline
