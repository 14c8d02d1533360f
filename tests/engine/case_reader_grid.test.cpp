// Grid and basis as a case names them, with what follows from them.

#include <catch2/catch.hpp>
#include <fstream>

#include "output_folder.hpp"
#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Type = Case::BasisType;

namespace {

/// A square on a grid given as JSON; its material points too.
std::string square(const std::string& grid, const std::string& points = R"({"per_cell": 2})") {
  return R"({"analysis": {"type": "quasi_static", "plane": "stress"},
    "material": {"type": "linear_elastic", "youngs_modulus": 1, "poissons_ratio": 0},
    "boundaries": [{"name": "outline", "points": [[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.1]], "corners": [0, 1, 2],
                    "condition": {"type": "fixed"}}],
    "material_points": )" +
         points + R"(, "grid": )" + grid + "}";
}

Case::Grid grid_of(const std::string& grid) { return parse_case(square(grid), "square.json").grid; }

Case::Grid with(const std::string& more) {
  return grid_of(R"({"lower": [0, 0], "upper": [1, 1], "cell_size": 0.5, )" + more + "}");
}

const char* const two_triangles =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
    "$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 3 4\n$EndElements\n";

}  // namespace

TEST_CASE("the basis says what the cells are, and triangles alone mean the linear basis", "[engine][case_reader]") {
  CHECK(grid_of(R"({"lower": [0, 0], "upper": [1, 1], "cell_size": 0.5})").basis == Type::bilinear);
  CHECK(with(R"("cells": "quadrilateral")").basis == Type::bilinear);
  CHECK(with(R"("cells": "triangle")").basis == Type::linear);
  CHECK(with(R"("basis": "linear")").basis == Type::linear);
  CHECK(with(R"("cells": "triangle", "basis": "powell_sabin")").basis == Type::powell_sabin);
  CHECK(with(R"("basis": "powell_sabin")").pattern == TrianglePattern::diagonal);
  CHECK(with(R"("basis": "powell_sabin", "pattern": "four")").pattern == TrianglePattern::four);
  CHECK(with(R"("basis": "bspline")").degree == 2);
  CHECK(with(R"("basis": "bspline", "degree": 3)").degree == 3);
}

TEST_CASE("what a basis cannot use is refused where it stands", "[engine][case_reader]") {
  CHECK_THROWS_WITH(with(R"("cells": "quadrilateral", "basis": "powell_sabin")"),
                    Contains("/grid/cells: ") && Contains("remove \"cells\""));
  CHECK_THROWS_WITH(with(R"("cells": "triangle", "basis": "bspline")"), Contains("/grid/cells: "));
  CHECK_THROWS_WITH(with(R"("degree": 2)"), Contains("/grid/degree: ") && Contains("the basis \"bilinear\""));
  CHECK_THROWS_WITH(with(R"("basis": "bspline", "pattern": "four")"), Contains("/grid/pattern: "));
  CHECK_THROWS_WITH(with(R"("mesh": "square.msh")"), Contains("/grid/lower: found \"lower\" beside \"mesh\""));
  CHECK_THROWS_WITH(with(R"("points": [[0, 0], [1, 0], [0, 1]])"), Contains("/grid/lower: "));
}

TEST_CASE("a mesh is read from beside the case file", "[engine][case_reader]") {
  const test::OutputFolder folder;
  std::filesystem::create_directory(folder.path / "meshes");
  std::ofstream(folder.path / "meshes" / "square.msh") << two_triangles;
  std::ofstream(folder.path / "case.json") << square(R"({"mesh": "meshes/square.msh"})");
  const Case::Grid grid = read_case(folder.path / "case.json").grid;
  CHECK(grid.basis == Type::linear);
  REQUIRE(grid.mesh != nullptr);
  CHECK(grid.mesh->triangle.size() == 2);
  CHECK(grid.mesh->vertex.at(2) == Vec2(1, 1));
  CHECK(read_case(folder.path / "case.json", {"grid.basis=powell_sabin"}).grid.basis == Type::powell_sabin);
}

