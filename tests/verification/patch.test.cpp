// Patch test: a turned rectangle under rollers and uniform tractions, whose displacement is linear, anywhere in a grid.

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "../bases/meshes.hpp"
#include "../exact_points.hpp"
#include "shoreline/engine/defaults.hpp"
#include "shoreline/engine/linear_elastic.hpp"
#include "shoreline/engine/quasi_static.hpp"

using namespace shoreline;

namespace {

constexpr double youngs_modulus = 2e6;
constexpr double poissons_ratio = 0.3;

/// A grid and the basis on it.
struct Space {
  const char* name;
  Case::BasisType basis;
  int degree = 1;
  TrianglePattern pattern = TrianglePattern::diagonal;
  bool delaunay = false;  ///< a jittered mesh instead of the pattern

  [[nodiscard]] double band() const { return nitsche_band(basis); }
  [[nodiscard]] double ghost() const { return ghost_for_nitsche(basis); }
};

const std::vector<Space> spaces = {
    {.name = "bilinear", .basis = Case::BasisType::bilinear},
    {.name = "linear, diagonal", .basis = Case::BasisType::linear},
    {.name = "linear, four", .basis = Case::BasisType::linear, .pattern = TrianglePattern::four},
    {.name = "linear, Delaunay", .basis = Case::BasisType::linear, .delaunay = true},
    {.name = "Powell-Sabin, diagonal", .basis = Case::BasisType::powell_sabin, .degree = 2},
    {.name = "Powell-Sabin, four",
     .basis = Case::BasisType::powell_sabin,
     .degree = 2,
     .pattern = TrianglePattern::four},
    {.name = "Powell-Sabin, Delaunay", .basis = Case::BasisType::powell_sabin, .degree = 2, .delaunay = true},
    {.name = "B-spline 1", .basis = Case::BasisType::bspline, .degree = 1},
    {.name = "B-spline 2", .basis = Case::BasisType::bspline, .degree = 2},
    {.name = "B-spline 3", .basis = Case::BasisType::bspline, .degree = 3}};

/// Where a body lies in its grid.
struct Draw {
  double angle;
  Vec2 centre;
  Vec2 spacing;
};

Draw random_draw(test::Random& random) {
  const double h = random.uniform(0.06, 0.16);
  return {.angle = random.uniform(0.0, 2.0 * std::numbers::pi),
          .centre = random.vector(0.0, h),
          .spacing = Vec2(h, h * random.uniform(0.7, 1.3))};
}

/// A grid on [-0.9, 1.1]², or a little more.
Case::Grid grid_of(const Space& space, const Vec2& spacing, test::Random& random) {
  Case::Grid grid{.lower = Vec2(-0.9, -0.9),
                  .upper = Vec2(1.1, 1.1),
                  .cell_size = spacing,
                  .basis = space.basis,
                  .degree = space.degree,
                  .pattern = space.pattern};
  if (space.delaunay) {
    const Vec2 count = (grid.upper - grid.lower).cwiseQuotient(spacing).array().ceil();
    std::vector<Vec2> points =
        test::jittered_points(static_cast<Index>(count.x()), static_cast<Index>(count.y()), random);
    for (Vec2& x : points) x = grid.lower + x.cwiseProduct(spacing);
    grid.mesh = std::make_shared<const TriangleMesh>(delaunay(points));
  }
  return grid;
}

/// The rectangle 1 x 0.8 about the origin, turned and moved.
std::vector<Vec2> corners_of(const Draw& draw) {
  const Eigen::Rotation2Dd turn(draw.angle);
  std::vector<Vec2> corners;
  for (const Vec2& x : {Vec2(-0.5, -0.4), Vec2(0.5, -0.4), Vec2(0.5, 0.4), Vec2(-0.5, 0.4)})
    corners.emplace_back(draw.centre + turn * x);
  return corners;
}

/// One point at the centroid of each sub-cell serves where gradients are linear in a cell; else it takes more.
Case::MaterialPoints points_of(const Case::Grid& grid, const std::vector<Vec2>& corners) {
  if (grid.basis != Case::BasisType::bspline || grid.degree == 1) return LatticeFill{{2, 2}, VolumeRule::clipped};
  const Vec2 count = (grid.upper - grid.lower).cwiseQuotient(grid.cell_size).array().ceil();
  const QuadrilateralGrid cells(grid.lower, grid.cell_size,
                                {static_cast<Index>(count.x()), static_cast<Index>(count.y())});
  return test::exact_points(cells, corners, grid.degree + 1);  // products of ∂x φ with 1 have degree 2p − 1
}

/// Rollers below and on the left, tractions (sx, 0) and (0, sy) on the right and above, in the body's own axes.
Case patch(const Case::Grid& grid, const Draw& draw, const Essential& roller, double ghost, Plane plane) {
  const Eigen::Rotation2Dd turn(draw.angle);
  const auto pull = [&](const Vec2& traction) {
    const Vec2 t = turn * traction;
    return Case::Traction{std::array{Quantity(t.x()), Quantity(t.y())}};
  };
  const std::vector<Vec2> x = corners_of(draw);
  const auto side = [](std::string name, Vec2 from, Vec2 to, Case::Condition condition) {
    return Case::Boundary{{.name = std::move(name), .points = {from, to}, .corners = {}}, std::move(condition)};
  };
  Case problem;
  problem.plane = plane;
  problem.material = {.youngs_modulus = youngs_modulus, .poissons_ratio = poissons_ratio, .density = {}};
  problem.grid = grid;
  problem.boundaries = {side("bottom", x[0], x[1], roller), side("right", x[1], x[2], pull({3e3, 0.0})),
                        side("top", x[2], x[3], pull({0.0, -5e3})), side("left", x[3], x[0], roller)};
  problem.material_points = points_of(grid, x);
  problem.ghost = ghost;
  return problem;
}

ExactSolution linear_field(const Draw& draw, Plane plane) {
  const Mat2 turn = Eigen::Rotation2Dd(draw.angle).toRotationMatrix();
  const Vec2 stress(3e3, -5e3);
  const LinearElastic law(youngs_modulus, poissons_ratio, plane);
  const Vec2 strain = law.tangent(Stress::Zero()).topLeftCorner<2, 2>().inverse() * stress;
  const Mat2 gradient = turn * strain.asDiagonal() * turn.transpose();
  const Mat2 global = turn * stress.asDiagonal() * turn.transpose();
  const Vec2 held = draw.centre + turn * Vec2(-0.5, -0.4);
  return {.displacement = [=](const Vec2& x, double t) -> Vec2 { return t * gradient * (x - held); },
          .stress = [=](const Vec2&, double t) -> Vec3 { return t * Vec3(global(0, 0), global(1, 1), global(0, 1)); }};
}

struct Errors {
  double displacement;
  double stress;
  bool definite;
};

Errors solve(const Case& problem, const Draw& draw) {
  Scene scene = build_scene(problem);
  RunRecord record;
  run_load_steps(scene, {}, record);
  const ErrorNorms norms = error_norms(scene.points, linear_field(draw, problem.plane), 1.0);
  return {norms.displacement_l2_relative.value(), norms.stress_l2_relative.value(), record.warnings.empty()};
}

Essential roller(EssentialMethod method, double band) { return {.normal_only = true, .method = method, .band = band}; }

/// Both in turn.
Plane plane_of(int draw) { return draw % 2 == 0 ? Plane::strain : Plane::stress; }

/// The bilinear basis is cheap; the others see fewer draws.
int draws_of(const Space& space) { return space.basis == Case::BasisType::bilinear ? 100 : 12; }

}  // namespace

