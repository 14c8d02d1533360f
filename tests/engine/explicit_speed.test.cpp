// What makes time steps fast changes no result.

#include <omp.h>

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "../../engine/src/dynamics/time_step.hpp"
#include "../../engine/src/point_cells.hpp"
#include "../../engine/src/threads.hpp"
#include "../every_grid.hpp"
#include "../random.hpp"

using namespace shoreline;

namespace {

/// A basis with points anywhere on it, none to forty in a cell, and what moves with them.
struct Swarm {
  std::unique_ptr<const Basis> basis;
  MaterialPoints points;
  PointMotion motion;
  std::vector<Index> cell;
  PointCells cells;
  ElementTable table;

  Swarm(std::unique_ptr<const Basis> of, Index count, test::Random& random) : basis(std::move(of)), table(*basis) {
    Eigen::Matrix2Xd position(2, count);
    Eigen::VectorXd volume(count);
    for (Index p = 0; p < count; ++p) {
      do position.col(p) = random.in(basis->grid().bounds());
      while (position.col(p).squaredNorm() > 0.8 && random.whole(0, 9) > 0);
      volume[p] = random.uniform(0.1, 1.0);
    }
    points = points_at(position, volume);
    points.stress.setRandom();
    motion = motion_at_rest(points, 2.0);
    motion.velocity.setRandom();
    cell = cells_of(*basis, points);
    group_points(cell, basis->grid(), cells.supports);
    static_cast<void>(cells.occupied.find(table, cells.supports.cell));
  }

  [[nodiscard]] Support support(Index p) const {
    return basis->support(cell[static_cast<std::size_t>(p)], points.position.col(p));
  }
};

template <class Check>
void for_swarms(Check&& check) {
  test::Random random(11);
  for (const test::NamedGrid& named : test::every_grid(Vec2(-1.0, -1.0), 2.0, 5))
    for (const Index count : {1, 2, 7, 150}) {
      INFO(named.name << ", " << count << " points");
      Swarm swarm(test::basis_of(named.grid), count, random);
      check(swarm, random);
    }
}

/// State after a few steps of a block that slides over its grid.
struct After {
  MaterialPoints points;
  PointMotion motion;
};

After slide(Case::BasisType basis, MassForm mass, int threads) {
  omp_set_num_threads(threads);
  constexpr int cells = 60;
  Case problem;
  problem.material = {Case::Law::linear_large, 1.0, 0.2, 1.0};
  problem.grid = {.lower = Vec2::Zero(), .upper = Vec2::Ones(), .cell_size = Vec2::Constant(1.0 / cells)};
  problem.grid.basis = basis;
  const double low = 0.1;
  const double high = 0.9;
  problem.boundaries = {{{.name = "outline",
                          .points = {{low, low}, {high, low}, {high, high}, {low, high}},
                          .corners = {0, 1, 2, 3},
                          .closed = true},
                         Case::Free{}}};
  const int per_cell = basis == Case::BasisType::linear ? 3 : 4;
  problem.material_points = LatticeFill{{per_cell, per_cell}, VolumeRule::clipped};
  problem.analysis = ExplicitDynamics{.time_step = 1e-3, .end_time = 4e-3, .mass = mass};
  problem.initial_velocity = {Expression("3*sin(5*X)"), Expression("2 + cos(3*Y)")};
  DynamicScene scene = build_dynamic_scene(problem);
  REQUIRE(worth_threads(static_cast<std::size_t>(scene.body.points.size())));
  TimeStep step(scene);
  DynamicRecord record;
  for (int k = 0; k < 4; ++k) {
    step.begin(1e-3 * k, 1e-3, record);
    step.finish(1e-3 * k, 1e-3, false, record);
  }
  return {std::move(scene.body.points), std::move(scene.motion)};
}

}  // namespace

