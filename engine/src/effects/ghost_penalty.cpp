#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "shoreline/bases/derivatives.hpp"
#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

using Jump = Eigen::Matrix<double, 1, Eigen::Dynamic>;

/// The functions of both cells of a face, and the jump of their normal derivatives of order p at points on it.
struct FaceJumps {
  std::vector<Index> functions;
  std::vector<Jump> jump;      ///< a Gauss point: ∂ₙᵖ φ of the cell less that of its neighbour [1/mᵖ]
  std::vector<double> weight;  ///< γ E h^(2p−1) w [N/m²·m^(2p)]: what multiplies jump · jumpᵀ
};

/// Width of the element of a cell along a direction [m].
double width(const Grid& grid, Index cell, const Vec2& direction) {
  const Index first = cell - cell % grid.parts();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (Index part = first; part < first + grid.parts(); ++part)
    for (const Vec2& v : grid.polygon(part)) {
      low = std::min(low, direction.dot(v));
      high = std::max(high, direction.dot(v));
    }
  return high - low;
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
  const double h_power = std::pow(h, 2 * basis.degree() - 1);
  for (Eigen::Index q = 0; q < rule.point.size(); ++q) {
    const Vec2 x = face.a + rule.point[q] * along;
    Jump jump = Jump::Zero(static_cast<Eigen::Index>(jumps.functions.size()));
    for (const auto& [cell, sign] : {std::pair(face.cell, 1.0), std::pair(face.neighbour, -1.0)}) {
      const ShortIndices& functions = cell == face.cell ? here : there;
      const ShortVector derivative = directional_derivative(basis, cell, x, normal, basis.degree());
      for (Eigen::Index a = 0; a < functions.size(); ++a)
        jump[std::ranges::lower_bound(jumps.functions, functions[a]) - jumps.functions.begin()] += sign * derivative[a];
    }
    jumps.jump.push_back(std::move(jump));
    jumps.weight.push_back(scale * h_power * rule.weight[q] * along.norm());
  }
  return jumps;
}

class GhostPenalty final : public Contribution {
 public:
  GhostPenalty(double gamma, std::shared_ptr<const Material> material)
      : gamma_(gamma), material_(std::move(material)) {}

  [[nodiscard]] std::string name() const override { return "ghost_penalty"; }

  void add(const StepState& step, ElementBlocks& blocks) const override {
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
  /// All cells of the elements that the boundary cuts, or that serve one of its segments.
  static std::set<Index> cells_at_boundary(const StepState& step) {
    const Index parts = step.basis.grid().parts();
    std::set<Index> cells;
    const auto insert = [&](Index cell) {
      for (Index part = 0; part < parts; ++part) cells.insert(cell - cell % parts + part);
    };
    for (const Edge& edge : step.edges) {
      for (const Segment& segment : edge.segments) insert(segment.cell);
      std::ranges::for_each(edge.support_cell, insert);
    }
    return cells;
  }

  /// Faces between active cells, of which at least one is at the boundary; each once.
  static std::vector<Face> faces(const StepState& step) {
    std::map<std::pair<Index, Index>, Face> found;
    const auto active = [&](Index cell) { return step.supports.active[static_cast<std::size_t>(cell)] != 0; };
    for (const Index cell : cells_at_boundary(step)) {
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
  std::map<std::pair<Index, Index>, std::vector<Vec2>> carried_;  ///< jump of ∂ₙᵖ u so far, (G.2); residual loading
};

}  // namespace

std::unique_ptr<Contribution> ghost_penalty(double gamma, std::shared_ptr<const Material> material) {
  return std::make_unique<GhostPenalty>(gamma, std::move(material));
}

}  // namespace shoreline
