// What conventional essential conditions hold on lines of any grid, and what they leave free.
#include <catch2/catch.hpp>
#include <map>

#include "../bodies_on_lines.hpp"
#include "../scenes.hpp"
#include "constrained.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using test::constrained;
using test::count;
using test::rank;

namespace {

const Essential fixed{.normal_only = false, .method = EssentialMethod::grid};
const Essential roller{.normal_only = true, .method = EssentialMethod::grid};

std::vector<Constraint> constraints(const Scene& scene, const Eigen::Matrix2Xd& prescribed = Eigen::Matrix2Xd(2, 0)) {
  const test::Step step(scene);
  return grid_constraints(*scene.basis, scene.boundary, step.state.edges, prescribed);
}

/// From coefficients, (2 · functions), to the held components of the displacement at points of the held pieces.
Eigen::MatrixXd trace(const Scene& scene, std::size_t piece) {
  const auto* condition = std::get_if<Essential>(&scene.boundary[piece].condition);
  if (condition == nullptr) return Eigen::MatrixXd(0, 2 * scene.basis->functions());
  const test::Step step(scene);
  const auto& points = step.edges[piece].points;
  const Eigen::Index held = condition->normal_only ? 1 : 2;
  Eigen::MatrixXd map =
      Eigen::MatrixXd::Zero(held * static_cast<Eigen::Index>(points.size()), 2 * scene.basis->functions());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Support support = scene.basis->support(points[k].cell, points[k].x);
    const Eigen::MatrixXd part =
        condition->normal_only ? Eigen::MatrixXd(points[k].normal.transpose()) : Eigen::MatrixXd::Identity(2, 2);
    for (Eigen::Index a = 0; a < support.value.size(); ++a)
      map.block(held * static_cast<Eigen::Index>(k), 2 * support.function[a], held, 2) = support.value[a] * part;
  }
  return map;
}

Eigen::MatrixXd traces(const Scene& scene) {
  Eigen::MatrixXd all(0, 2 * scene.basis->functions());
  for (std::size_t k = 0; k < scene.boundary.size(); ++k) {
    const Eigen::MatrixXd one = trace(scene, k);
    Eigen::MatrixXd both(all.rows() + one.rows(), all.cols());
    both << all, one;
    all = std::move(both);
  }
  return all;
}

/// The loops of a mesh's border, one piece an edge, fixed.
std::vector<Case::Boundary> fixed_border(const TriangleMesh& mesh) {
  const auto neighbour = neighbours(mesh);
  std::map<Index, Index> next;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (neighbour[t][k] < 0) next[mesh.triangle[t][k]] = mesh.triangle[t][(k + 1) % 3];
  std::vector<Case::Boundary> pieces;
  while (!next.empty()) {
    Index v = next.begin()->first;
    while (next.contains(v)) {
      const Index w = next.extract(v).mapped();
      const auto at = [&](Index n) { return mesh.vertex[static_cast<std::size_t>(n)]; };
      pieces.push_back({{.name = std::to_string(pieces.size()), .points = {at(v), at(w)}}, fixed});
      v = w;
    }
  }
  return pieces;
}

