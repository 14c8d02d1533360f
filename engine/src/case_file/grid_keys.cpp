#include "key_rows.hpp"

namespace shoreline::keys {
namespace {

Key cells(std::vector<std::string> shapes) {
  return key("cells", {Choice{std::move(shapes)}}, optional, "",
             "shape of the cells; default: that of the basis. Where only `triangle` is said, the basis is `linear`");
}

}  // namespace

Schema grid() {
  const Key basis =
      key("basis", {Choice{{"linear", "powell_sabin"}}}, otherwise("linear"), "", "basis functions on the triangles");
  const Object mesh{
      {key("mesh", {Text{}}, required, "",
           "file of triangles, which Gmsh wrote in format 2.2 or 4.1, ASCII; its path is relative to the case file"),
       cells({"triangle"}), basis},
      {}};
  const Object points{
      {key("points", list(position(), 3, many), required, "m", "vertices of triangles: their Delaunay triangulation"),
       key("outline", list({Integer{0, static_cast<int>(many)}}, 3, many), optional, "",
           "numbers of points (the first is 0) around the triangles, counter-clockwise; default: their convex hull"),
       cells({"triangle"}), basis},
      {}};
  const Object rectangles{
      {key("lower", position(), required, "m", "lower left corner"),
       key("upper", position(), required, "m",
           "upper right corner, moved out to whole cells; above and right of `lower`"),
       key("cell_size", one_or_pair(length()), required, "m",
           "width and height of the rectangles, which triangle bases cut; at most 1e8 cells in all"),
       key("basis", {Choice{{"bilinear", "linear", "powell_sabin", "bspline"}}}, optional, "",
           "basis functions on the cells: `bilinear` (default) and `bspline` on rectangles, `linear` and "
           "`powell_sabin` on triangles"),
       key("degree", {Integer{1, 3}}, optional, "", "of the basis `bspline`; default 2"),
       cells({"quadrilateral", "triangle"}),
       key("pattern", {Choice{{"diagonal", "four"}}}, optional, "",
           "how triangle bases cut a rectangle: in two by a `diagonal` (default), or in `four`")},
      {}};
  return {Either{{{mesh}, {points}, {rectangles}}}};
}

}  // namespace shoreline::keys
