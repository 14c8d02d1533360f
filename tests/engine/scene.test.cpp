#include "shoreline/engine/scene.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "../every_grid.hpp"
#include "../scenes.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::vector<std::string> effects(const Case& problem) {
  std::vector<std::string> names;
  for (const auto& effect : build_scene(problem).contributions) names.push_back(effect->name());
  return names;
}

/// Key and message of the case error, or "accepted".
std::string refusal(const Case& problem) {
  try {
    static_cast<void>(build_scene(problem));
    return "accepted";
  } catch (const CaseError& error) {
    return error.what();
  }
}

std::vector<Constraint> constraints(const Scene& scene) {
  const test::Step step(scene);
  return grid_constraints(*scene.basis, scene.boundary, step.state.edges, step.prescribed);
}

/// Position and volume of every point of a disc, in an order that does not depend on the grid.
std::vector<std::array<double, 3>> disc_points(const Case::Grid& grid, const Case::MaterialPoints& fill) {
  Case problem = test::disc_case(1.0, 0.25, Case::Free{});
  problem.grid = grid;
  problem.material_points = fill;
  const MaterialPoints points = build_scene(problem).points;
  std::vector<std::array<double, 3>> all;
  for (Index p = 0; p < points.size(); ++p)
    all.push_back({points.position(1, p), points.position(0, p), points.volume[p]});
  std::ranges::sort(all);
  return all;
}

}  // namespace

TEST_CASE("a scene holds the effects that its case names and no other", "[engine][scene]") {
  Case problem = test::compression_case({.cells = 4});
  CHECK(effects(problem) == std::vector<std::string>{"linear_elastic", "implicit_boundary:bottom",
                                                     "implicit_boundary:right", "traction:top",
                                                     "implicit_boundary:left"});
  problem.boundaries[0].condition = Essential{.normal_only = true, .method = EssentialMethod::grid};
  problem.boundaries[1].condition = Case::Free{};
  problem.boundaries[2].condition = Case::Pressure{Quantity(1.0)};
  std::get<Essential>(problem.boundaries[3].condition).method = EssentialMethod::nitsche;
  problem.ghost = 1e-3;
  problem.gravity = Vec2(0.0, -9.81);
  problem.material.density = 2e3;
  CHECK(effects(problem) ==
        std::vector<std::string>{"linear_elastic", "body_force", "pressure:top", "nitsche:left", "ghost_penalty"});
}

TEST_CASE("a scene is the case's body: its points, loop and material", "[engine][scene]") {
  const Scene scene =
      test::compression_square({.angle = 0.3, .cells = 5, .per_cell = 2, .steps = 7, .loading = Loading::incremental});
  CHECK_THAT(scene.points.volume.sum(), WithinRel(0.01, 1e-12));
  CHECK(scene.loops == std::vector<std::vector<int>>{{0, 1, 2, 3}});
  CHECK(scene.load_steps == 7);
  CHECK(scene.loading == Loading::incremental);
  CHECK(scene.material->stiffness() == 1e6);
  Index cell = 0;
  for (Index p = 0; p < scene.points.size(); ++p) {  // sorted by cell
    const Index here = scene.basis->grid().locate(scene.points.position.col(p), 0).value();
    CHECK(here >= cell);
    cell = here;
  }
}

TEST_CASE("the upper corner moves out to whole cells, and no farther", "[engine][scene]") {
  Case problem = test::compression_case({.cells = 4});
  problem.grid = {.lower = Vec2(-0.1, -0.1), .upper = Vec2(0.1, 0.11), .cell_size = Vec2(0.02, 0.05)};
  const Box box = build_scene(problem).basis->grid().bounds();
  CHECK_THAT((box.upper - Vec2(0.1, 0.15)).norm(), WithinAbs(0.0, 1e-12));
}

