#include <catch2/catch.hpp>

#include "../scattered_points.hpp"
#include "../scenes.hpp"
#include "dense_blocks.hpp"
#include "shoreline/boundary/essential.hpp"
#include "shoreline/engine/effects.hpp"

using namespace shoreline;

namespace {

/// No symmetries but D = Dᵀ.
class Anisotropic final : public Material {
 public:
  explicit Anisotropic(bool constant) : constant_(constant) {}

  [[nodiscard]] std::string name() const override { return "anisotropic"; }
  [[nodiscard]] Stress updated(const Stress& stress, const Vec3& /*strain_increment*/) const override { return stress; }
  [[nodiscard]] Mat3 tangent(const Stress& stress) const override {
    Mat3 tangent;
    tangent << 7.0, 2.0, -1.0, 2.0, 5.0, 0.5, -1.0, 0.5, 3.0;
    return constant_ ? tangent : Mat3((1.0 + stress[0] * stress[0]) * tangent);
  }
  [[nodiscard]] bool constant_tangent() const override { return constant_; }
  [[nodiscard]] double stiffness() const override { return 5.0; }

 private:
  bool constant_;
};

/// Largest differences of the blocks to Σ V Bᵀ D B and −Σ V Bᵀ σ over the points of a cell, over the size of the sums.
struct Difference {
  double stiffness = 0.0;
  double force = 0.0;
};

Difference difference(const Scene& scene, bool constant) {
  const test::Step step(scene);
  const auto law = std::make_shared<Anisotropic>(constant);
  const ElementBlocks blocks = test::blocks_of(*stiffness_of(law), step.state);
  Difference largest;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Index n = step.supports.functions;
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * n);
    for (Index k = step.supports.first[b]; k < step.supports.first[b + 1]; ++k) {
      const Index p = step.supports.point[static_cast<std::size_t>(k)];
      const Stress stress = scene.points.stress.col(p);
      const Eigen::MatrixXd strain =
          strain_operator(scene.basis->support(step.supports.cell[b], scene.points.position.col(p)).gradient);
      stiffness += scene.points.volume[p] * strain.transpose() * law->tangent(stress) * strain;
      force -= scene.points.volume[p] * strain.transpose() * stress.head<3>();
    }
    largest.stiffness =
        std::max(largest.stiffness, (test::block_matrix(blocks, b) - stiffness).norm() / stiffness.norm());
    largest.force = std::max(largest.force, (blocks.force_of(b) - force).norm() / stiffness.norm());
  }
  return largest;
}

}  // namespace

TEST_CASE("stiffness and internal force of a cell are sums over its points, on every basis, for every law",
          "[engine][effects]") {
  test::Random random(7);
  for (const test::NamedGrid& grid : test::every_grid(Vec2(-3.0, 5.0), 2.0, 4))
    for (const int points : {20, 600})  // about 1 and 40 a quadrilateral cell
      for (const bool constant : {true, false}) {
        CAPTURE(grid.name, points, constant);
        Scene scene = test::scattered(grid.grid, points, random);
        const Difference known = difference(scene, constant);
        CHECK(known.stiffness <= 1e-13);
        CHECK(known.force <= 1e-13);
        scene.basis = std::make_unique<test::EvaluatedBasis>(std::move(scene.basis));
        const Difference evaluated = difference(scene, constant);
        CHECK(evaluated.stiffness <= 1e-13);
        CHECK(evaluated.force <= 1e-13);
      }
}