TEST_CASE("a mesh that cannot be used is refused with its file", "[engine][case_reader]") {
  const test::OutputFolder folder;
  const auto read = [&](const std::string& mesh) {
    return parse_case(square(R"({"mesh": ")" + mesh + R"("})"), folder.path / "case.json");
  };
  const auto names = [&](const std::string& mesh) { return Contains("/grid/mesh: " + (folder.path / mesh).string()); };
  CHECK_THROWS_WITH(read("missing.msh"), names("missing.msh") && Contains("No such file") && Contains("4.1"));
  CHECK_THROWS_WITH(read("."), names(".") && Contains("folder"));
  std::ofstream(folder.path / "short.msh") << "$MeshFormat\n2.2 0 8\n";
  CHECK_THROWS_WITH(read("short.msh"), names("short.msh:3") && Contains("$EndMeshFormat"));
  std::string inverted = two_triangles;
  inverted.replace(inverted.find("1 3 4"), 5, "1 4 3");
  std::ofstream(folder.path / "inverted.msh") << inverted;
  CHECK_THROWS_WITH(read("inverted.msh"), names("inverted.msh") && Contains("triangle 1") && Contains("clockwise"));
}

TEST_CASE("points become their Delaunay triangulation", "[engine][case_reader]") {
  const Case::Grid grid = grid_of(R"({"points": [[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0.4]]})");
  CHECK(grid.basis == Type::linear);
  REQUIRE(grid.mesh != nullptr);
  CHECK(grid.mesh->triangle.size() == 4);  // about the point inside
  CHECK(grid.mesh->vertex.at(4) == Vec2(0.5, 0.4));
  const std::string notched = R"({"points": [[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0.4]], "outline": [0, 1, 2, )";
  CHECK(grid_of(notched + "4, 3]}").mesh->triangle.size() == 3);
  CHECK_THROWS_WITH(grid_of(notched + "9]}"), Contains("/grid/points: ") && Contains("point 9"));
  CHECK_THROWS_WITH(grid_of(R"({"points": [[0, 0], [1, 1], [2, 2]]})"), Contains("/grid/points: ") && Contains("line"));
  CHECK_THROWS_WITH(grid_of(R"({"points": [[0, 0], [1, 0], [1, 1], [1, 0]]})"),
                    Contains("/grid/points: ") && Contains("vertex ") && Contains(" at (1, 0)"));
}

TEST_CASE("the ghost penalty and the band of Nitsche's method suit the basis", "[engine][case_reader]") {
  const auto nitsche = [](const std::string& basis, const std::vector<std::string>& more) {
    std::vector<std::string> overrides{"boundaries.outline.condition.method=nitsche", "grid.basis=" + basis};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return parse_case(square(R"({"lower": [0, 0], "upper": [1, 1], "cell_size": 0.5})"), "square.json", overrides);
  };
  const auto band = [](const Case& problem) { return std::get<Essential>(problem.boundaries[0].condition).band; };
  CHECK(nitsche("bilinear", {}).ghost == 1e-3);
  CHECK(nitsche("linear", {}).ghost == 1e-2);
  CHECK(nitsche("powell_sabin", {}).ghost == 1e-4);
  CHECK(nitsche("bspline", {}).ghost == 5e-4);
  CHECK(band(nitsche("linear", {})) == 0.01);
  CHECK(band(nitsche("bspline", {})) == 0.01);
  CHECK(std::get<Essential>(nitsche("bspline", {}).boundaries[0].condition).narrows);
  CHECK(band(nitsche("powell_sabin", {})) == 0.02);
  const Case named = nitsche("powell_sabin", {"boundaries.outline.condition.band=0.05"});
  CHECK(band(named) == 0.05);
  CHECK_FALSE(std::get<Essential>(named.boundaries[0].condition).narrows);
  CHECK(nitsche("powell_sabin", {"ghost=0"}).ghost == 0.0);
  const auto penalty = [&](const std::string& basis) {
    return nitsche(basis, {"boundaries.outline.condition.method=implicit_boundary"}).ghost;
  };
  CHECK(penalty("bilinear") == 0.0);
  CHECK(penalty("linear") == 0.0);
  CHECK(penalty("bspline") == 5e-4);
  CHECK(penalty("powell_sabin") == 1e-4);
  CHECK(nitsche("powell_sabin", {"boundaries.outline.condition.method=grid"}).ghost == 0.0);
}

