#include "shoreline/engine/quasi_static.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "body_boundary.hpp"
#include "effects/slip_points.hpp"
#include "estimate_at_end.hpp"
#include "fitted_volumes.hpp"
#include "motion_check.hpp"
#include "move_points.hpp"
#include "passive_points.hpp"
#include "prescribed.hpp"
#include "respace_pieces.hpp"
#include "shoreline/bases/counters.hpp"
#include "shoreline/engine/failures.hpp"
#include "step_system.hpp"
#include "timed_effect.hpp"
#include "weak_spots.hpp"

namespace shoreline {
namespace {

constexpr int points_per_segment = 4;  ///< Gauss points along the edge: exact to degree 7 on straight pieces

/// Keeps between the steps what outlives one.
struct Workspace {
  PointSupports supports;
  std::vector<Edge> edges;  ///< one a boundary piece
  std::optional<Dilatation> dilatation;
  FittedVolumes weights;
  PointSupports samples, places;  ///< where the points without load are
  StepSystem system;
  std::map<std::string, Vec3> grid_reactions;  ///< by piece with method grid
  std::vector<Piece> start;                    ///< pieces before the first step, with geometry initial
  Eigen::Matrix2Xd total;                      ///< (2, functions) increments of all steps, with geometry initial [m]
};

void make_edges(const Scene& scene, Workspace& work, RunRecord& record) {
  work.edges.clear();
  record.extended_share = 0.0;
  for (const BoundaryPiece& b : scene.boundary) {
    work.edges.push_back(make_edge(b.piece, scene.basis->grid(), work.supports.active, gauss(points_per_segment)));
    record.extended_share = std::max(record.extended_share, work.edges.back().extended_share);
  }
}

/// The projected dilatation, where the material asks for it: bodies slip over the edges whose supports act in a band.
std::optional<Dilatation> project_dilatation(const Scene& scene, const PointSupports& supports,
                                             const std::vector<Edge>& edges, const Eigen::Matrix2Xd& prescribed) {
  if (!scene.projected) return {};
  Dilatation dilatation(*scene.basis, *scene.projected, scene.points, supports);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto* held = std::get_if<Essential>(&scene.boundary[k].condition);
    if (held != nullptr && held->method != EssentialMethod::grid)
      dilatation.let_slip(edges[k], slip_points(*scene.basis, edges[k]), prescribed);
  }
  return dilatation;
}

/// Points that are too few to integrate functions of a higher degree leave errors that no refinement removes. The parts
/// of an element have points of their own, and functions that are linear or quadratic there.
void warn_few_points(const Basis& basis, const PointSupports& supports, std::vector<std::string>& warnings) {
  const int wanted = (basis.degree() + 1) * (basis.degree() + 1);
  const double mean = static_cast<double>(supports.point.size()) / supports.cells();
  if (basis.degree() < 2 || basis.grid().parts() > 1 || mean >= wanted) return;
  warnings.push_back(fmt::format(
      "{:.2g} material points a cell on average are too few for functions of degree {}, which need about {} "
      "to be integrated: stresses are in error however small the cells are. Raise material_points.per_cell "
      "to {} or more, or take a lower degree",
      mean, basis.degree(), wanted, basis.degree() + 1));
}

/// Poisson's ratio follows from the tangent in plane strain; in plane stress D₀₁/(D₀₀ + D₀₁) is at most 1/3.
void warn_nearly_incompressible(const Scene& scene, std::vector<std::string>& warnings) {
  constexpr double limit = 0.45;
  const Mat3 tangent = scene.material->tangent(Stress::Zero());
  const double ratio = tangent(0, 1) / (tangent(0, 0) + tangent(0, 1));
  if (scene.projected || !(ratio > limit)) return;
  warnings.push_back(
      fmt::format("with Poisson's ratio {:.6g} the body is nearly incompressible: displacements come out too small and "
                  "pressures oscillate. Set material.dilatation to \"projected\"",
                  ratio));
}

/// What pieces that the grid holds prescribe at a step; nothing is looked for where no piece is held so.
std::vector<Constraint> constraints_on_grid(const Scene& scene, const std::vector<Edge>& edges,
                                            const Eigen::Matrix2Xd& prescribed, RunRecord& record) {
  const bool any = std::ranges::any_of(scene.boundary, [](const BoundaryPiece& b) {
    const auto* held = std::get_if<Essential>(&b.condition);
    return held != nullptr && held->method == EssentialMethod::grid;
  });
  if (!any) return {};
  return timed_effect(record, "boundary", "grid",
                      [&] { return grid_constraints(*scene.basis, scene.boundary, edges, prescribed); });
}

/// Lets the contributions take note of what the step found, and adds up what acts at its end.
Resultants accept(const Scene& scene, const StepState& state, const Eigen::Matrix2Xd& increment,
                  const std::vector<Constraint>& constraints, Workspace& work) {
  Resultants now;
  for (const auto& effect : scene.contributions) {
    effect->accept(state, increment);
    effect->report(now);
  }
  if (!constraints.empty()) {
    if (scene.loading == Loading::residual) work.grid_reactions.clear();
    const Eigen::Matrix2Xd force = work.system.assembler.reactions(work.system.blocks, increment);
    add_grid_reactions(scene, constraints, force, work.grid_reactions);
  }
  now.reactions.insert(work.grid_reactions.begin(), work.grid_reactions.end());
  return now;
}

std::string name_of_place(const Scene& scene, std::size_t k) {
  const auto found = std::ranges::find_if(scene.probes, [k](const Probe& p) { return p.at_place && p.point == k; });
  return fmt::format("probe \"{}\"", found->name);
}

/// Finds where the body is on the grid: its points, its edges, and with them what the step evaluates.
void locate_body(Scene& scene, Workspace& work, RunRecord& record) {
  Clock& clock = record.phases;
  work.supports = clock.time("support", [&] {
    const CountedAllocations counted;
    return locate_points(*scene.basis, scene.points, std::move(work.supports));
  });
  clock.time("boundary", [&] { make_edges(scene, work, record); });
  if (scene.fitted)
    record.weights = timed_effect(record, "weights", "fitted_weights", [&] {
      return work.weights.fit(*scene.basis, work.supports, work.edges, scene.points);
    });
  const auto& active = work.supports.active;
  if (scene.samples)
    timed_effect(record, "errors", "samples", [&] {
      work.samples = locate_passive(*scene.basis, active, *scene.samples,
                                    [](std::size_t k) { return fmt::format("sample point {}", k); });
    });
  if (scene.places)
    timed_effect(record, "probes", "probes", [&] {
      work.places =
          locate_passive(*scene.basis, active, *scene.places, [&](std::size_t k) { return name_of_place(scene, k); });
    });
}

/// Moves points and pieces by what the step found.
void move_body(const StepMotion& motion, Workspace& work, Scene& scene, RunRecord& record) {
  record.phases.time("update", [&] {
    {
      const CountedAllocations counted;
      move_points(motion, work.supports, scene.points);
    }
    if (scene.geometry == Geometry::updated) return move_boundary(scene, work.edges, motion.increment);
    // pieces go from their start by all increments at once, as the edges do not follow them
    if (work.start.empty()) {
      for (const BoundaryPiece& b : scene.boundary) work.start.push_back(b.piece);
      work.total = Eigen::Matrix2Xd::Zero(2, motion.increment.cols());
    }
    for (std::size_t k = 0; k < work.start.size(); ++k) scene.boundary[k].piece = work.start[k];
    work.total += motion.increment;
    move_boundary(scene, work.edges, work.total);
  });
  if (scene.samples)
    timed_effect(record, "errors", "samples", [&] { move_points(motion, work.samples, *scene.samples); });
  if (scene.places) timed_effect(record, "probes", "probes", [&] { move_points(motion, work.places, *scene.places); });
}

void run_step(Scene& scene, int step, const QuasiStaticOptions& options, Workspace& work, RunRecord& record) {
  Clock& clock = record.phases;
  const bool located = scene.geometry == Geometry::initial && step > 1;
  if (!located) locate_body(scene, work, record);
  const PointSupports& supports = work.supports;
  if (step == 1) {
    warn_few_points(*scene.basis, supports, record.warnings);
    warn_nearly_incompressible(scene, record.warnings);
  }
  const double t = static_cast<double>(step) / scene.load_steps;
  const double t_before = static_cast<double>(step - 1) / scene.load_steps;
  const Eigen::Matrix2Xd prescribed =
      clock.time("boundary", [&] { return prescribed_increment(scene, work.edges, t, t_before, record.fit_errors); });
  const std::vector<Constraint> constraints = constraints_on_grid(scene, work.edges, prescribed, record);
  if (!located || prescribed.cols() > 0)
    clock.time("support", [&] { work.dilatation = project_dilatation(scene, supports, work.edges, prescribed); });
  const StepState state{*scene.basis, scene.points,  supports,
                        work.edges,   scene.loading, t,
                        t_before,     prescribed,    work.dilatation ? &*work.dilatation : nullptr};

  work.system.same_matrix = located;
  const Eigen::Matrix2Xd increment = solve_step(scene, state, constraints, options, work.system, record);
  if (options.cut_fractions)
    record.diagnostics =
        timed_effect(record, "diagnostics", "cut_fractions", [&] { return weak_spots(state, work.system); });
  record.largest_increment = increment.size() == 0 ? 0.0 : increment.cwiseAbs().maxCoeff();
  clock.time("update", [&] { record.resultants = accept(scene, state, increment, constraints, work); });
  move_body({*scene.basis, *scene.material, increment, state.dilatation}, work, scene, record);
}

}  // namespace

void run_load_steps(Scene& scene, const QuasiStaticOptions& options, RunRecord& record) {
  Workspace work;
  for (int step = 1; step <= scene.load_steps; ++step) {
    try {
      run_step(scene, step, options, work, record);
      record.steps = step;
      if (!scene.probes.empty())
        timed_effect(record, "probes", "probes",
                     [&] { record_probes(scene, static_cast<double>(step) / scene.load_steps); });
      record.phases.time("boundary", [&] {
        check_motion(scene);
        respace_pieces(scene, step, work.system.warnings, record.warnings);
      });
      if (options.error_estimate && step == scene.load_steps) estimate_at_end(scene, work.supports, record);
    } catch (const OutsideGrid& error) {
      throw ComputationError(fmt::format("load step {}: {}", step, error.what()));
    } catch (const InvalidArgument& error) {
      throw ComputationError(fmt::format("load step {}: {}", step, error.what()));
    } catch (const ComputationError& error) {
      throw ComputationError(fmt::format("load step {}: {}", step, error.what()));
    }
    options.after_step(step);
  }
}

}  // namespace shoreline