TEST_CASE("a basis at four points side by side is the basis at each of them, with gradients and without",
          "[engine][speed]") {
  for_swarms([](const Swarm& swarm, test::Random&) {
    const auto n = static_cast<std::size_t>(swarm.basis->functions_per_cell());
    for (Index p = 0; p + 3 < swarm.points.size(); p += 4) {
      const Index cell = swarm.cell[static_cast<std::size_t>(p)];
      std::array<Vec2, lanes> x;
      std::array<LanePoint, 1> four;
      for (std::size_t l = 0; l < lanes; ++l) {
        x[l] = swarm.points.position.col(p + static_cast<Index>(l));
        four[0][0][l] = x[l].x();
        four[0][1][l] = x[l].y();
      }
      std::vector<double> one(lanes * n), slope(lanes * 2 * n), alone(lanes * n);
      std::vector<Lanes> value(n), gradient(2 * n), without(n);
      swarm.basis->evaluate(cell, x, one.data(), slope.data());
      swarm.basis->evaluate(cell, x, alone.data(), nullptr);
      swarm.basis->evaluate(cell, four, value.data(), gradient.data());
      swarm.basis->evaluate(cell, four, without.data(), nullptr);
      CHECK(alone == one);
      for (std::size_t l = 0; l < lanes; ++l) {
        for (std::size_t a = 0; a < n; ++a) {
          CHECK(std::abs(value[a][l] - one[l * n + a]) <= 1e-14);
          CHECK(without[a][l] == value[a][l]);
        }
        for (std::size_t a = 0; a < 2 * n; ++a) CHECK(std::abs(gradient[a][l] - slope[l * 2 * n + a]) <= 1e-12);
      }
    }
  });
}

TEST_CASE("a grid holds points in a cell where it finds that cell for each of them", "[engine][speed]") {
  for_swarms([](const Swarm& swarm, test::Random& random) {
    const Grid& grid = swarm.basis->grid();
    for (Index p = 0; p < swarm.points.size(); ++p) {
      const Index cell = swarm.cell[static_cast<std::size_t>(p)];
      std::array<LanePoint, 2> x;
      bool each = true;
      for (std::size_t k = 0; k < x.size() * lanes; ++k) {
        const Vec2 near =
            swarm.points.position.col(p) + 0.1 * grid.size(cell) * Vec2(random.in({-Vec2::Ones(), Vec2::Ones()}));
        x[k / lanes][0][k % lanes] = near.x();
        x[k / lanes][1][k % lanes] = near.y();
        each = each && grid.locate(near, cell) == cell;
      }
      CHECK(grid.holds_all(cell, x) == each);
    }
  });
}

TEST_CASE("mass and force on the grid are the sums over points that (Y.2) and (Y.3) name", "[engine][speed]") {
  for_swarms([](Swarm& swarm, test::Random&) {
    const Eigen::Matrix2Xd load = Eigen::Matrix2Xd::Random(2, swarm.points.size());
    PointPasses passes(*swarm.basis, swarm.table);
    GridSums sums;
    passes.mass_and_force({swarm.points, swarm.motion, swarm.points.volume}, swarm.cells, load, false, sums);
    for (Index p = 0; p < swarm.points.size(); ++p) {
      const Support support = swarm.support(p);
      Mat2 stress;
      stress << swarm.points.stress(0, p), swarm.points.stress(2, p), swarm.points.stress(2, p),
          swarm.points.stress(1, p);
      for (Eigen::Index a = 0; a < support.value.size(); ++a) {
        const Index f = support.function[a];
        sums.mass[f] -= swarm.motion.mass[p] * support.value[a];
        sums.force.col(f) += swarm.points.volume[p] * stress * support.gradient.col(a) - support.value[a] * load.col(p);
      }
    }
    CHECK(sums.mass.cwiseAbs().maxCoeff() <= 1e-12);
    CHECK(sums.force.cwiseAbs().maxCoeff() <= 1e-11);
  });
}

TEST_CASE("points gain Δt Σ a φ, and the grid their momentum", "[engine][speed]") {
  for_swarms([](Swarm& swarm, test::Random& random) {
    const Eigen::Matrix2Xd acceleration = random.field(swarm.basis->functions());
    const Eigen::Matrix2Xd before = swarm.motion.velocity;
    PointPasses passes(*swarm.basis, swarm.table);
    Eigen::Matrix2Xd momentum;
    passes.accelerate({swarm.points, swarm.motion, swarm.points.volume}, swarm.cells, acceleration, 0.3, momentum);
    for (Index p = 0; p < swarm.points.size(); ++p) {
      const Support support = swarm.support(p);
      const Vec2 expected = before.col(p) + 0.3 * support.interpolate(acceleration);
      CHECK((swarm.motion.velocity.col(p) - expected).norm() <= 1e-13);
      for (Eigen::Index a = 0; a < support.value.size(); ++a)
        momentum.col(support.function[a]) -= swarm.motion.mass[p] * support.value[a] * swarm.motion.velocity.col(p);
    }
    CHECK(momentum.cwiseAbs().maxCoeff() <= 1e-12);
  });
}