TEST_CASE("an outline that bounds no body is refused at the key of its piece", "[engine][scene]") {
  const Case square = test::compression_case({.cells = 4});
  Case open = square;
  open.boundaries[2].piece.points.back() += Vec2(0.0, 0.01);
  CHECK_THAT(refusal(open), Contains("square.json: /boundaries/2: "));

  Case crossing = square;
  crossing.boundaries[1].piece.points.insert(crossing.boundaries[1].piece.points.begin() + 1, Vec2(-0.08, 0.01));
  CHECK_THAT(refusal(crossing), Contains("square.json: /boundaries/1: ") || Contains("square.json: /boundaries/3: "));

  Case equal = square;
  equal.boundaries[3].piece.points = {Vec2(-0.05, 0.05), Vec2(-0.05, 0.05), Vec2(-0.05, -0.05)};
  CHECK_THAT(refusal(equal), Contains("square.json: /boundaries/3: "));

  Case clockwise = square;
  std::ranges::reverse(clockwise.boundaries);
  for (Case::Boundary& b : clockwise.boundaries) std::ranges::reverse(b.piece.points);
  CHECK_THAT(refusal(clockwise), Contains("square.json: /boundaries/"));
}

TEST_CASE("a body that reaches outside its grid is refused at its piece, with the remedy", "[engine][scene]") {
  Case problem = test::compression_case({.cells = 4});
  problem.grid.upper.y() = 0.04;
  problem.grid.cell_size = Vec2(0.01, 0.01);
  CHECK_THAT(refusal(problem), Contains("/boundaries/1") && Contains("right") && Contains("enlarge grid"));
}

TEST_CASE("a fill that finds no points, or no lattice, is refused at material_points", "[engine][scene]") {
  Case problem = test::compression_case({.cells = 4});
  problem.material_points = VertexFill{{3, 7}};
  CHECK(refusal(problem) == "accepted");
  problem.grid.cell_size = Vec2(0.03, 0.03);
  problem.material_points = VertexFill{{1, 1}};
  CHECK_THAT(refusal(problem), Contains("square.json: /material_points: ") && Contains("whole numbers"));
  problem.boundaries.clear();
  CHECK_THAT(refusal(problem), Contains("/material_points") && Contains("needs an outline"));
  problem.material_points = std::vector<Case::ListedPoint>{{Vec2::Zero(), 1.0}};
  CHECK(refusal(problem) == "accepted");
}

TEST_CASE("points per block are those per cell of the rectangles, however triangles cut these", "[engine][scene]") {
  const Case::Grid rectangles = test::disc_case(1.0, 0.25, Case::Free{}).grid;
  for (const VolumeRule volumes : {VolumeRule::clipped, VolumeRule::lattice, VolumeRule::equal}) {
    const auto expected = disc_points(rectangles, LatticeFill{{2, 3}, volumes});
    for (auto basis : {Case::BasisType::bilinear, Case::BasisType::linear, Case::BasisType::powell_sabin})
      for (auto pattern : {TrianglePattern::diagonal, TrianglePattern::four}) {
        Case::Grid grid = rectangles;
        grid.basis = basis;
        grid.pattern = pattern;
        CHECK(disc_points(grid, BlockFill{{2, 3}, volumes}) == expected);
      }
  }
  Case::Grid mesh = rectangles;
  mesh.basis = Case::BasisType::linear;
  mesh.mesh = test::jittered_square(mesh.lower, 3.5, 9);
  Case problem = test::disc_case(1.0, 0.25, Case::Free{});
  problem.grid = mesh;
  problem.material_points = BlockFill{{2, 2}};
  CHECK_THAT(refusal(problem), Contains("disc.json: /material_points: ") && Contains("rectangles"));
}

TEST_CASE("points across the body are the same on every grid", "[engine][scene]") {
  const Case problem = test::disc_case(1.0, 0.25, Case::Free{});
  const AcrossFill fill{{9, 8}};
  const auto expected = disc_points(problem.grid, fill);
  CHECK(expected.size() > 9 * 8 * 3 / 4);
  CHECK(expected.size() <= 9 * 8);
  for (const auto& [name, grid] : test::every_grid(problem.grid.lower, 3.5, 9)) {
    CAPTURE(name);
    CHECK(disc_points(grid, fill) == expected);
  }
}

TEST_CASE("random points keep their cells and sum to the body on every grid", "[engine][scene]") {
  Case problem = test::disc_case(1.0, 0.25, Case::Free{});
  const double area = Region(std::vector{fit_spline(problem.boundaries[0].piece)}).area();
  problem.material_points = RandomFill{.per_element = 3};
  for (const auto& [name, grid] : test::every_grid(problem.grid.lower, 3.5, 9)) {
    CAPTURE(name);
    problem.grid = grid;
    const Scene scene = build_scene(problem);
    CHECK(scene.points.on_outline.empty());
    CHECK_THAT(scene.points.volume.sum(), WithinRel(area, 1e-12));
  }
}

