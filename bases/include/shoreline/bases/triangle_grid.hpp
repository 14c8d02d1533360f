#pragma once
// A background grid whose cells are the triangles of a mesh.

#include <array>

#include "shoreline/bases/grid.hpp"
#include "shoreline/bases/triangle_mesh.hpp"

namespace shoreline {

/// Cells are the triangles of a mesh, with their numbers. Any outline: holes and re-entrant corners are outside.
class TriangleGrid final : public Grid {
 public:
  /// @param parts  triangles t with the same t / parts are the parts of one main triangle, whose size theirs is
  /// @throws MeshError by check(mesh); angles are checked where triangles are main triangles (parts = 1)
  /// @throws InvalidArgument unless parts is positive and divides the number of triangles
  explicit TriangleGrid(TriangleMesh mesh, int parts = 1);

  [[nodiscard]] Index cells() const override { return static_cast<Index>(mesh_.triangle.size()); }
  [[nodiscard]] int parts() const override { return static_cast<int>(parts_); }
  [[nodiscard]] Box bounds() const override { return bounds_; }
  [[nodiscard]] std::optional<Index> locate(const Vec2& x, Index hint) const override;
  [[nodiscard]] bool holds_all(Index cell, std::span<const LanePoint> x) const override;
  [[nodiscard]] std::vector<Vec2> polygon(Index cell) const override;
  /// √(2 · area) of the main triangle [m].
  [[nodiscard]] double size(Index cell) const override { return size_[static_cast<std::size_t>(cell / parts_)]; }
  [[nodiscard]] std::vector<Line> lines_near(const Box& box) const override;
  [[nodiscard]] std::vector<Face> faces(Index cell) const override;

  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }

 private:
  /// Which cells come near which bin of a regular raster over the bounds, in compressed rows.
  struct Bins {
    Vec2 lower;  ///< [m]
    Vec2 width;  ///< [m]
    std::array<Index, 2> count;
    std::vector<Index> first;  ///< bin b has cell[first[b]] … cell[first[b + 1] − 1]
    std::vector<Index> cell;
  };
  void number_lines();
  void sort_into_bins();
  /// Twice the area with a side below which a hint must not decide: so near to an edge [m²].
  [[nodiscard]] double clear(Index cell) const { return 1e-12 * size(cell) * size(cell); }
  [[nodiscard]] std::array<Index, 4> bins_of(const Box& box) const;

  TriangleMesh mesh_;
  Index parts_;
  Box bounds_;
  std::vector<double> size_;                     ///< one a main triangle [m]
  std::vector<std::array<Index, 3>> neighbour_;  ///< across the edge from vertex k to vertex k + 1; −1: border
  std::vector<Line> lines_;                      ///< each line once, parallel ones together
  std::vector<std::array<Index, 3>> line_of_;    ///< number of the line of each edge
  Bins bins_;
};

}  // namespace shoreline
