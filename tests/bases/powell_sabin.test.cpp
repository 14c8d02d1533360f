#include "shoreline/bases/powell_sabin.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "meshes.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

namespace {

/// Coefficients of the spline with the value and gradient of a quadratic at every vertex: its tangent planes there, at
/// the corners of the control triangles.
struct Quadratic {
  double constant;
  Vec2 slope;
  Mat2 second;

  [[nodiscard]] double value(const Vec2& x) const { return constant + slope.dot(x) + 0.5 * x.dot(second * x); }
  [[nodiscard]] Vec2 gradient(const Vec2& x) const { return slope + second * x; }
  [[nodiscard]] double coefficient(const TriangleMesh& mesh, const PowellSabinBasis& basis, Index function) const {
    const Vec2& v = mesh.vertex[static_cast<std::size_t>(function / 3)];
    return value(v) + gradient(v).dot(basis.control_point(function) - v);
  }
};

Quadratic random_quadratic(test::Random& random) {
  const double mixed = random.uniform(-1.0, 1.0);
  Quadratic f{random.uniform(-1.0, 1.0), random.vector(), Mat2::Constant(mixed)};
  f.second.diagonal() = random.vector();
  return f;
}

/// Calls visit(name, mesh, basis, cell, x) with a place in every cell of every mesh.
void everywhere(unsigned seed, int draws, auto&& visit) {
  test::Random random(seed);
  for (int draw = 0; draw < draws; ++draw)
    for (const auto& [name, mesh] : test::meshes(random)) {
      CAPTURE(name);
      const PowellSabinBasis basis(mesh);
      for (Index cell = 0; cell < basis.grid().cells(); ++cell)
        visit(mesh, basis, cell, test::inside(corners(basis.grid().mesh(), cell), random));
    }
}

/// Length that makes derivatives of the functions of a cell about one: the cell's smallest height [m].
double smallest_height(const PowellSabinBasis& basis, Index cell) {
  const auto [a, b, c] = corners(basis.grid().mesh(), cell);
  return twice_area(a, b, c) / std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

}  // namespace

TEST_CASE("Powell-Sabin functions sum to one and are not negative", "[bases][powell_sabin]") {
  everywhere(1, 3, [](const TriangleMesh&, const PowellSabinBasis& basis, Index cell, const Vec2& x) {
    const Support support = basis.support(cell, x);
    CHECK_THAT(support.value.sum(), WithinAbs(1.0, 1e-12));
    CHECK(support.value.minCoeff() >= -1e-12);
  });
}

TEST_CASE("control points reproduce position", "[bases][powell_sabin]") {
  everywhere(2, 3, [](const TriangleMesh&, const PowellSabinBasis& basis, Index cell, const Vec2& x) {
    const Support support = basis.support(cell, x);
    Vec2 sum = Vec2::Zero();
    Mat2 gradient = Mat2::Zero();
    for (Eigen::Index a = 0; a < 9; ++a) {
      sum += support.value[a] * basis.control_point(support.function[a]);
      gradient += basis.control_point(support.function[a]) * support.gradient.col(a).transpose();
    }
    CHECK_THAT((sum - x).norm(), WithinAbs(0.0, 1e-11));
    CHECK_THAT((gradient - Mat2::Identity()).norm(), WithinAbs(0.0, 1e-9));
  });
}

TEST_CASE("quadratic fields are reproduced with their derivatives", "[bases][powell_sabin]") {
  test::Random random(3);
  const Quadratic f = random_quadratic(random);
  everywhere(4, 3, [&](const TriangleMesh& mesh, const PowellSabinBasis& basis, Index cell, const Vec2& x) {
    const Support support = basis.support(cell, x);
    Eigen::VectorXd c(9);
    for (Eigen::Index a = 0; a < 9; ++a) c[a] = f.coefficient(mesh, basis, support.function[a]);
    const double h = smallest_height(basis, cell);
    CHECK_THAT(support.value.dot(c), WithinAbs(f.value(x), 1e-11));
    CHECK_THAT((support.gradient * c - f.gradient(x)).norm() * h, WithinAbs(0.0, 1e-11));
    const Vec3 second = basis.curvatures(cell, x) * c;
    CHECK_THAT((second - Vec3(f.second(0, 0), f.second(1, 1), f.second(0, 1))).norm() * h * h, WithinAbs(0.0, 1e-11));
  });
}

TEST_CASE("any field is smooth across all edges of the refinement, its second derivatives are not",
          "[bases][powell_sabin]") {
  test::Random random(5);
  enum Kind { main_edge, vertex_to_centre, edge_to_centre };
  for (const auto& [name, mesh] : test::meshes(random)) {
    CAPTURE(name);
    const PowellSabinBasis basis(mesh);
    const Eigen::Matrix2Xd field = random.field(basis.functions());
    const auto kind = [&](const Face& face) {
      const auto& own = basis.grid().mesh().triangle[static_cast<std::size_t>(face.cell)];
      const auto& other = basis.grid().mesh().triangle[static_cast<std::size_t>(face.neighbour)];
      if (face.cell / powell_sabin_parts != face.neighbour / powell_sabin_parts) return main_edge;
      return own[0] == other[0] ? vertex_to_centre : edge_to_centre;
    };
    std::map<Kind, double> bend;
    for (Index cell = 0; cell < basis.grid().cells(); ++cell)
      for (const Face& face : basis.grid().faces(cell)) {
        const Vec2 x = face.a + random.uniform(0.0, 1.0) * (face.b - face.a);
        const Support left = basis.support(face.cell, x);
        const Support right = basis.support(face.neighbour, x);
        const double steepest = left.gradient.colwise().norm().maxCoeff();
        CHECK_THAT((left.interpolate(field) - right.interpolate(field)).norm(), WithinAbs(0.0, 1e-12));
        CHECK((left.gradient_of(field) - right.gradient_of(field)).norm() <= 1e-10 * steepest);
        const auto second = [&](Index c, const Support& s) {
          Eigen::Vector3d sum = Eigen::Vector3d::Zero();
          for (Eigen::Index a = 0; a < 9; ++a) sum += basis.curvatures(c, x).col(a) * field(0, s.function[a]);
          return sum;
        };
        const Vec3 own = second(face.cell, left);
        double& largest = bend[kind(face)];
        largest = std::max(largest, (own - second(face.neighbour, right)).norm() / own.norm());
      }
    CHECK(bend.size() == 3);
    for (const auto& [edge, jump] : bend) CHECK(jump > 0.1);
  }
}

TEST_CASE("gradients and second derivatives of Powell-Sabin functions match finite differences",
          "[bases][powell_sabin]") {
  everywhere(6, 1, [](const TriangleMesh&, const PowellSabinBasis& basis, Index cell, const Vec2& x) {
    const Support here = basis.support(cell, x);
    const ShortCurvatures second = basis.curvatures(cell, x);
    const double h = smallest_height(basis, cell);
    const double step = 1e-4 * h;
    for (int axis = 0; axis < 2; ++axis) {
      const Support ahead = basis.support(cell, x + step * Vec2::Unit(axis));
      const Support behind = basis.support(cell, x - step * Vec2::Unit(axis));
      const ShortVector slope = (ahead.value - behind.value) / (2.0 * step);
      CHECK_THAT((here.gradient.row(axis).transpose() - slope).norm() * h, WithinAbs(0.0, 1e-8));
      const ShortGradients bend = (ahead.gradient - behind.gradient) / (2.0 * step);
      CHECK_THAT((second.row(axis) - bend.row(axis)).norm() * h * h, WithinAbs(0.0, 1e-7));
      CHECK_THAT((second.row(2) - bend.row(1 - axis)).norm() * h * h, WithinAbs(0.0, 1e-7));
    }
  });
}

TEST_CASE("a function vanishes outside the triangles around its vertex", "[bases][powell_sabin]") {
  test::Random random(7);
  for (const auto& [name, mesh] : test::meshes(random)) {
    const PowellSabinBasis basis(mesh);
    CHECK(basis.functions() == 3 * static_cast<Index>(mesh.vertex.size()));
    for (Index cell = 0; cell < basis.grid().cells(); ++cell) {
      const ShortIndices functions = basis.functions_of(cell);
      REQUIRE(functions.size() == 9);
      const auto& triangle = mesh.triangle[static_cast<std::size_t>(cell / powell_sabin_parts)];
      for (Eigen::Index a = 0; a < 9; ++a) CHECK(std::ranges::count(triangle, functions[a] / 3) == 1);
    }
  }
}

TEST_CASE("on a straight border and at a corner one function of each vertex vanishes along the line",
          "[bases][powell_sabin]") {
  test::Random random(8);
  for (const TrianglePattern pattern : {TrianglePattern::diagonal, TrianglePattern::four}) {
    TriangleMesh mesh = test::lattice(4, 3, pattern);
    const std::vector<Vec2> lattice = mesh.vertex;
    test::place(mesh, random);
    const PowellSabinBasis basis(mesh);
    for (const auto& [axis, level] : {std::pair(0, 0.0), std::pair(0, 4.0), std::pair(1, 0.0), std::pair(1, 3.0)}) {
      std::vector<char> vanishes(static_cast<std::size_t>(basis.functions()), 1);
      for (const auto& triangle : mesh.triangle)
        for (std::size_t k = 0; k < 3; ++k) {
          const auto a = static_cast<std::size_t>(triangle[k]);
          const auto b = static_cast<std::size_t>(triangle[(k + 1) % 3]);
          if (lattice[a][axis] != level || lattice[b][axis] != level) continue;
          for (const double s : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
            const Vec2 x = mesh.vertex[a] + s * (mesh.vertex[b] - mesh.vertex[a]);
            const Support support = basis.support(basis.grid().locate(x, 0).value(), x);
            for (Eigen::Index n = 0; n < 9; ++n)
              if (std::abs(support.value[n]) > 1e-12) vanishes[static_cast<std::size_t>(support.function[n])] = 0;
          }
        }
      for (std::size_t v = 0; v < lattice.size(); ++v)
        CHECK(std::count(&vanishes[3 * v], &vanishes[3 * v] + 3, 1) == (lattice[v][axis] == level ? 1 : 3));
    }
  }
}

TEST_CASE("a corner of less than 150 degrees has a side of its control triangle on both border edges, others on one",
          "[bases][powell_sabin]") {
  for (const Index corners : {3, 4, 8, 11, 13, 40}) {
    CAPTURE(corners);
    const TriangleMesh mesh = test::fan(corners);
    const PowellSabinBasis basis(mesh);
    for (Index v = 1; v <= corners; ++v) {
      const Vec2& here = mesh.vertex[static_cast<std::size_t>(v)];
      const auto on_edge = [&](Index other) {  // control points of v on the edge to another vertex
        const Vec2 along = (mesh.vertex[static_cast<std::size_t>(other)] - here).normalized();
        int count = 0;
        for (Index f = 3 * v; f < 3 * v + 3; ++f)
          if (std::abs(cross(along, basis.control_point(f) - here)) < 1e-12) ++count;
        return count;
      };
      CHECK(on_edge(1 + v % corners) == 2);
      CHECK(on_edge(1 + (v + corners - 2) % corners) == (corners < 12 ? 2 : 0));
    }
  }
}

TEST_CASE("a mesh that breaks a rule carries no Powell-Sabin splines", "[bases][powell_sabin]") {
  TriangleMesh mesh = test::lattice(2, 2, TrianglePattern::diagonal);
  std::swap(mesh.triangle[3][0], mesh.triangle[3][1]);
  CHECK_THROWS_AS(PowellSabinBasis(mesh), MeshError);
  CHECK_THROWS_AS(PowellSabinBasis(test::lattice(2, 2, TrianglePattern::diagonal, {1.0, 0.015})), MeshError);
}
