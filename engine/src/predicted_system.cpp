#include "predicted_system.hpp"

#include "ghost_faces.hpp"
#include "shoreline/boundary/edge.hpp"
#include "solver/band_order.hpp"

namespace shoreline {
namespace {

/// Functions that some effect couples, cell by cell and face by face.
std::vector<std::vector<Index>> coupled_functions(const Scene& scene, const PointSupports& supports, bool ghost) {
  std::vector<std::vector<Index>> groups;
  const auto add = [&](std::vector<Index>& group, Index cell) {
    for (const Index f : scene.basis->functions_of(cell)) group.push_back(f);
  };
  for (const Index cell : supports.cell) add(groups.emplace_back(), cell);
  if (!ghost) return groups;
  std::vector<Edge> edges;
  for (const BoundaryPiece& b : scene.boundary)
    edges.push_back(make_edge(b.piece, scene.basis->grid(), supports.active, gauss(1)));
  for (const Face& face : faces_at_boundary(scene.basis->grid(), supports.active, edges)) {
    std::vector<Index>& group = groups.emplace_back();
    add(group, face.cell);
    add(group, face.neighbour);
  }
  return groups;
}

}  // namespace

SystemSize predicted_size(const Scene& scene, const PointSupports& supports, bool ghost) {
  const std::vector<std::vector<Index>> groups = coupled_functions(scene, supports, ghost);
  std::vector<Index> number(static_cast<std::size_t>(scene.basis->functions()), -1);
  for (const std::vector<Index>& group : groups)
    for (const Index f : group) number[static_cast<std::size_t>(f)] = 0;
  Index functions = 0;
  for (Index& n : number)
    if (n == 0) n = functions++;
  Unknowns unknowns{Eigen::Matrix2Xd(2, 2 * functions), Eigen::VectorXi(2 * functions),
                    scene.basis->functions_per_cell()};
  for (Index f = 0; f < scene.basis->functions(); ++f)
    if (const Index n = number[static_cast<std::size_t>(f)]; n >= 0)
      for (const int c : {0, 1}) {
        unknowns.place.col(2 * n + c) = scene.basis->control_point(f);
        unknowns.component[2 * n + c] = c;
      }
  const BandOrder order = narrowest_order(unknowns, [&](auto&& use) {
    for (const std::vector<Index>& group : groups)
      for (const Index a : group)
        for (const Index b : group)
          for (const Index c : {0, 1})
            use(2 * number[static_cast<std::size_t>(a)] + c, 2 * number[static_cast<std::size_t>(b)] + 1 - c);
  });
  return {.unknowns = 2 * functions, .width = order.width, .functions_per_cell = scene.basis->functions_per_cell()};
}

}  // namespace shoreline
