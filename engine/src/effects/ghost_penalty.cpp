#include <algorithm>
#include <set>

#include "shoreline/bases/error.hpp"
#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

using Jump = Eigen::Matrix<double, 1, Eigen::Dynamic>;

/// The functions of both cells of a face, and the jump of their normal derivatives at points on it.
struct FaceJumps {
  std::vector<Index> functions;
  std::vector<Jump> jump;      ///< a Gauss point: ∂_n φ of the cell less that of its neighbour [1/m]
  std::vector<double> weight;  ///< γ E h w [N/m²·m²]: what multiplies jump · jumpᵀ
};

/// Width of a cell along a direction [m].
double width(const Grid& grid, Index cell, const Vec2& direction) {
  const auto along = [&](const Vec2& v) { return direction.dot(v); };
  const std::vector<Vec2> polygon = grid.polygon(cell);
  const auto [low, high] = std::ranges::minmax(polygon, {}, along);
  return along(high) - along(low);
}

FaceJumps face_jumps(const Basis& basis, const Face& face, double scale) {
  FaceJumps jumps;
  const ShortIndices here = basis.functions_of(face.cell);
  const ShortIndices there = basis.functions_of(face.neighbour);
  jumps.functions.assign(here.begin(), here.end());
  jumps.functions.insert(jumps.functions.end(), there.begin(), there.end());
  std::ranges::sort(jumps.functions);
  jumps.functions.erase(std::ranges::unique(jumps.functions).begin(), jumps.functions.end());

  const Vec2 along = face.b - face.a;
  const Vec2 normal = Vec2(along.y(), -along.x()).normalized();
  const double h = width(basis.grid(), face.cell, normal);
  const QuadratureRule rule = gauss(basis.degree() + 1);
  for (Eigen::Index q = 0; q < rule.point.size(); ++q) {
    const Vec2 x = face.a + rule.point[q] * along;
    Jump jump = Jump::Zero(static_cast<Eigen::Index>(jumps.functions.size()));
    for (const auto& [cell, sign] : {std::pair(face.cell, 1.0), std::pair(face.neighbour, -1.0)}) {
      const Support support = basis.support(cell, x);
      for (Eigen::Index a = 0; a < support.function.size(); ++a)
        jump[std::ranges::lower_bound(jumps.functions, support.function[a]) - jumps.functions.begin()] +=
            sign * normal.dot(support.gradient.col(a));
    }
    jumps.jump.push_back(std::move(jump));
    jumps.weight.push_back(scale * h * rule.weight[q] * along.norm());
  }
  return jumps;
}

class GhostPenalty final : public Contribution {
 public:
  GhostPenalty(double gamma, std::shared_ptr<const Material> material)
      : gamma_(gamma), material_(std::move(material)) {}

  [[nodiscard]] std::string name() const override { return "ghost_penalty"; }

  void add(const StepState& step, ElementBlocks& blocks) const override {
    if (step.basis.continuity() != 0 || step.basis.degree() != 1)
      throw InvalidArgument("ghost_penalty: made for continuous bases of degree 1");
    for (const Face& face : faces(step)) {
      const FaceJumps jumps = face_jumps(step.basis, face, gamma_ * material_->stiffness());
      const std::size_t block = blocks.append(jumps.functions);
      const auto n = static_cast<Eigen::Index>(jumps.functions.size());
      Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * n, 2 * n);
      const auto carried = carried_.find({face.cell, face.neighbour});
      for (std::size_t q = 0; q < jumps.jump.size(); ++q) {
        const Eigen::MatrixXd squared = jumps.weight[q] * jumps.jump[q].transpose() * jumps.jump[q];
        for (Eigen::Index a = 0; a < n; ++a) {
          for (Eigen::Index b = 0; b < n; ++b) stiffness.block<2, 2>(2 * a, 2 * b).diagonal().array() += squared(a, b);
          if (carried != carried_.end())
            blocks.force_of(block).segment<2>(2 * a) -= jumps.weight[q] * jumps.jump[q][a] * carried->second[q];
        }
      }
      blocks.add(block, stiffness);
    }
  }

  void accept(const StepState& step, const Eigen::Matrix2Xd& increment) override {
    if (step.loading == Loading::incremental) return;
    for (const Face& face : faces(step)) {
      const FaceJumps jumps = face_jumps(step.basis, face, 1.0);
      auto& carried = carried_[{face.cell, face.neighbour}];
      carried.resize(jumps.jump.size(), Vec2::Zero());
      for (std::size_t q = 0; q < jumps.jump.size(); ++q)
        for (std::size_t a = 0; a < jumps.functions.size(); ++a)
          carried[q] += jumps.jump[q][static_cast<Eigen::Index>(a)] * increment.col(jumps.functions[a]);
    }
  }

 private:
  /// Faces between active cells, at least one of which the boundary cuts or is served by; each once.
  static std::vector<Face> faces(const StepState& step) {
    std::set<Index> at_boundary;
    for (const Edge& edge : step.edges) {
      for (const Segment& segment : edge.segments) at_boundary.insert(segment.cell);
      at_boundary.insert(edge.support_cell.begin(), edge.support_cell.end());
    }
    std::map<std::pair<Index, Index>, Face> found;
    const auto active = [&](Index cell) { return step.supports.active[static_cast<std::size_t>(cell)] != 0; };
    for (const Index cell : at_boundary) {
      if (!active(cell)) continue;
      for (Face face : step.basis.grid().faces(cell)) {
        if (!active(face.neighbour)) continue;
        if (face.cell > face.neighbour) face = {face.neighbour, face.cell, face.b, face.a};
        found.emplace(std::pair(face.cell, face.neighbour), face);
      }
    }
    std::vector<Face> faces;
    for (const auto& [cells, face] : found) faces.push_back(face);
    return faces;
  }

  double gamma_;
  std::shared_ptr<const Material> material_;
  std::map<std::pair<Index, Index>, std::vector<Vec2>> carried_;  ///< jump of ∂_n u so far, (G.2); residual loading
};

}  // namespace

std::unique_ptr<Contribution> ghost_penalty(double gamma, std::shared_ptr<const Material> material) {
  return std::make_unique<GhostPenalty>(gamma, std::move(material));
}

}  // namespace shoreline
