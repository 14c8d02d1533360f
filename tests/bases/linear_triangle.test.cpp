#include "shoreline/bases/linear_triangle.hpp"

#include <catch2/catch.hpp>

#include "meshes.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

TEST_CASE("each linear function is one at its vertex and zero at the others", "[bases][linear_triangle]") {
  test::Random random(1);
  for (const auto& [name, mesh] : test::meshes(random)) {
    const LinearTriangleBasis basis(mesh);
    CHECK(basis.functions() == static_cast<Index>(mesh.vertex.size()));
    for (Index cell = 0; cell < basis.grid().cells(); ++cell)
      for (Eigen::Index k = 0; k < 3; ++k) {
        const Index vertex = mesh.triangle[static_cast<std::size_t>(cell)][static_cast<std::size_t>(k)];
        const Support support = basis.support(cell, mesh.vertex[static_cast<std::size_t>(vertex)]);
        CHECK(support.function[k] == vertex);
        CHECK_THAT((support.value - Eigen::Vector3d::Unit(k)).norm(), WithinAbs(0.0, 1e-12));
        CHECK(basis.control_point(vertex) == mesh.vertex[static_cast<std::size_t>(vertex)]);
      }
  }
}

TEST_CASE("linear functions are not negative in their triangle and reproduce linear fields",
          "[bases][linear_triangle]") {
  test::Random random(2);
  for (const auto& [name, mesh] : test::meshes(random)) {
    CAPTURE(name);
    const LinearTriangleBasis basis(mesh);
    const Vec2 slope = random.vector();
    for (Index cell = 0; cell < basis.grid().cells(); ++cell) {
      const Vec2 x = test::inside(corners(mesh, cell), random);
      const Support support = basis.support(cell, x);
      CHECK(support.value.minCoeff() >= -1e-12);
      CHECK_THAT(support.value.sum(), WithinAbs(1.0, 1e-14));
      double field = 0.0;
      Vec2 gradient = Vec2::Zero();
      for (Eigen::Index a = 0; a < 3; ++a) {
        field += support.value[a] * slope.dot(basis.control_point(support.function[a]));
        gradient += support.gradient.col(a) * slope.dot(basis.control_point(support.function[a]));
      }
      CHECK_THAT(field, WithinAbs(slope.dot(x), 1e-11));
      CHECK_THAT((gradient - slope).norm(), WithinAbs(0.0, 1e-9));
      CHECK(basis.curvatures(cell, x).norm() == 0.0);
    }
  }
}

TEST_CASE("a mesh that breaks a rule carries no linear basis", "[bases][linear_triangle]") {
  TriangleMesh mesh = test::lattice(2, 2, TrianglePattern::diagonal);
  mesh.vertex.emplace_back(9.0, 9.0);
  CHECK_THROWS_AS(LinearTriangleBasis(mesh), MeshError);
}
