// Weights that are consistent with the outline, engine/src/consistent_weights.hpp.

#include "../../engine/src/consistent_weights.hpp"

#include <omp.h>

#include <catch2/catch.hpp>

#include "../every_grid.hpp"
#include "../scenes.hpp"

using namespace shoreline;

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// A disc of radius 0.8 on a grid, with as many points on a lattice across it.
Scene disc_with(const Case::Grid& grid, int across) {
  Case problem = test::disc_case(0.8, 0.1, Case::Free{});
  problem.grid = grid;
  problem.material_points = AcrossFill{.across = {across, across}};
  return build_scene(problem);
}

/// The square of a whole grid with jittered points: no function sees few of them.
Scene full_square(const Case::Grid& grid, int across) {
  Case problem = test::disc_case(0.8, 0.1, Case::Free{});
  problem.grid = grid;
  problem.boundaries[0].piece = {
      .name = "rim", .points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, .corners = {0, 1, 2, 3}, .closed = true};
  problem.material_points = AcrossFill{.across = {across, across}};
  Scene scene = build_scene(problem);
  test::Random random(5);
  for (Index p = 0; p < scene.points.size(); ++p) scene.points.position.col(p) += 0.3 * 2.0 / across * random.vector();
  return scene;
}

std::vector<test::NamedGrid> grids() { return test::every_grid(Vec2(-1.0, -1.0), 2.0, 8); }

/// Σ w σ(x_p) ∇φ_i of a stress field, (2, functions) [N per metre].
template <class StressAt>
Eigen::Matrix2Xd internal_force(const Scene& scene, const Eigen::VectorXd& weight, StressAt&& stress) {
  Eigen::Matrix2Xd force = Eigen::Matrix2Xd::Zero(2, scene.basis->functions());
  for (Index p = 0; p < scene.points.size(); ++p) {
    const Vec2 x = scene.points.position.col(p);
    const Support s = scene.basis->support(scene.basis->grid().locate(x, 0).value(), x);
    for (Eigen::Index a = 0; a < s.value.size(); ++a)
      force.col(s.function[a]) += weight[p] * stress(x) * s.gradient.col(a);
  }
  return force;
}

/// ∮ φ_i σ ν dS + Σ V φ_i b, (2, functions).
template <class StressAt>
Eigen::Matrix2Xd loads(const Scene& scene, const test::Step& step, StressAt&& stress, const Vec2& body_force) {
  Eigen::Matrix2Xd force = Eigen::Matrix2Xd::Zero(2, scene.basis->functions());
  for (const Edge& edge : step.edges)
    for (std::size_t k = 0; k < edge.points.size(); ++k) {
      const BoundaryPoint& p = edge.points[k];
      const Support s = scene.basis->support(edge.support_cell[edge.segment_of(k)], p.x);
      for (Eigen::Index a = 0; a < s.value.size(); ++a)
        force.col(s.function[a]) -= p.weight * s.value[a] * stress(p.x) * p.normal;
    }
  for (Index p = 0; p < scene.points.size(); ++p) {
    const Vec2 x = scene.points.position.col(p);
    const Support s = scene.basis->support(scene.basis->grid().locate(x, 0).value(), x);
    for (Eigen::Index a = 0; a < s.value.size(); ++a)
      force.col(s.function[a]) += scene.points.volume[p] * s.value[a] * body_force;
  }
  return force;
}

const Mat2 constant = (Mat2() << 1.0, 0.4, 0.4, -2.0).finished();

}  // namespace

TEST_CASE("with consistent weights every constant stress is in balance with its tractions on every basis",
          "[engine][consistent_weights]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Scene scene = full_square(grid, 96);
    const test::Step step(scene);
    ConsistentWeights weights(Consistency::divergence);
    const Eigen::VectorXd w = weights.fit(*scene.basis, scene.points, step.supports, step.edges);
    const auto stress = [](const Vec2&) { return constant; };
    const Eigen::Matrix2Xd target = loads(scene, step, stress, Vec2::Zero());
    const double before = (internal_force(scene, scene.points.volume, stress) - target).cwiseAbs().maxCoeff();
    const double after = (internal_force(scene, w, stress) - target).cwiseAbs().maxCoeff();
    CHECK(before > 1e-3 * target.cwiseAbs().maxCoeff());
    CHECK(after < 1e-5 * target.cwiseAbs().maxCoeff());
    CHECK(weights.report().unmet < 5e-6);                        // what the iteration leaves, and its softness
    CHECK_THAT(w.sum(), Catch::Matchers::WithinRel(4.0, 1e-5));  // the outline's area
  }
}