/// Message of the error, or "accepted".
std::string refusal(const test::Setting& setting, const std::vector<Vec2>& corner) {
  Case problem = test::body_on_lines(setting);
  for (std::size_t k = 0; k < 4; ++k) problem.boundaries[k].piece.points = {corner[k], corner[(k + 1) % 4]};
  problem.boundaries[0].condition = fixed;
  problem.material_points =
      std::vector<Case::ListedPoint>{{0.25 * (corner[0] + corner[1] + corner[2] + corner[3]), 1.0}};
  try {
    static_cast<void>(build_scene(problem));
    return "accepted";
  } catch (const CaseError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("conventional conditions hold the displacement on their lines and nothing else",
          "[engine][grid_constraints]") {
  test::Random random(2);
  for (const test::Setting& setting : test::settings(random))
    for (const auto& [bottom, right] : {std::pair(fixed, fixed), std::pair(fixed, roller), std::pair(roller, roller)}) {
      CAPTURE(setting.name, bottom.normal_only, right.normal_only);
      Case problem = test::body_on_lines(setting);
      problem.boundaries[0].condition = bottom;
      problem.boundaries[1].condition = right;
      const Scene scene = build_scene(problem);
      const std::vector<Constraint> found = constraints(scene);
      const Eigen::MatrixXd held = traces(scene);
      CHECK(count(found) == rank(held));
      const Eigen::Matrix2Xd any = constrained(random.field(scene.basis->functions()), found);
      CHECK((held * any.reshaped()).norm() <= 1e-11);
    }
}

TEST_CASE("on a line that moves the trace is that of the prescribed coefficients", "[engine][grid_constraints]") {
  test::Random random(3);
  for (const test::Setting& setting : test::settings(random))
    for (const Essential& support : {fixed, roller}) {
      CAPTURE(setting.name, support.normal_only);
      Case problem = test::body_on_lines(setting);
      problem.boundaries[0].condition = Case::Displacement{std::array{Quantity(1.0), Quantity(1.0)}, support};
      problem.boundaries[2].condition = support;  // stays where it is
      const Scene scene = build_scene(problem);
      const Eigen::Matrix2Xd prescribed = random.field(scene.basis->functions());
      const Eigen::Matrix2Xd any = constrained(random.field(scene.basis->functions()), constraints(scene, prescribed));
      CHECK((trace(scene, 0) * (any - prescribed).reshaped()).norm() <= 1e-11);
      CHECK((trace(scene, 2) * any.reshaped()).norm() <= 1e-11);
    }
}

TEST_CASE("what is prescribed at one end of a long line does not depend on the other", "[engine][grid_constraints]") {
  test::Random random(7);
  constexpr double length = 60.0;
  for (const double margin : {0.0, 2.0})
    for (const Case::BasisType basis : {Case::BasisType::bspline, Case::BasisType::powell_sabin}) {
      CAPTURE(margin, basis);
      Case problem;
      problem.file = "strip.json";
      problem.material = {.youngs_modulus = 1e6, .poissons_ratio = 0.3, .density = {}};
      problem.grid = {.lower = Vec2(-margin, -margin),
                      .upper = Vec2(length + margin, 3.0 + margin),
                      .cell_size = Vec2::Ones(),
                      .basis = basis,
                      .degree = 3};
      const std::vector<Vec2> corner{{0.0, 0.0}, {length, 0.0}, {length, 3.0}, {0.0, 3.0}};
      for (std::size_t k = 0; k < 4; ++k)
        problem.boundaries.push_back({{.name = std::to_string(k), .points = {corner[k], corner[(k + 1) % 4]}},
                                      Case::Displacement{std::array{Quantity(1.0), Quantity(1.0)}, fixed}});
      problem.material_points = LatticeFill{{2, 2}, VolumeRule::lattice};
      const Scene scene = build_scene(problem);
      const Eigen::Matrix2Xd prescribed = random.field(scene.basis->functions());
      const std::vector<Constraint> found = constraints(scene, prescribed);
      const Eigen::Matrix2Xd any = constrained(random.field(scene.basis->functions()), found);
      CHECK((traces(scene) * (any - prescribed).reshaped()).cwiseAbs().maxCoeff() <= 1e-12);
      for (const Constraint& c : found) CHECK(c.masters.size() <= 4);  // of 3² functions at a corner five are slaves
    }
}

TEST_CASE("on its border a Powell-Sabin basis loses two functions a vertex, at convex corners all three",
          "[engine][grid_constraints]") {
  test::Random random(4);
  for (const test::Setting& setting : test::settings(random)) {
    if (setting.grid.basis != Case::BasisType::powell_sabin || !setting.name.ends_with(", border")) continue;
    CAPTURE(setting.name);
    Case problem = test::body_on_lines(setting);
    problem.boundaries[0].condition = fixed;
    constexpr Eigen::Index vertices = test::square_side + 1;
    const auto held = [&] { return constraints(build_scene(problem)); };
    CHECK(count(held()) == 2 * 2 * vertices);
    for (Case::Boundary& b : problem.boundaries) b.condition = fixed;
    CHECK(count(held()) == 2 * (2 * 4 * (vertices - 1) + 4));
    for (const Constraint& c : held()) CHECK(c.masters.empty());
  }
}

TEST_CASE("all around any triangle mesh every function that sees the border is held, for itself",
          "[engine][grid_constraints]") {
  test::Random random(8);
  for (int draw = 0; draw < 3; ++draw)
    for (const test::NamedMesh& named : test::meshes(random))
      for (const Case::BasisType basis : {Case::BasisType::linear, Case::BasisType::powell_sabin}) {
        CAPTURE(draw, named.name, basis);
        Case problem;
        problem.file = "mesh.json";
        problem.material = {.youngs_modulus = 1e6, .poissons_ratio = 0.3, .density = {}};
        problem.grid.basis = basis;
        problem.grid.mesh = std::make_shared<const TriangleMesh>(named.mesh);
        problem.boundaries = fixed_border(named.mesh);
        const auto [a, b, c] = corners(named.mesh, 0);
        problem.material_points = std::vector<Case::ListedPoint>{{(a + b + c) / 3.0, 1.0}};
        const Scene scene = build_scene(problem);
        const std::vector<Constraint> found = constraints(scene);
        for (const Constraint& held : found) CHECK(held.masters.empty());
        const Eigen::VectorXd seen = traces(scene).cwiseAbs().colwise().maxCoeff();
        CHECK(count(found) == (seen.array() > 1e-9).count());
      }
}

TEST_CASE("inside its grid a Powell-Sabin basis keeps the slope of each vertex across the line",
          "[engine][grid_constraints]") {
  test::Random random(5);
  for (const test::Setting& setting : test::settings(random)) {
    if (setting.grid.basis != Case::BasisType::powell_sabin || !setting.name.ends_with(", inside")) continue;
    CAPTURE(setting.name);
    Case problem = test::body_on_lines(setting);
    problem.boundaries[0].condition = fixed;
    const std::vector<Constraint> held = constraints(build_scene(problem));
    CHECK(count(held) == 2 * 2 * (test::square_side + 1));
    for (const Constraint& c : held) {
      CHECK(c.masters.size() == 1);
      for (const ComponentTerm& m : c.masters) CHECK(m.function / 3 == c.function / 3);  // of the same vertex
    }
  }
}

TEST_CASE("bases that interpolate on a line lose its functions, one by one", "[engine][grid_constraints]") {
  test::Random random(6);
  for (const test::Setting& setting : test::settings(random)) {
    const bool nodal = setting.grid.basis == Case::BasisType::bilinear || setting.grid.basis == Case::BasisType::linear;
    const bool open_knots = setting.grid.basis == Case::BasisType::bspline && setting.name.ends_with(", border");
    if (!nodal && !open_knots) continue;
    CAPTURE(setting.name);
    Case problem = test::body_on_lines(setting);
    problem.boundaries[0].condition = fixed;
    const Scene scene = build_scene(problem);
    const std::vector<Constraint> held = constraints(scene);
    CHECK(count(held) == 2 * (test::square_side + scene.basis->degree()));
    for (const Constraint& c : held) {
      CHECK(c.masters.empty());
      const Vec2 node = Eigen::Rotation2Dd(-setting.angle) * scene.basis->control_point(c.function);
      CHECK_THAT(node.y(), WithinAbs(0.0, 1e-12));
    }
  }
}

TEST_CASE("a piece that ends a rounding error beyond a vertex holds nothing there", "[engine][grid_constraints]") {
  test::Random random(9);
  for (const test::Setting& setting : test::settings(random)) {
    if (setting.name.ends_with(", border")) continue;
    CAPTURE(setting.name);
    const auto held = [&](double beyond) {
      Case problem = test::body_on_lines(setting);
      const Vec2 shift = setting.turned(beyond, 0.0);
      for (const std::size_t k : {0u, 1u}) problem.boundaries[k].piece.points[1 - k] += shift;
      for (const std::size_t k : {1u, 2u}) problem.boundaries[k].piece.points[2 - k] += shift;
      problem.boundaries[0].condition = fixed;
      return count(constraints(build_scene(problem)));
    };
    CHECK(held(1e-8) == held(0.0));
    if (!setting.grid.mesh) CHECK(held(1e-3) > held(0.0));  // else the line ends at the body's corner
  }
}

TEST_CASE("a piece that does not follow edges of cells, or only inner edges of elements, is refused with the remedy",
          "[engine][grid_constraints]") {
  using enum Case::BasisType;
  const Case::Grid squares{.lower = Vec2::Zero(), .upper = Vec2::Constant(4.0), .cell_size = Vec2::Ones()};
  const auto with = [&](Case::BasisType basis, TrianglePattern pattern) {
    test::Setting setting{"", squares};
    setting.grid.basis = basis;
    setting.grid.pattern = pattern;
    return setting;
  };
  const std::vector<Vec2> on_lines{{1.0, 1.0}, {3.0, 1.0}, {3.0, 3.0}, {1.0, 3.0}};
  const std::vector<Vec2> across{{1.0, 3.0}, {3.0, 1.0}, {4.0, 2.0}, {2.0, 4.0}};   // no diagonal runs this way
  const std::vector<Vec2> centres{{1.5, 1.0}, {1.5, 0.0}, {3.0, 0.0}, {3.0, 1.0}};  // through right angles and middles
  for (const Case::BasisType basis : {linear, powell_sabin}) {
    CHECK(refusal(with(basis, TrianglePattern::diagonal), on_lines) == "accepted");
    CHECK_THAT(refusal(with(basis, TrianglePattern::diagonal), across), Contains("\"bottom\"") && Contains("nitsche"));
    CHECK(refusal(with(basis, TrianglePattern::four), across) == "accepted");
  }
  CHECK_THAT(refusal(with(linear, TrianglePattern::four), centres), Contains("leaves the grid lines"));
  CHECK_THAT(refusal(with(powell_sabin, TrianglePattern::four), centres),
             Contains("\"bottom\"") && Contains("runs through the inside of a triangle near (1.5") &&
                 Contains("nitsche") && Contains("a mesh with edges along the piece"));
}