TEST_CASE("a listed point lies in the outline, or as little beside it as a spline lies beside an arc",
          "[engine][scene]") {
  Case problem = test::compression_case({.side = 0.1, .cells = 4});
  const double h = 0.1 / 4;
  const auto listed = [&](double beyond) {
    problem.material_points = std::vector<Case::ListedPoint>{{Vec2::Zero(), 1.0}, {Vec2(0.05 + beyond, 0.01), 1.0}};
    return refusal(problem);
  };
  CHECK(listed(-0.01 * h) == "accepted");
  CHECK(listed(0.009 * h) == "accepted");
  CHECK_THAT(listed(0.011 * h), Contains("point 1 at (0.050275, 0.01)") && Contains("outside the outline"));
  CHECK_THAT(listed(1.0), Contains("point 1 at (1.05, 0.01)") && Contains("outside the outline"));
}

TEST_CASE("loads know original and current place and time, plain numbers ramp", "[engine][scene]") {
  Case problem = test::compression_case({.cells = 4});
  problem.boundaries[2].condition =
      Case::Traction{std::array{Quantity(8.0), Quantity(Expression("X + 100*x + 10000*t"))}};
  const Scene scene = build_scene(problem);
  const auto& traction = std::get<Traction>(scene.boundary[2].condition);
  BoundaryPoint p{};
  p.span = 0;
  p.u = 0.25;
  p.x = Vec2(3.0, 0.0);  // where the piece has moved; it ran from x = 0.05 to −0.05
  const Vec2 value = traction.value(p, 0.5);
  CHECK(value.x() == 4.0);
  CHECK_THAT(value.y(), WithinAbs(0.025 + 300.0 + 5000.0, 1e-9));
}

TEST_CASE("weight is density times gravity, ramps, and joins the body force", "[engine][scene]") {
  Case problem = test::compression_case({.cells = 4});
  problem.gravity = Vec2(0.0, -10.0);
  problem.material.density = 2e3;
  problem.body_force = {Quantity(3e3), Quantity(0.0)};
  const Scene scene = build_scene(problem);
  Contribution& weight = *scene.contributions[1];
  Resultants resultants;
  weight.accept(test::Step(scene, 0.5).state, {});
  weight.report(resultants);
  const Vec2 half = 0.5 * 0.01 * Vec2(3e3, -2e4);
  CHECK_THAT((resultants.loads.at("body_force").head<2>() - half).norm(), WithinAbs(0.0, 1e-9));
}

TEST_CASE("conventional rollers hold the nodes of their line in its normal, once each", "[engine][scene]") {
  const Scene scene = test::compression_square({.cells = 4, .method = EssentialMethod::grid});
  const std::vector<Constraint> held = constraints(scene);
  CHECK(held.size() == 15);  // five nodes at the bottom and at each side
  for (const Constraint& c : held) {
    const Vec2 node = scene.basis->control_point(c.function);
    CHECK(c.component == (c.piece == 0 ? 1 : 0));
    if (c.piece == 0) CHECK_THAT(node.y(), WithinAbs(-0.05, 1e-12));
    if (c.piece != 0) CHECK_THAT(std::abs(node.x()), WithinAbs(0.05, 1e-12));
  }
}

TEST_CASE("a fixed conventional piece holds both components", "[engine][scene]") {
  Case problem = test::compression_case({.cells = 4, .method = EssentialMethod::grid});
  std::get<Essential>(problem.boundaries[0].condition).normal_only = false;
  CHECK(constraints(build_scene(problem)).size() == 5 + 5 + 4 + 4);  // the corners' x is held once
}

TEST_CASE("a conventional piece off the grid lines is refused with its place", "[engine][scene]") {
  const auto held = [](double angle, const Vec2& shift) {
    return constraints(
        test::compression_square({.angle = angle, .shift = shift, .cells = 4, .method = EssentialMethod::grid}));
  };
  CHECK_THROWS_WITH(held(0.0, Vec2(0.0, 0.001)), Contains("\"bottom\"") && Contains("leaves the grid lines"));
  CHECK_THROWS_WITH(held(0.1, Vec2::Zero()), Contains("\"bottom\"") && Contains("nitsche"));
}