TEST_CASE("where functions see few points the rest of their constraints is reported", "[engine][consistent_weights]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Scene scene = disc_with(grid, 40);
    const test::Step step(scene);
    ConsistentWeights weights(Consistency::divergence);
    const Eigen::VectorXd w = weights.fit(*scene.basis, scene.points, step.supports, step.edges);
    const auto unmet = [&](const Mat2& stress) {
      const auto field = [&](const Vec2&) { return stress; };
      return Eigen::Matrix2Xd(internal_force(scene, w, field) - loads(scene, step, field, Vec2::Zero()));
    };
    const Eigen::Matrix2Xd side = loads(
        scene, step, [](const Vec2&) { return Mat2(Mat2::Identity()); }, Vec2::Zero());
    CHECK_THAT(
        weights.report().unmet,
        Catch::Matchers::WithinRel(unmet(Mat2::Identity()).cwiseAbs().maxCoeff() / side.cwiseAbs().maxCoeff(), 1e-3));
  }
}

TEST_CASE(
    "with linearly consistent weights a linear stress is five times nearer to balance with the points' body force",
    "[engine][consistent_weights]") {
  const auto stress = [](const Vec2& x) {
    return (Mat2() << x.x() - 2.0 * x.y(), 0.5 * x.x(), 0.5 * x.x(), 3.0 * x.y() + x.x()).finished();
  };
  const Vec2 body_force(-1.0, -3.5);  // −div σ
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Scene scene = full_square(grid, 96);
    const test::Step step(scene);
    const Eigen::Matrix2Xd target = loads(scene, step, stress, body_force);
    const auto error = [&](const Eigen::VectorXd& w) { return (internal_force(scene, w, stress) - target).norm(); };
    ConsistentWeights linear(Consistency::linear), divergence(Consistency::divergence);
    const double with_linear = error(linear.fit(*scene.basis, scene.points, step.supports, step.edges));
    const double with_divergence = error(divergence.fit(*scene.basis, scene.points, step.supports, step.edges));
    CAPTURE(error(scene.points.volume), with_divergence, with_linear);
    CHECK(with_linear < 0.2 * error(scene.points.volume));
    CHECK(with_linear < with_divergence);
  }
}

TEST_CASE("no weight falls below a twentieth of the plain one", "[engine][consistent_weights]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    const Scene scene = disc_with(grid, 13);
    const test::Step step(scene);
    for (const Consistency consistency : {Consistency::divergence, Consistency::linear}) {
      ConsistentWeights weights(consistency);
      const Eigen::VectorXd w = weights.fit(*scene.basis, scene.points, step.supports, step.edges);
      CHECK((w.array() / scene.points.volume.array()).minCoeff() >= 0.05 * (1.0 - 1e-12));
    }
  }
}

TEST_CASE("weights of an exact rule are left alone", "[engine][consistent_weights]") {
  const std::vector<Vec2> body{{-0.63, -0.71}, {0.77, -0.55}, {0.52, 0.81}, {-0.74, 0.66}};
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    Case problem = test::disc_case(0.8, 0.1, Case::Free{});
    problem.grid = grid;
    problem.boundaries[0].piece = {.name = "rim", .points = body, .corners = {0, 1, 2, 3}, .closed = true};
    problem.material_points = test::patch_points(grid, body);
    const Scene scene = build_scene(problem);
    const test::Step step(scene);
    ConsistentWeights weights(Consistency::divergence);
    const Eigen::VectorXd w = weights.fit(*scene.basis, scene.points, step.supports, step.edges);
    CHECK((w - scene.points.volume).norm() < 1e-8 * scene.points.volume.norm());
  }
}

TEST_CASE("a fit that starts from the one before comes to the same weights with the factors that there are",
          "[engine][consistent_weights]") {
  for (const auto& [name, grid] : grids()) {
    CAPTURE(name);
    Scene scene = full_square(grid, 96);
    ConsistentWeights kept(Consistency::linear), fresh(Consistency::linear);
    const test::Step step(scene);
    static_cast<void>(kept.fit(*scene.basis, scene.points, step.supports, step.edges));
    CHECK(kept.report().factorisations >= 1);
    for (Index p = 0; p < scene.points.size(); ++p) scene.points.volume[p] *= 1.0 + 1e-4 * scene.points.position(0, p);
    const Eigen::VectorXd w = kept.fit(*scene.basis, scene.points, step.supports, step.edges);
    CHECK(kept.report().factorisations == 0);
    const Eigen::VectorXd anew = fresh.fit(*scene.basis, scene.points, step.supports, step.edges);
    CHECK((w - anew).norm() < 2e-5 * anew.norm());
  }
}

TEST_CASE("weights do not depend on the number of threads", "[engine][consistent_weights]") {
  const Scene scene = disc_with(grids().back().grid, 200);
  const test::Step step(scene);
  Eigen::VectorXd w[2];
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    ConsistentWeights weights(Consistency::linear);
    w[at(threads - 1)] = weights.fit(*scene.basis, scene.points, step.supports, step.edges);
  }
  omp_set_num_threads(omp_get_num_procs());
  CHECK(w[0] == w[1]);
}
