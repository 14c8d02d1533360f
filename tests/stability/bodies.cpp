#include "bodies.hpp"

#include <Eigen/Geometry>
#include <numbers>

#include "../scenes.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "shoreline/engine/case_reader.hpp"

namespace shoreline::test {
namespace {

Piece named(const char* name, Piece piece) {
  piece.name = name;
  return piece;
}

/// Cells around a body, with two to spare on each side and a third on the left and below, for a grid that slides.
Case::Grid grid_around(const std::vector<Case::Boundary>& boundaries, double h) {
  std::vector<SplineCurve> curves;
  for (const Case::Boundary& b : boundaries) curves.push_back(fit_spline(b.piece));
  const Box body = Region(curves).bounds();
  return {.lower = body.lower - Vec2::Constant(h),
          .upper = body.upper + Vec2::Constant(2.0 * h),
          .cell_size = Vec2::Constant(h)};
}

/// The square's exact solution as formulas: uniaxial compression without motion across, from its bottom on.
Case::ExactExpressions uniform_compression(const CompressionSquare& o) {
  const double nu = o.poissons_ratio;
  const double strain = -o.load * (1.0 + nu) * (1.0 - 2.0 * nu) / (o.youngs_modulus * (1.0 - nu));
  const double across = -o.load * nu / (1.0 - nu);
  const double c = std::cos(o.angle);
  const double s = std::sin(o.angle);
  const std::map<std::string, double> numbers{{"e", strain},
                                              {"ux", -s},
                                              {"uy", c},
                                              {"half", 0.5 * o.side},
                                              {"sxx", c * c * across - s * s * o.load},
                                              {"syy", s * s * across - c * c * o.load},
                                              {"sxy", c * s * (across + o.load)}};
  const auto formula = [&](const char* text) { return Expression(text, numbers); };
  return {{formula("e*(ux*X + uy*Y + half)*ux"), formula("e*(ux*X + uy*Y + half)*uy")},
          {formula("sxx"), formula("syy"), formula("sxy")}};
}

}  // namespace

Case turned_compression() {
  const CompressionSquare square{.angle = 33.0 * std::numbers::pi / 180.0};
  Case problem = compression_case(square);
  problem.exact = uniform_compression(square);
  problem.grid = grid_around(problem.boundaries, square.side / square.cells);
  return problem;
}

Case plate_with_hole(const std::string& loaded_by) {
  Case problem = read_case(std::string(SHORELINE_EXAMPLES) + "/plate_with_hole/" + loaded_by + ".json",
                           {"grid.cell_size=0.125", "output.pictures=false"});
  problem.grid = grid_around(problem.boundaries, 0.125);
  return problem;
}

Case ring_sector() {
  constexpr double from = 20.0;
  constexpr double to = 110.0;
  const auto at = [](double radius, double degrees) -> Vec2 {
    return radius * (Eigen::Rotation2Dd(degrees * std::numbers::pi / 180.0) * Vec2::UnitX());
  };
  const Essential roller{.normal_only = true};
  Case problem;
  problem.file = "ring_sector.json";
  problem.material = {.youngs_modulus = 1e6, .poissons_ratio = 0.25, .density = {}};
  problem.exact = ThickCylinder{1.0, 5.0, 1e4};
  problem.boundaries = {{named("right", line(at(1.0, from), at(5.0, from))), roller},
                        {named("outer", arc(Vec2::Zero(), 5.0, from, to, 33)), Case::Free{}},
                        {named("left", line(at(5.0, to), at(1.0, to))), roller},
                        {named("inner", arc(Vec2::Zero(), 1.0, to, from, 33)), Case::Pressure{Quantity(1e4)}}};
  problem.grid = grid_around(problem.boundaries, 0.25);
  return problem;
}

Case bending(std::vector<Piece> outline, double h) {
  constexpr double modulus = 1e6;
  constexpr double ratio = 0.3;
  const std::map<std::string, double> numbers{
      {"c", 1e3}, {"m", modulus / (1.0 - ratio * ratio)}, {"n", ratio / (1.0 - ratio)}};
  const auto formula = [&](const char* text) { return Expression(text, numbers); };
  Case problem;
  problem.file = "bending.json";
  problem.material = {.youngs_modulus = modulus, .poissons_ratio = ratio, .density = {}};
  problem.exact = Case::ExactExpressions{{formula("c*X*Y/m"), formula("-c*(X*X + n*Y*Y)/(2*m)")},
                                         {formula("c*Y"), formula("0"), formula("0")}};
  for (Piece& piece : outline) {
    piece.name = "piece" + std::to_string(problem.boundaries.size());
    const bool held = problem.boundaries.empty();
    problem.boundaries.push_back(
        {std::move(piece), held ? Case::Condition(Case::Displacement{Case::FromExact{}, Essential{}})
                                : Case::Condition(Case::Traction{Case::FromExact{}})});
  }
  problem.grid = grid_around(problem.boundaries, h);
  return problem;
}

std::vector<Piece> sides(const std::vector<Vec2>& corners) {
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < corners.size(); ++k)
    pieces.push_back(line(corners[k], corners[(k + 1) % corners.size()]));
  return pieces;
}

std::vector<Vec2> rectangle(double width, double height, double angle) {
  const Eigen::Rotation2Dd turn(angle);
  std::vector<Vec2> corners;
  for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
    corners.emplace_back(turn * Vec2(x * width, y * height));
  return corners;
}

}  // namespace shoreline::test
