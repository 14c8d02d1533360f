#include "shoreline/bases/gmsh_reader.hpp"

#include <catch2/catch.hpp>
#include <sstream>

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

// A unit square in two triangles with its outline. Tags have gaps; node 9 is the centre of no arc any more.
const std::string old_format = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
2 6 "body"
$EndPhysicalNames
$Nodes
5
1 0 0 0
2 1 0 0
9 0.5 -7 0
4 1 1 0
7 0 1 0
$EndNodes
$Elements
4
1 15 2 0 1 1
2 1 2 0 1 1 2
5 2 2 6 1 1 2 4
6 2 2 6 1 1 4 7
$EndElements
)";

const std::string new_format = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
1 1 1 0
1 0 0 0 0
1 0 0 0 1 0 0 0 2 1 -1
1 0 0 0 1 1 0 0 1 1
$EndEntities
$Nodes
3 5 1 9
0 1 0 1
1
0 0 0
1 1 0 2
2
9
1 0 0
0.5 -7 0
2 1 0 2
4
7
1 1 0
0 1 0
$EndNodes
$Elements
3 4 1 6
0 1 15 1
1 1
1 1 1 1
2 1 2
2 1 2 2
5 1 2 4
6 1 4 7
$EndElements
)";

TriangleMesh read(const std::string& text) {
  std::istringstream in(text);
  return read_gmsh(in, "square.msh");
}

/// The text with one part of it replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto begin = text.find(from);
  REQUIRE(begin != std::string::npos);
  return text.replace(begin, from.size(), to);
}

}  // namespace

TEST_CASE("both formats give the triangles of the file and the nodes that they use", "[bases][gmsh_reader]") {
  for (const std::string& text : {old_format, new_format}) {
    const TriangleMesh mesh = read(text);
    CHECK(mesh.vertex == std::vector<Vec2>{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}});
    CHECK(mesh.triangle == std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}});
    CHECK_NOTHROW(check(mesh));
  }
}

TEST_CASE("line ends of any system and blank lines make no difference", "[bases][gmsh_reader]") {
  for (std::string text : {old_format, new_format}) {
    for (std::size_t k = text.find('\n'); k != std::string::npos; k = text.find('\n', k + 4))
      text.replace(k, 1, "\r\n\n");
    CHECK(read(text).triangle.size() == 2);
  }
}

TEST_CASE("coordinates keep all their digits", "[bases][gmsh_reader]") {
  const TriangleMesh mesh = read(with(old_format, "4 1 1 0", "4 0.1234567890123457 1.0000000000000002e-3 0"));
  CHECK(mesh.vertex[2] == Vec2(0.1234567890123457, 1.0000000000000002e-3));
}

TEST_CASE("what is not understood is refused with its line", "[bases][gmsh_reader]") {
  const auto refused = [](const std::string& text, const std::string& from, const std::string& to,
                          const std::string& line, const std::string& message) {
    CAPTURE(from, to);
    CHECK_THROWS_AS(read(with(text, from, to)), MeshError);
    CHECK_THROWS_WITH(read(with(text, from, to)), StartsWith("square.msh:" + line + ": ") && Contains(message));
  };
  refused(old_format, "$MeshFormat", "$NoFormat", "1", "expected $MeshFormat, found \"$NoFormat\"");
  refused(old_format, "2.2 0 8", "4.0 0 8", "2", "format \"4.0\" is not read, save the mesh in format 2.2 or 4.1");
  refused(new_format, "4.1 0 8", "4.1 1 8", "2", "binary");
  refused(old_format, "$PhysicalNames", "$Periodic", "4", "\"$Periodic\" is not read");
  refused(old_format, "5\n1 0 0 0", "-5\n1 0 0 0", "9", "expected the number of nodes, found -5");
  refused(old_format, "2 1 0 0\n9", "2 1 a 0\n9", "11", "expected a coordinate y, found \"a\"");
  refused(old_format, "2 1 0 0\n9", "2 1 0\n9", "11", "expected a coordinate z, found \"\"");
  refused(old_format, "2 1 0 0\n9", "2 1 0 0 0\n9", "11", "expected the end of the line, found \"0\"");
  refused(old_format, "2 1 0 0\n9", "2 1 0 0.5\n9", "11", "node 2 is not in the plane z = 0");
  refused(old_format, "2 1 0 0\n9", "1 1 0 0\n9", "11", "a second node 1");
  refused(old_format, "7 0 1 0\n", "", "14", "expected the tag of a node, found \"$EndNodes\"");
  refused(old_format, "7 0 1 0\n", "7 0 1 0\n8 0 2 0\n", "15", "expected $EndNodes, found \"8\"");
  refused(old_format, "5 2 2 6 1 1 2 4", "5 3 2 6 1 1 2 4 7", "20", "type 3, quadrangles");
  refused(old_format, "5 2 2 6 1 1 2 4", "5 9 2 6 1 1 2 4 7 7 7", "20", "type 9, triangles of six nodes");
  refused(old_format, "5 2 2 6 1 1 2 4", "5 4 2 6 1 1 2 4 7", "20", "type 4,");
  refused(old_format, "6 2 2 6 1 1 4 7", "6 2 2 6 1 1 4 8", "21", "no node 8");
  refused(old_format, "6 2 2 6 1 1 4 7", "6 2 2 6 1 1 4", "21", "expected the tag of a node, found \"\"");
  refused(old_format, "$EndElements\n", "", "22", "the file ends, expected $EndElements");
  refused(old_format, "4\n1 15", "2\n1 15", "20", "expected $EndElements, found \"5\"");
  refused(new_format, "1 1 0 2", "1 1 1 2", "15", "Mesh.SaveParametric");
  refused(new_format, "1 0 0\n0.5 -7 0", "1 0 0", "19", "expected the end of the line, found \"2\"");
  refused(new_format, "2 1 2 2\n", "2 1 3 2\n", "32", "type 3, quadrangles");
  refused(new_format, "6 1 4 7", "6 1 4 70", "34", "no node 70");
}

TEST_CASE("a file without triangles is refused", "[bases][gmsh_reader]") {
  CHECK_THROWS_WITH(read(""), StartsWith("square.msh:1: ") && Contains("expected $MeshFormat"));
  CHECK_THROWS_WITH(read(old_format.substr(0, old_format.find("$Nodes"))), Contains("no triangles"));
}

TEST_CASE("what is no text is shown short and in readable characters", "[bases][gmsh_reader]") {
  CHECK_THROWS_WITH(read("\x89PNG\x1b[2J" + std::string(1000, 'x')),
                    Contains("square.msh:1") && Contains("found \"?PNG?[2Jxxx") && !Contains(std::string(50, 'x')));
}