TEST_CASE("points move by the field, and D by its gradient", "[engine][speed]") {
  const auto law = neo_hookean(1e3, 0.3);
  for_swarms([&](Swarm& swarm, test::Random& random) {
    const Eigen::Matrix2Xd velocity = random.field(swarm.basis->functions());
    const MaterialPoints points = swarm.points;
    const PointMotion motion = swarm.motion;
    PointPasses passes(*swarm.basis, swarm.table);
    const std::vector<Index> cell = swarm.cell;
    const MotionReport report = passes.move({swarm.points, swarm.motion, swarm.points.volume}, swarm.cells, *law,
                                            {velocity, 1e-3, 0.25}, swarm.cell);
    CHECK(report.fault == Fault::none);
    for (Index p = 0; p < points.size(); ++p) {
      const Support support = swarm.basis->support(cell[static_cast<std::size_t>(p)], points.position.col(p));
      const Vec2 v = support.interpolate(velocity);
      const Mat2 d = Mat2::Identity() + 1e-3 * support.gradient_of(velocity);
      CHECK((swarm.points.position.col(p) - points.position.col(p) - 1e-3 * v).norm() <= 1e-14);
      CHECK((swarm.motion.velocity.col(p) - 0.75 * motion.velocity.col(p) - 0.25 * v).norm() <= 1e-13);
      CHECK((Eigen::Map<const Mat2>(swarm.motion.deformation.col(p).data()) - d).norm() <= 1e-14);
      CHECK(std::abs(swarm.points.volume[p] - d.determinant() * motion.volume[p]) <= 1e-14);
      CHECK((swarm.points.stress.col(p) - law->updated(points.stress.col(p), d - Mat2::Identity(), d)).norm() <= 1e-9);
      const Index there =
          swarm.basis->grid().locate(swarm.points.position.col(p), cell[static_cast<std::size_t>(p)]).value_or(-1);
      CHECK(swarm.cell[static_cast<std::size_t>(p)] == there);
    }
  });
}

TEST_CASE("a law updates many points as it does one, by its own code and by that of every law", "[engine][speed]") {
  test::Random random(5);
  const auto matrix = [&] { return Mat2(Mat2::NullaryExpr([&] { return random.uniform(-0.1, 0.1); })); };
  for (const auto& law : {linear_large(1e4, 0.2), neo_hookean(1e4, 0.2), hypoelastic(1e4, 0.2)}) {
    INFO(law->name());
    std::vector<LaneTensor> stress(5), increment(5), deformation(5);
    std::vector<Stress> expected;
    for (std::size_t k = 0; k < 5 * lanes; ++k) {
      const Stress before = 1e3 * Stress::Random();
      const Mat2 g = matrix();
      const Mat2 d = Mat2::Identity() + matrix();
      expected.push_back(law->updated(before, g, d));
      for (std::size_t c = 0; c < 4; ++c) {
        stress[k / lanes][c][k % lanes] = before[static_cast<Eigen::Index>(c)];
        increment[k / lanes][c][k % lanes] = g.data()[c];
        deformation[k / lanes][c][k % lanes] = d.data()[c];
      }
    }
    std::vector<LaneTensor> inherited = stress;
    law->update(stress, increment, deformation);
    law->LargeStrainMaterial::update(inherited, increment, deformation);
    for (std::size_t k = 0; k < expected.size(); ++k)
      for (std::size_t c = 0; c < 4; ++c) {
        const double wanted = expected[k][static_cast<Eigen::Index>(c)];
        CHECK(std::abs(stress[k / lanes][c][k % lanes] - wanted) <= 1e-15 * expected[k].norm());
        CHECK(inherited[k / lanes][c][k % lanes] == wanted);
      }
  }
}

TEST_CASE("time steps do not depend on the number of threads, to the last digit", "[engine][speed]") {
  const int threads_before = omp_get_max_threads();
  for (const auto& [basis, mass] : {std::pair(Case::BasisType::linear, MassForm::lumped),
                                    std::pair(Case::BasisType::bilinear, MassForm::partly_lumped)}) {
    const After one = slide(basis, mass, 1);
    for (const int threads : {2, 3}) {
      const After many = slide(basis, mass, threads);
      CHECK(many.points.position == one.points.position);
      CHECK(many.points.stress == one.points.stress);
      CHECK(many.motion.velocity == one.motion.velocity);
    }
  }
  omp_set_num_threads(threads_before);
}
