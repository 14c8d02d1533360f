#include "grid_reader.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <numbers>

#include "../make_basis.hpp"
#include "shoreline/bases/gmsh_reader.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"

namespace shoreline {
namespace {

Case::BasisType basis_by_name(const Node& node) {
  if (node.is("linear")) return Case::BasisType::linear;
  if (node.is("powell_sabin")) return Case::BasisType::powell_sabin;
  return node.is("bspline") ? Case::BasisType::bspline : Case::BasisType::bilinear;
}

/// The basis, which may be left to the shape of the cells; and the shape, if it is said, must be that of the basis.
Case::BasisType read_basis(const Node& node) {
  const bool wants_triangles = node.has("cells") && node["cells"].is("triangle");
  if (!node.has("basis")) return wants_triangles ? Case::BasisType::linear : Case::BasisType::bilinear;
  const Case::BasisType basis = basis_by_name(node["basis"]);
  if (node.has("cells") && wants_triangles != has_triangles(basis))
    node["cells"].place.fail(fmt::format(
        "found {}, expected \"{}\", the cells of the basis {}; remove \"cells\", or name a basis on such cells: {}",
        node["cells"].value.dump(), wants_triangles ? "quadrilateral" : "triangle", node["basis"].value.dump(),
        wants_triangles ? "\"linear\" or \"powell_sabin\"" : "\"bilinear\" or \"bspline\""));
  return basis;
}

/// Refuses cells that no machine holds.
void check_count(const Node& node, const std::string& made, double cells) {
  constexpr double most = 1e8;
  if (!(cells <= most))
    node.place.fail(
        fmt::format("found {}, which makes {} = {:.3g} cells, expected at most {:g}; enlarge the cells or "
                    "shrink the grid",
                    described(node.value), made, cells, most));
}

/// Cells of a basis in each main triangle or rectangle.
double parts_of(Case::BasisType basis) { return basis == Case::BasisType::powell_sabin ? powell_sabin_parts : 1.0; }

void check_rectangles(const Node& node, const Case::Grid& grid) {
  for (const Eigen::Index axis : {0, 1})
    if (grid.upper[axis] <= grid.lower[axis])
      node["upper"]
          .entry(static_cast<std::size_t>(axis))
          .place.fail(
              fmt::format("found {}, expected more than {}, the lower end", grid.upper[axis], grid.lower[axis]));
  const Vec2 count = rectangles_of(grid);
  const double each = cells_to_fill(grid) / count.prod() * parts_of(grid.basis);
  check_count(node["cell_size"],
              fmt::format("{:.3g} x {:.3g}{}", count.x(), count.y(),
                          each > 1.0 ? fmt::format(" rectangles of {:g} triangles", each) : ""),
              count.prod() * each);
}

/// Refuses rectangles whose triangles are slivers.
void check_angle(const Node& size, const Case::Grid& grid) {
  constexpr double degree = std::numbers::pi / 180.0;
  const Vec2& cell = grid.cell_size;
  const bool four = grid.pattern == TrianglePattern::four;
  const double angle = std::min(smallest_angle({Vec2::Zero(), Vec2(cell.x(), 0.0), four ? Vec2(0.5 * cell) : cell}),
                                smallest_angle({Vec2::Zero(), cell, Vec2(0.0, cell.y())}));
  if (angle < smallest_allowed_angle)
    size.place.fail(
        fmt::format("found {}, which makes triangles with an angle of {:.3g} degrees, expected at least "
                    "{:g}; take width and height closer to each other",
                    size.value.dump(), angle / degree, smallest_allowed_angle / degree));
}

/// Rectangles, whole or cut.
Case::Grid read_rectangles(const Node& node) {
  const auto size = pair_of<double>(node["cell_size"]);
  Case::Grid grid{.lower = node["lower"].vector(),
                  .upper = node["upper"].vector(),
                  .cell_size = {size[0], size[1]},
                  .basis = read_basis(node)};
  const std::string beside = node.has("basis") ? node["basis"].value.dump() : "the basis \"bilinear\"";
  if (node.has("degree")) {
    if (grid.basis != Case::BasisType::bspline)
      node["degree"].place.fail(
          fmt::format("found a degree, expected none beside {}; it goes with \"bspline\"", beside));
    grid.degree = node["degree"].as<int>();
  }
  if (node.has("pattern")) {
    if (!has_triangles(grid.basis))
      node["pattern"].place.fail(
          fmt::format("found a pattern of triangles, expected none beside {}; it goes with \"linear\" and "
                      "\"powell_sabin\"",
                      beside));
    grid.pattern = node["pattern"].is("four") ? TrianglePattern::four : TrianglePattern::diagonal;
  }
  check_rectangles(node, grid);
  if (has_triangles(grid.basis)) check_angle(node["cell_size"], grid);
  return grid;
}

TriangleMesh read_mesh_file(const Node& node, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / node.as<std::string>();
  const auto fail = [&](const std::string& found) {
    node.place.fail(fmt::format("{}: {}, expected a mesh of Gmsh, format 2.2 or 4.1, ASCII", file.string(), found));
  };
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) fail("found a folder");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail(fmt::format("cannot be read ({})", std::strerror(errno)));
  try {
    return read_gmsh(stream, file.string());
  } catch (const MeshError& error) {  // names the file
    node.place.fail(error.what());
  }
}

void check_mesh_count(const Node& node, const Case::Grid& grid) {
  check_count(node, fmt::format("{} triangles", grid.mesh->triangle.size()),
              cells_to_fill(grid) * parts_of(grid.basis));
}

Case::Grid read_mesh(const Node& node, const std::filesystem::path& folder) {
  const Node file = node["mesh"];
  Case::Grid grid{.basis = read_basis(node)};
  grid.mesh = std::make_shared<const TriangleMesh>(read_mesh_file(file, folder));
  check_mesh_count(file, grid);
  try {
    check(*grid.mesh);
  } catch (const MeshError& error) {
    file.place.fail((folder / file.as<std::string>()).string() + ": " + error.what());
  }
  return grid;
}

Case::Grid read_points(const Node& node) {
  const Node list = node["points"];
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < list.size(); ++i) points.push_back(list.entry(i).vector());
  Case::Grid grid{.basis = read_basis(node)};
  std::vector<Index> outline;
  if (node.has("outline")) outline = node["outline"].as<std::vector<Index>>();
  grid.mesh = list.made([&] { return std::make_shared<const TriangleMesh>(delaunay(points, outline)); });
  check_mesh_count(list, grid);
  return grid;
}

}  // namespace

bool has_triangles(Case::BasisType basis) {
  return basis == Case::BasisType::linear || basis == Case::BasisType::powell_sabin;
}

double cells_to_fill(const Case::Grid& grid) {
  if (grid.mesh) return static_cast<double>(grid.mesh->triangle.size());
  const double triangles = grid.pattern == TrianglePattern::four ? 4.0 : 2.0;
  return rectangles_of(grid).prod() * (has_triangles(grid.basis) ? triangles : 1.0);
}

Case::Grid read_grid(const Node& node, const std::filesystem::path& folder) {
  if (node.has("mesh")) return read_mesh(node, folder);
  if (node.has("points")) return read_points(node);
  return read_rectangles(node);
}

}  // namespace shoreline
