// The interface that downstream codes extend: a law of one's own serves like a built-in one.
#include "shoreline/engine/material.hpp"

#include <catch2/catch.hpp>

#include "../scenes.hpp"
#include "shoreline/engine/effects.hpp"

using namespace shoreline;

namespace {

/// Linear elasticity that does not tell that its tangent is constant, and counts.
class Downstream : public Material {
 public:
  [[nodiscard]] std::string name() const override { return "downstream"; }
  [[nodiscard]] Stress updated(const Stress& stress, const Vec3& strain_increment) const override {
    return law_.updated(stress, strain_increment);
  }
  [[nodiscard]] Mat3 tangent(const Stress& stress) const override { return law_.tangent(stress); }
  [[nodiscard]] double stiffness() const override { return law_.stiffness(); }

 private:
  LinearElastic law_{1e6, 0.25, Plane::strain};
};

/// Stiffer where it is compressed.
class Stiffening final : public Downstream {
 public:
  [[nodiscard]] Mat3 tangent(const Stress& stress) const override {
    return (1.0 - stress[1]) * Downstream::tangent(stress);
  }
};

ElementBlocks stiffness_blocks(const Scene& scene, std::shared_ptr<const Material> material) {
  const test::Step step(scene);
  ElementBlocks blocks;
  stiffness_of(std::move(material))->add(step.state, blocks);
  return blocks;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  using Array = Eigen::Map<const Eigen::VectorXd>;
  const auto n = static_cast<Eigen::Index>(a.size());
  return (Array(a.data(), n) - Array(b.data(), n)).norm() / Array(b.data(), n).norm();
}

}  // namespace

TEST_CASE("a law says by default that its tangent may change", "[engine][material]") {
  CHECK_FALSE(Downstream().constant_tangent());
}

TEST_CASE("stiffness summed point by point is that summed cell by cell", "[engine][material]") {
  const Scene scene = test::compression_square({.angle = 0.7, .cells = 5, .per_cell = 3});
  const ElementBlocks by_point = stiffness_blocks(scene, std::make_shared<Downstream>());
  const ElementBlocks by_cell = stiffness_blocks(scene, scene.material);
  CHECK(by_point.function == by_cell.function);
  CHECK(difference(by_point.matrix, by_cell.matrix) < 1e-14);
}

TEST_CASE("a tangent that depends on stress is taken at each point's own", "[engine][material]") {
  Scene scene = test::compression_square({.angle = 0.7, .cells = 5, .per_cell = 3});
  for (Index p = 0; p < scene.points.size(); ++p) scene.points.stress(1, p) = -(p % 7);
  Scene weighted = test::compression_square({.angle = 0.7, .cells = 5, .per_cell = 3});
  for (Index p = 0; p < scene.points.size(); ++p) weighted.points.volume[p] *= 1.0 + (p % 7);
  const ElementBlocks stiffening = stiffness_blocks(scene, std::make_shared<Stiffening>());
  const ElementBlocks expected = stiffness_blocks(weighted, weighted.material);
  CHECK(difference(stiffening.matrix, expected.matrix) < 1e-14);
}

TEST_CASE("a run with a law of one's own moves as with the built-in one, under its own name", "[engine][material]") {
  Scene built_in = test::compression_square({.angle = 0.3, .cells = 4});
  Scene own = test::compression_square({.angle = 0.3, .cells = 4});
  own.material = std::make_shared<Downstream>();
  own.contributions.front() = stiffness_of(own.material);
  RunRecord record;
  run_load_steps(built_in, {}, record);
  RunRecord own_record;
  run_load_steps(own, {}, own_record);
  CHECK((own.points.displacement - built_in.points.displacement).norm() <= 1e-10 * built_in.points.displacement.norm());
  CHECK(own_record.effects.entries().front().name == "downstream");
}
