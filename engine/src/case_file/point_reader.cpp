#include "point_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "../make_basis.hpp"
#include "grid_reader.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"

namespace shoreline {
namespace {

std::vector<Case::ListedPoint> read_listed_points(const Node& node) {
  if (node["points"].size() != node["volumes"].size())
    node["volumes"].place.fail(fmt::format("found {} volumes, expected one for each of {} points",
                                           node["volumes"].size(), node["points"].size()));
  std::vector<Case::ListedPoint> points;
  for (std::size_t i = 0; i < node["points"].size(); ++i)
    points.push_back({node["points"].entry(i).vector(), node["volumes"].entry(i).as<double>()});
  return points;
}

VolumeRule read_volumes(const Node& node) {
  if (node.is("lattice")) return VolumeRule::lattice;
  return node.is("equal") ? VolumeRule::equal : VolumeRule::clipped;
}

/// Refuses more points than a machine holds.
/// @param points  that there may be
void check_count(const Node& node, double points) {
  constexpr double most = 1e9;
  if (points > most)
    node.place.fail(fmt::format("found {}, up to {:.3g} points, expected at most {:g}; take fewer, or larger cells",
                                node.value.dump(), points, most));
}

LatticeFill read_lattice(const Node& node, const Case::Grid& grid) {
  const auto per_cell = pair_of<int>(node["per_cell"]);
  if (has_triangles(grid.basis) && per_cell[0] != per_cell[1])
    node["per_cell"].place.fail(fmt::format("found {}, expected one number: triangles are cut alike in all directions",
                                            node["per_cell"].value.dump()));
  const double half = std::ceil(0.5 * per_cell[0]);  // of a side, on each part of a Powell-Sabin triangle
  const bool parts = grid.basis == Case::BasisType::powell_sabin;
  check_count(node["per_cell"],
              cells_to_fill(grid) * (parts ? powell_sabin_parts * half * half : 1.0 * per_cell[0] * per_cell[1]));
  return {per_cell, node["volumes"].is("fitted") ? VolumeRule::fitted : read_volumes(node["volumes"])};
}

BlockFill read_block(const Node& node, const Case::Grid& grid) {
  if (grid.mesh)
    node["per_block"].place.fail(
        "found points per block on a mesh, which has no rectangles; expected \"per_cell\" or \"across\"");
  const auto per_block = pair_of<int>(node["per_block"]);
  check_count(node["per_block"], rectangles_of(grid).prod() * per_block[0] * per_block[1]);
  return {per_block, read_volumes(node["volumes"])};
}

std::array<int, 2> read_across(const Node& node) {
  const auto across = pair_of<int>(node);
  check_count(node, 1.0 * across[0] * across[1]);
  return across;
}

VertexFill read_vertex(const Node& node, const Case::Grid& grid) {
  const bool across = node.has("across");
  const auto count = pair_of<int>(node[across ? "across" : "per_cell"]);
  if (!across && grid.mesh)
    node["per_cell"].place.fail(
        "found points per cell on a mesh without rectangles, which has no cell size; expected \"across\"");
  check_count(node[across ? "across" : "per_cell"], (across ? 1.0 : rectangles_of(grid).prod()) * count[0] * count[1]);
  return {count, across, read_volumes(node["volumes"])};
}

RandomFill read_random(const Node& node, const Case::Grid& grid) {
  const RandomFill fill{
      .per_element = node["per_cell"].as<int>(),
      .seed = node["seed"].as<int>(),
      .volumes = node["volumes"].is("equal") ? RandomFill::Volumes::equal : RandomFill::Volumes::voronoi,
  };
  check_count(node["per_cell"], cells_to_fill(grid) * fill.per_element);
  return fill;
}

}  // namespace

Case::MaterialPoints read_material_points(const Node& node, const Case::Grid& grid) {
  if (node.has("points")) return read_listed_points(node);
  if (node["fill"].is("vertex")) return read_vertex(node, grid);
  if (node["fill"].is("random")) return read_random(node, grid);
  if (node["fill"].is("polar"))
    return PolarFill{node["centre"].vector(), read_across(node["across"]), read_volumes(node["volumes"])};
  if (node.has("per_block")) return read_block(node, grid);
  if (node.has("across")) return AcrossFill{read_across(node["across"]), read_volumes(node["volumes"])};
  return read_lattice(node, grid);
}

}  // namespace shoreline