TEST_CASE("patch test: Nitsche with ghost penalty is exact and positive definite wherever the grid lies",
          "[verification]") {
  for (const Space& space : spaces) {
    test::Random random(20190401);
    for (int k = 0; k < draws_of(space); ++k) {
      const Draw draw = random_draw(random);
      const Case::Grid grid = grid_of(space, draw.spacing, random);
      const Errors errors =
          solve(patch(grid, draw, roller(EssentialMethod::nitsche, space.band()), space.ghost(), plane_of(k)), draw);
      CAPTURE(space.name, k, draw.angle, draw.centre.transpose(), draw.spacing.transpose());
      CHECK(errors.displacement <= 1e-10);
      CHECK(errors.stress <= 1e-10);
      CHECK(errors.definite);
    }
  }
}

TEST_CASE("patch test: weights fitted to the outline serve every basis", "[verification][fitted]") {
  for (const Space& space : spaces) {
    test::Random random(20190404);
    for (int k = 0; k < draws_of(space) / 2; ++k) {
      const Draw draw = random_draw(random);
      const Case::Grid grid = grid_of(space, draw.spacing, random);
      Case problem = patch(grid, draw, roller(EssentialMethod::nitsche, space.band()), space.ghost(), plane_of(k));
      problem.material_points = LatticeFill{{space.degree + 1, space.degree + 1}, VolumeRule::fitted};
      problem.fitted = true;
      const Errors errors = solve(problem, draw);
      CAPTURE(space.name, k, draw.angle, draw.centre.transpose(), draw.spacing.transpose());
      CHECK(errors.displacement <= 1e-10);
      CHECK(errors.stress <= 1e-10);
      CHECK(errors.definite);
    }
  }
}

