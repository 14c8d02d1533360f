#include "key_rows.hpp"
#include "shoreline/engine/fill.hpp"

namespace shoreline::keys {
namespace {

Key volumes(std::vector<std::string> rules, std::string meaning) {
  return key("volumes", {Choice{std::move(rules)}}, otherwise("clipped"), "", std::move(meaning));
}

}  // namespace

Schema material_points() {
  const Key per_cell =
      key("per_cell", one_or_pair({Integer{1, 1000}}), optional, "", "sub-cells in each direction of a cell");
  const Schema layers = several(2, {Integer{2, 1000000}});
  const Object listed{
      {key("points", list(position(), 1, many), required, "m", "positions"),
       key("volumes", list(positive_number(), 1, many), required, "m³ per metre of thickness", "one a point")},
      {}};
  const Object lattice{
      {per_cell,
       key("per_block", one_or_pair({Integer{1, 1000}}), optional, "",
           "sub-cells in each direction of a rectangle of the grid, however triangles cut it; not on a mesh"),
       key("across", several(2, {Integer{1, 1000000}}), optional, "",
           "sub-cells from side to side of the body's bounding box in x and y, whatever the grid"),
       volumes({"clipped", "lattice", "equal", "fitted"},
               "`clipped`: a point at the centroid of each sub-cell's part inside the outline, "
               "with its area; `lattice`: at its centre, with the whole sub-cell; `equal`: there, "
               "each with the same share of the body; `fitted`: as `clipped`, with weights that are fitted to the "
               "outline at every step")},
      {"per_cell", "per_block", "across"}};
  const Object vertex{
      {per_cell, key("across", layers, optional, "", "points from side to side in x and y, both outer layers included"),
       volumes({"clipped", "lattice", "equal"},
               "`clipped`: the part of a point's sub-cell inside the outline (halves on edges, quarters at corners); "
               "`lattice`: the whole sub-cell; `equal`: the same share of the body for each")},
      {"per_cell", "across"}};
  const Object polar{
      {key("across", layers, required, "", "points along the radius and along the angle, both outer layers included"),
       key("centre", position(), otherwise(Json::array({0, 0})), "m", "of the ring or sector that the outline bounds"),
       volumes({"clipped", "equal"},
               "`clipped`: a point's own sector of the ring, halved at the outer layers; `equal`: "
               "the same share of the body for each")},
      {}};
  const Object random{
      {key("per_cell", {Integer{1, 1000}}, required, "",
           "points in a rectangle or triangle within the body; in proportion to what it covers, at least one, of "
           "others"),
       key("seed", {Integer{0, std::numeric_limits<int>::max()}}, otherwise(RandomFill{}.seed), "",
           "other seeds give other points; the same one gives the same on every machine"),
       key("volumes", {Choice{{"voronoi", "equal", "fitted"}}}, otherwise("voronoi"), "",
           "`voronoi`: the part of the body that is nearer to a point than to all others; `equal`: the same share of "
           "the body for each; `fitted`: as `voronoi`, with weights that are fitted to the outline at every step")},
      {}};
  const Tagged fills{
      {{"lattice", lattice}, {"vertex", vertex}, {"polar", polar}, {"random", random}}, "fill", "lattice"};
  return {Either{{{listed}, {fills}}}};
}

}  // namespace shoreline::keys
