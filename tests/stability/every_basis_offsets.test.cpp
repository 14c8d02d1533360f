// On every basis: where the grid lies must matter neither for the error nor for the condition.
#include <algorithm>
#include <catch2/catch.hpp>

#include "../engine/dense_blocks.hpp"
#include "../plate_on_basis.hpp"
#include "shoreline/engine/effects.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;

namespace {

constexpr double h = 0.125;
constexpr double chord = 0.005;

double largest_to_median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.back() / values[values.size() / 2];
}

/// The ghost penalty without the faces between parts of one element.
class WithoutSpokes final : public Contribution {
 public:
  explicit WithoutSpokes(const Scene& scene, double gamma) : whole_(ghost_penalty(gamma, scene.material)) {}

  [[nodiscard]] std::string name() const override { return "ghost_penalty"; }
  [[nodiscard]] std::string needs() const override { return "derivatives across faces"; }

  void add(const StepState& step, ElementBlocks& blocks) const override {
    ElementBlocks whole;
    whole_->add(step, whole);
    for (std::size_t b = 0; b < whole.size(); ++b) {
      if (whole.functions_in(b) == step.basis.functions_per_cell()) continue;  // both sides see the same functions
      const auto first = whole.function.begin() + whole.first[b];
      blocks.add(blocks.append(std::vector<Index>(first, first + whole.functions_in(b))), test::block_matrix(whole, b));
    }
  }

 private:
  std::unique_ptr<Contribution> whole_;
};

}  // namespace

TEST_CASE("on every basis Nitsche's method is definite wherever the grid lies, at the basis's own band and penalty",
          "[stability][every_basis]") {
  for (const auto& [name, grid] : test::every_grid({0.0, 0.0}, 1.0, 1)) {
    if (grid.mesh) continue;
    test::Random random(11);
    std::vector<double> error, condition;
    for (int draw = 0; draw < 5; ++draw) {
      const Vec2 shift = random.vector(0.0, 1.0);
      CAPTURE(name, shift.transpose());
      Scene scene = build_scene(test::plate_on("plate_with_hole/neumann.json", grid, h, chord, shift));
      const test::PlateResult result = test::compute(scene, true);
      CHECK(result.record.warnings.empty());
      error.push_back(result.displacement);
      condition.push_back(result.record.condition_estimate.value());
    }
    CAPTURE(name, error, condition);
    CHECK(largest_to_median(error) <= 1.3);
    CHECK(largest_to_median(condition) <= 1.8);
  }
}

TEST_CASE("without the spokes of cut Powell-Sabin triangles every place of the grid is singular",
          "[stability][every_basis]") {
  Case::Grid grid;
  grid.basis = Case::BasisType::powell_sabin;
  test::Random random(12);
  for (int draw = 0; draw < 5; ++draw) {
    Case problem = test::plate_on("plate_with_hole/neumann.json", grid, h, chord, random.vector(0.0, 1.0));
    const double gamma = std::exchange(problem.ghost, 0.0);
    Scene scene = build_scene(problem);
    scene.contributions.push_back(std::make_unique<WithoutSpokes>(scene, gamma));
    RunRecord record;
    bool singular = false;
    try {
      run_load_steps(scene, {}, record);
      singular = std::ranges::any_of(record.warnings,
                                     [](const std::string& w) { return w.find("singular") != std::string::npos; });
    } catch (const ComputationError&) {
      singular = true;
    }
    CHECK(singular);
  }
}
