#include "shoreline/bases/mesh_generators.hpp"

namespace shoreline {

TriangleMesh triangulate(const QuadrilateralGrid& rectangles, TrianglePattern pattern) {
  TriangleMesh mesh;
  for (Index node = 0; node < rectangles.nodes(); ++node) mesh.vertex.push_back(rectangles.node(node));
  for (Index cell = 0; cell < rectangles.cells(); ++cell) {
    const Index a = cell + cell / rectangles.columns();  // lower left; one node more than cells in each row
    const Index b = a + 1;
    const Index c = b + rectangles.columns() + 1;
    const Index d = c - 1;
    if (pattern == TrianglePattern::diagonal) {
      mesh.triangle.insert(mesh.triangle.end(), {{a, b, c}, {a, c, d}});
    } else {
      const auto middle = static_cast<Index>(mesh.vertex.size());
      mesh.vertex.push_back(0.5 * (rectangles.node(a) + rectangles.node(c)));
      mesh.triangle.insert(mesh.triangle.end(), {{a, b, middle}, {b, c, middle}, {c, d, middle}, {d, a, middle}});
    }
  }
  return mesh;
}

}  // namespace shoreline
