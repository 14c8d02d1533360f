#include "shoreline/engine/strain_energy.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "../every_grid.hpp"
#include "../scenes.hpp"
#include "shoreline/engine/defaults.hpp"

using namespace shoreline;
using Catch::Matchers::WithinRel;

namespace {

/// Adds nothing: ∫ t · Δu over a piece under a dead traction, in one step from rest [J per metre].
class Work final : public Contribution {
 public:
  Work(std::size_t piece, std::function<Vec2(const Vec2&)> traction, double& work)
      : piece_(piece), traction_(std::move(traction)), work_(&work) {}
  [[nodiscard]] std::string name() const override { return "work"; }
  [[nodiscard]] std::string needs() const override { return "values at the material points"; }
  void add(const StepState& /*step*/, ElementBlocks& /*blocks*/) const override {}
  void accept(const StepState& step, const Eigen::Matrix2Xd& increment) override {
    const Edge& edge = step.edges[piece_];
    for (std::size_t k = 0; k < edge.points.size(); ++k) {
      const BoundaryPoint& p = edge.points[k];
      const Support support = step.basis.support(edge.support_cell[edge.segment_of(k)], p.x);
      *work_ += p.weight * traction_(p.x).dot(support.interpolate(increment));
    }
  }

 private:
  std::size_t piece_;
  std::function<Vec2(const Vec2&)> traction_;
  double* work_;
};

struct Energies {
  double stored;
  double half_work;
  [[nodiscard]] double difference() const { return std::abs(stored - half_work) / half_work; }
};

/// A square held on its bottom and left sides by rollers, under a traction on its top and none on its right.
/// @param bend  whether the traction varies along the top
Energies pressed(const Case::Grid& grid, double ghost, const test::CompressionSquare& square, bool bend) {
  Case problem = test::compression_case(square);
  problem.grid = grid;
  problem.ghost = ghost;
  std::vector<Vec2> corners;
  for (const Case::Boundary& side : problem.boundaries) corners.push_back(side.piece.points.front());
  problem.material_points = test::patch_points(grid, corners);
  problem.boundaries[1].condition = Case::Free{};
  const auto text = bend ? "-1e3*(1 + 2*x*x)" : "-1e3";
  problem.boundaries[2].condition = Case::Traction{std::array{Quantity(0.0), Quantity(Expression(text))}};
  Scene scene = build_scene(problem);
  double work = 0.0;
  const auto traction = [bend](const Vec2& x) { return Vec2(0.0, bend ? -1e3 * (1.0 + 2.0 * x.x() * x.x()) : -1e3); };
  scene.contributions.push_back(std::make_unique<Work>(2, traction, work));
  RunRecord record;
  run_load_steps(scene, {}, record);
  return {strain_energy(scene.points), 0.5 * work};
}

}  // namespace

TEST_CASE("strain energy of listed states is the sum of V σ:ε/2 with engineering shear", "[engine][strain_energy]") {
  MaterialPoints points = points_at(Eigen::Matrix2Xd::Zero(2, 2), Eigen::Vector2d(2.0, 3.0));
  points.strain = Eigen::Matrix3Xd::Zero(3, 2);
  CHECK(strain_energy(points) == 0.0);
  points.stress.col(0) = Stress(4.0, 1.0, 2.0, 100.0);
  points.strain.col(0) = Vec3(0.5, -1.0, 0.25);
  points.stress.col(1) = Stress(0.0, 0.0, 8.0, 0.0);
  points.strain.col(1) = Vec3(1.0, 1.0, 0.125);
  CHECK_THAT(strain_energy(points), WithinRel(2.0 * 0.5 * (2.0 - 1.0 + 0.5) + 3.0 * 0.5 * 1.0, 1e-15));
}

TEST_CASE("Clapeyron: a body held on grid lines stores half the work of its loads on every basis",
          "[engine][strain_energy]") {
  for (const auto& [name, grid] : test::every_grid({-0.5, -0.5}, 1.0, 5)) {
    CAPTURE(name);
    const Energies energy = pressed(grid, 0.0, {.side = 1.0, .cells = 5, .method = EssentialMethod::grid}, true);
    CHECK(energy.half_work > 0.0);
    CHECK_THAT(energy.stored, WithinRel(energy.half_work, 1e-10));
  }
}

TEST_CASE("Clapeyron: a patch held by Nitsche's method stores half the work of its load", "[engine][strain_energy]") {
  for (const auto& [name, grid] : test::every_grid({-1.0, -1.0}, 2.0, 9)) {
    CAPTURE(name);
    const test::CompressionSquare square{
        .shift = Vec2(0.03, -0.02), .side = 1.0, .band = nitsche_band(grid.basis), .method = EssentialMethod::nitsche};
    const Energies energy = pressed(grid, ghost_for_nitsche(grid.basis, grid.degree), square, false);
    CHECK_THAT(energy.stored, WithinRel(energy.half_work, 1e-10));
    const double strain_energy_density = 0.5 * 1e3 * 1e3 * (1.0 - 0.25 * 0.25) / 1e6;  // σ²(1 − ν²)/(2E)
    CHECK_THAT(energy.stored, WithinRel(strain_energy_density, 1e-10));
  }
}

TEST_CASE("Clapeyron: in a bent body off the grid lines the difference falls with the accuracy of the method",
          "[engine][strain_energy]") {
  const auto difference = [](int degree, Index cells) {
    Case::Grid grid = test::every_grid({-1.0, -1.0}, 2.0, cells).back().grid;
    grid.degree = degree;
    const test::CompressionSquare square{.angle = 0.0,
                                         .shift = Vec2(0.03, -0.02),
                                         .side = 1.0,
                                         .band = nitsche_band(grid.basis),
                                         .method = EssentialMethod::nitsche};
    return pressed(grid, ghost_for_nitsche(grid.basis, degree), square, true).difference();
  };
  const std::array<double, 3> bound{1e-6, 2e-7, 1e-8};
  const std::array<double, 3> rate{1.9, 3.4, 3.4};  // the displacement is no smoother than its corners
  for (const int degree : {1, 2, 3}) {
    const auto k = static_cast<std::size_t>(degree - 1);
    const double fine = difference(degree, 36);
    CHECK(fine <= bound[k]);
    CHECK(0.5 * std::log2(difference(degree, 9) / fine) >= rate[k]);
  }
}
