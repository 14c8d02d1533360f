#pragma once
// Points anywhere on a grid, and a basis that tells less than it knows.

#include "every_grid.hpp"
#include "random.hpp"
#include "shoreline/engine/scene.hpp"

namespace shoreline::test {

/// Points anywhere on a grid, also along its border, with random volumes and under random stresses.
inline Scene scattered(const Case::Grid& grid, int count, Random& random) {
  Case problem;
  problem.material = {.youngs_modulus = 1.0, .poissons_ratio = 0.0, .density = {}};
  problem.grid = grid;
  std::vector<Case::ListedPoint> points;
  for (int p = 0; p < count; ++p) points.push_back({random.in({grid.lower, grid.upper}), random.uniform(0.1, 1.0)});
  problem.material_points = points;
  Scene scene = build_scene(problem);
  for (double& s : scene.points.stress.reshaped()) s = random.uniform(-1.0, 1.0);
  return scene;
}

/// A basis as a code downstream may bring it: evaluated at points, and nothing known of its gradients.
class EvaluatedBasis final : public Basis {
 public:
  explicit EvaluatedBasis(std::unique_ptr<const Basis> basis) : basis_(std::move(basis)) {}

  [[nodiscard]] const Grid& grid() const override { return basis_->grid(); }
  [[nodiscard]] Index functions() const override { return basis_->functions(); }
  [[nodiscard]] int functions_per_cell() const override { return basis_->functions_per_cell(); }
  [[nodiscard]] int degree() const override { return basis_->degree(); }
  [[nodiscard]] int continuity() const override { return basis_->continuity(); }
  [[nodiscard]] int gradient_degree() const override { return 2 * degree(); }
  [[nodiscard]] ShortIndices functions_of(Index cell) const override { return basis_->functions_of(cell); }
  [[nodiscard]] Vec2 control_point(Index function) const override { return basis_->control_point(function); }
  void evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const override {
    basis_->evaluate(cell, x, value, gradient);
  }
  void evaluate(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const override {
    basis_->evaluate(cell, x, value, gradient);
  }
  [[nodiscard]] ShortCurvatures curvatures(Index cell, const Vec2& x) const override {
    return basis_->curvatures(cell, x);
  }

 private:
  std::unique_ptr<const Basis> basis_;
};

}  // namespace shoreline::test