TEST_CASE("material points on triangles", "[engine][case_reader]") {
  const std::string cut = R"({"lower": [0, 0], "upper": [1, 1], "cell_size": 0.5, "basis": "powell_sabin"})";
  const std::string mesh = R"({"points": [[0, 0], [1, 0], [1, 1], [0, 1]]})";
  const auto points = [](const std::string& grid, const std::string& fill) {
    return parse_case(square(grid, fill), "square.json").material_points;
  };
  CHECK(std::get<LatticeFill>(points(mesh, R"({"per_cell": [3, 3]})")).per_cell == std::array{3, 3});
  CHECK(std::get<VertexFill>(points(mesh, R"({"fill": "vertex", "across": [3, 4]})")).across);
  CHECK(std::get<VertexFill>(points(cut, R"({"fill": "vertex", "per_cell": [3, 4]})")).count == std::array{3, 4});
  CHECK(std::get<BlockFill>(points(cut, R"({"per_block": [3, 4]})")).per_block == std::array{3, 4});
  CHECK(std::get<AcrossFill>(points(mesh, R"({"across": [3, 4]})")).across == std::array{3, 4});
  CHECK_THROWS_WITH(points(mesh, R"({"per_block": 3})"),
                    Contains("/material_points/per_block: ") && Contains("no rectangles") && Contains("\"across\""));
  for (const std::string& grid : {cut, mesh})
    CHECK_THROWS_WITH(points(grid, R"({"per_cell": [3, 4]})"),
                      Contains("/material_points/per_cell: ") && Contains("[3,4]") && Contains("one number"));
  CHECK_THROWS_WITH(points(mesh, R"({"fill": "vertex", "per_cell": 3})"),
                    Contains("/material_points/per_cell: ") && Contains("\"across\""));
}

TEST_CASE("triangles and the points in them are counted before they are made", "[engine][case_reader]") {
  const auto fine = [](const std::string& size, const std::string& more, const std::string& per_cell = "1") {
    return parse_case(square(R"({"lower": [0, 0], "upper": [1, 1], "cell_size": )" + size + ", " + more + "}",
                             R"({"per_cell": )" + per_cell + "}"),
                      "square.json");
  };
  CHECK_NOTHROW(fine("1.01e-4", R"("basis": "bilinear")"));  // 9.8e7 rectangles
  CHECK_THROWS_WITH(fine("1.01e-4", R"("basis": "linear")"), Contains("/grid/cell_size") && Contains("1.96e+08 cells"));
  CHECK_THROWS_WITH(fine("1.01e-4", R"("basis": "powell_sabin", "pattern": "four")"), Contains("2.35e+09 cells"));
  CHECK_THROWS_WITH(fine("1e-3", R"("basis": "linear", "pattern": "four")", "16"),
                    Contains("/material_points/per_cell") && Contains("1.02e+09 points"));
  CHECK_THROWS_WITH(fine("1e-3", R"("basis": "powell_sabin")", "19"), Contains("1.2e+09 points"));
}

TEST_CASE("rectangles that would be cut into slivers are refused with their angle", "[engine][case_reader]") {
  const auto cut = [](const std::string& size) {
    return grid_of(R"({"lower": [0, 0], "upper": [1, 1], "basis": "linear", "cell_size": )" + size + "}");
  };
  CHECK_NOTHROW(cut("[0.5, 0.01]"));
  CHECK_THROWS_WITH(cut("[0.5, 0.005]"), Contains("/grid/cell_size") && Contains("0.573 degrees"));
}