TEST_CASE("patch test: the implicit boundary errs by no more than its band, and in proportion to it",
          "[verification]") {
  for (const Space& space : spaces) {
    test::Random random(20190402);
    double mean_slope = 0.0;
    for (int k = 0; k < draws_of(space); ++k) {
      const Draw draw = random_draw(random);
      const Case::Grid grid = grid_of(space, draw.spacing, random);
      const auto errors = [&](double band) {
        const Essential held = roller(EssentialMethod::implicit_boundary, band);
        return solve(patch(grid, draw, held, space.ghost(), plane_of(k)), draw);
      };
      const Errors wide = errors(1e-3);
      const Errors narrow = errors(1e-4);
      CAPTURE(space.name, k, draw.angle, draw.centre.transpose(), draw.spacing.transpose(), wide.displacement,
              wide.stress);
      if (space.delaunay) {  // bands follow the sizes of cells, and no field of the basis slips in proportion to them
        CHECK(std::max(wide.displacement / 0.3, wide.stress) <= 1e-3);
        CHECK(std::max(narrow.displacement / 0.3, narrow.stress) <= 1e-4);
        continue;
      }
      CHECK(wide.displacement <= 0.1 * 1e-3);
      CHECK(wide.stress <= 0.34 * 1e-3);
      const double displacement_slope = std::log10(wide.displacement / narrow.displacement);
      const double stress_slope = std::log10(wide.stress / narrow.stress);
      CHECK(std::abs(displacement_slope - 1.0) <= 0.1);
      CHECK(std::abs(stress_slope - 1.0) <= 0.15);  // slivers take up to 1.13; the mean over all draws is nearer
      mean_slope += stress_slope / draws_of(space);
    }
    CAPTURE(space.name);
    if (!space.delaunay) CHECK(std::abs(mean_slope - 1.0) <= 0.05);
  }
}

TEST_CASE("patch test: rollers by elimination of the grid's own border are exact on every basis", "[verification]") {
  for (const Space& space : spaces) {
    test::Random random(20190403);
    for (int k = 0; k < 4; ++k) {
      const Vec2 spacing(1.0 / random.whole(4, 12), 0.8 / random.whole(4, 12));
      const Draw draw{.angle = 0.0, .centre = Vec2(-0.4, -0.5), .spacing = spacing};  // corner at (-0.9, -0.9)
      const Case::Grid grid = grid_of(space, spacing, random);
      const Errors errors =
          solve(patch(grid, draw, roller(EssentialMethod::grid, 0.0), space.ghost(), plane_of(k)), draw);
      CAPTURE(space.name, k, spacing.transpose());
      CHECK(errors.displacement <= 1e-10);
      CHECK(errors.stress <= 1e-10);
      CHECK(errors.definite);
    }
  }
}
