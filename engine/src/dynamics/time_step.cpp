#include "time_step.hpp"

#include <fmt/format.h>

#include <cmath>

#include "../body_boundary.hpp"
#include "../point_cells.hpp"
#include "../prescribed.hpp"
#include "dynamic_probes.hpp"
#include "shoreline/engine/failures.hpp"

namespace shoreline {
namespace {

constexpr int points_per_segment = 4;  ///< Gauss points along the edge, as in load steps
constexpr double tolerance = 1e-13;    ///< of accelerations and velocities on the grid

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Whether a piece is where it was.
bool same_place(const Piece& now, const Piece& before) {
  return now.points == before.points && now.start_tangent == before.start_tangent &&
         now.end_tangent == before.end_tangent;
}

bool any_grid_piece(const Scene& body) {
  for (const BoundaryPiece& b : body.boundary)
    if (const auto* c = std::get_if<Essential>(&b.condition); c != nullptr && c->method == EssentialMethod::grid)
      return true;
  return false;
}

std::unique_ptr<GhostMass> ghost_mass_of(const DynamicScene& scene) {
  if (scene.settings.ghost == 0.0) return nullptr;
  return std::make_unique<GhostMass>(scene.settings.ghost, scene.motion.mass.sum() / scene.motion.volume.sum());
}

}  // namespace

TimeStep::TimeStep(DynamicScene& scene)
    : scene_(scene),
      ghost_(ghost_mass_of(scene)),
      fitted_(scene.body.fitted ? std::make_unique<FittedQuadrature>() : nullptr),
      table_(*scene.body.basis),
      points_{scene.body.points, scene.motion, fitted_ ? fitted_->weight() : scene.body.points.volume},
      passes_(*scene.body.basis, table_),
      mass_(table_, scene.settings.mass),
      prescribed_(2, 0),
      prescribed_before_(2, 0),
      acceleration_(Eigen::Matrix2Xd::Zero(2, table_.functions())),
      velocity_(Eigen::Matrix2Xd::Zero(2, table_.functions())) {
  cell_ = cells_of(*scene.body.basis, scene.body.points);
  require_inside(cell_, scene.body.points);
  find_cells();
}

void TimeStep::find_cells() {
  group_points(cell_, scene_.body.basis->grid(), cells_.supports);
  occupied_others_ |= cells_.occupied.find(table_, cells_.supports.cell);
}

StepState TimeStep::state(double t) const {
  return {*scene_.body.basis, scene_.body.points, cells_.supports, edges_, Loading::residual, t, t, prescribed_};
}

void TimeStep::trace_boundary() {
  const Scene& body = scene_.body;
  edges_.resize(body.boundary.size());
  traced_.resize(body.boundary.size());
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const Piece& piece = body.boundary[k].piece;
    if (!occupied_others_ && same_place(piece, traced_[k])) continue;
    edges_[k] = make_edge(piece, body.basis->grid(), cells_.supports.active, gauss(points_per_segment));
    traced_[k] = piece;
    retraced_ = true;
  }
  occupied_others_ = false;
}

/// Holds what lies on grid lines, for a step of that length.
void TimeStep::prescribe(double t, double dt) {
  planned_ = dt;
  if (!any_grid_piece(scene_.body)) return;
  fit_errors_.clear();
  prescribed_ = prescribed_increment(scene_.body, edges_, t + dt, t, fit_errors_);
  if (prescribed_.cols() > 0) prescribed_before_ = velocity_before(t);
  hold(prescribed_, dt);
}

/// What was prescribed in the step before as a velocity, on the edges of this one: a piece that slides along a line
/// comes to functions that it did not hold then.
Eigen::Matrix2Xd TimeStep::velocity_before(double t) const {
  if (!(t > start_before_)) return Eigen::Matrix2Xd::Zero(2, table_.functions());
  std::map<std::string, FitError> unused;
  return prescribed_increment(scene_.body, edges_, t, start_before_, unused) / (t - start_before_);
}

void TimeStep::hold(const Eigen::Matrix2Xd& prescribed, double dt) {
  const Scene& body = scene_.body;
  const auto along = [&](const Eigen::Matrix2Xd& values) {
    return HeldComponents(constraints_along(held_edges_, *body.basis, body.boundary, values));
  };
  if (std::exchange(retraced_, false)) {
    std::vector<HeldCellEdge> here = held_cell_edges(*body.basis, body.boundary, edges_);
    if (here != held_edges_) {
      held_edges_ = std::move(here);
      held_velocity_ = held_acceleration_ = held_mode_ = along(Eigen::Matrix2Xd(2, 0));
    }
  }
  if (prescribed.cols() == 0) return;
  const Eigen::Matrix2Xd velocity = prescribed / dt;
  held_velocity_ = along(velocity);
  held_acceleration_ = along((velocity - prescribed_before_) / dt);
}

void TimeStep::find_forces(double t, DynamicRecord& record) {
  const MaterialPoints& points = scene_.body.points;
  point_load_.resize(2, scene_.gravity_field || scene_.body_force ? points.size() : 0);
  if (point_load_.cols() > 0) point_load_.setZero();
  const auto add = [&](const char* effect, const FieldOnPoints& field, const Eigen::VectorXd& weight) {
    if (!field) return;
    record.effects.time(effect, [&] {
      for (Index p = 0; p < points.size(); ++p) {
        const Vec2 x = points.position.col(p);
        point_load_.col(p) += weight[p] * field({x, x - points.displacement.col(p), t, 1.0});
      }
    });
  };
  add("gravity", scene_.gravity_field, scene_.motion.mass);
  add("body_force", scene_.body_force, points.volume);

  record.effects.time(scene_.law->name(),
                      [&] { passes_.mass_and_force(points_, cells_, point_load_, mass_.has_blocks(), sums_); });
  if (!scene_.gravity.isZero(0.0))
    record.effects.time("gravity", [&] { sums_.force += scene_.gravity * sums_.mass.transpose(); });
  blocks_.clear();
  for (const auto& load : scene_.body.contributions)
    record.effects.time(load->name(), [&] { load->add(state(t), blocks_); });
  for (std::size_t b = 0; b < blocks_.size(); ++b) add_load(b);
  if (scene_.settings.damping > 0.0) record.effects.time("damping", [&] { damp(); });
}

/// Adds what acts on a segment of the boundary. Of this, functions that no point sees leave their part to the others,
/// in proportion to mass: they cannot carry it to the body.
void TimeStep::add_load(std::size_t block) {
  Vec2 left = Vec2::Zero();
  double mass = 0.0;
  for (Index k = blocks_.first[block]; k < blocks_.first[block + 1]; ++k) {
    const Index f = blocks_.function[at(k)];
    const Vec2 force = Eigen::Map<const Vec2>(&blocks_.force[2 * at(k)]);
    if (sums_.mass[f] > 0.0)
      sums_.force.col(f) += force;
    else
      left += force;
    mass += std::max(0.0, sums_.mass[f]);
  }
  if (left.isZero(0.0) || mass == 0.0) return;
  for (Index k = blocks_.first[block]; k < blocks_.first[block + 1]; ++k) {
    const Index f = blocks_.function[at(k)];
    sums_.force.col(f) += std::max(0.0, sums_.mass[f]) / mass * left;
  }
}

void TimeStep::damp() {
  const auto sign = [](double v) { return v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : 0.0; };
  sums_.force -= scene_.settings.damping * velocity_.unaryExpr(sign).cwiseProduct(sums_.force.cwiseAbs());
}

void TimeStep::begin(double t, double dt, DynamicRecord& record) {
  record.phases.time("boundary", [&] {
    trace_boundary();
    prescribe(t, dt);
  });
  if (fitted_)
    record.phases.time("weights", [&] {
      fitted_->fit(*scene_.body.basis, scene_.body.points, cells_.supports, edges_);
      if (!record.weights) record.weights.emplace();
      record.weights->add(fitted_->report());
    });
  record.phases.time("forces", [&] { find_forces(t, record); });
  record.phases.time("mass", [&] { mass_.assemble(cells_.occupied, sums_.mass, sums_.block); });
  if (ghost_)
    record.phases.time("ghost_mass", [&] {
      ghost_->find(*scene_.body.basis, cells_.supports.active);
      mass_.add(ghost_->matrix());
    });
}

void TimeStep::finish(double t, double dt, bool wanted, DynamicRecord& record) {
  Clock& clock = record.phases;
  const bool replanned = std::abs(dt - planned_) > 1e-12 * dt;  // else rounding
  if (prescribed_.cols() > 0 && replanned) clock.time("boundary", [&] { prescribe(t, dt); });
  for (const auto& [piece, error] : fit_errors_) {
    record.fit_errors[piece].l2 += error.l2;
    record.fit_errors[piece].mean += error.mean;
  }
  clock.time("mass", [&] { mass_.solve(held_acceleration_, sums_.force, acceleration_, tolerance); });
  clock.time("accelerate", [&] { passes_.accelerate(points_, cells_, acceleration_, dt, momentum_); });
  clock.time("mass", [&] {
    velocity_ += dt * acceleration_;  // the guess from which a solution starts
    mass_.solve(held_velocity_, momentum_, velocity_, tolerance);
  });
  record.mass_iterations = mass_.iterations();
  start_before_ = t;
  if (wanted) clock.time("report", [&] { report(t, dt, record); });

  const MotionReport motion = clock.time("move", [&] {
    return passes_.move(points_, cells_, *scene_.law, {velocity_, dt, scene_.settings.pic}, cell_);
  });
  require_sound(motion);
  clock.time("boundary", [&] {
    increment_ = dt * velocity_;
    move_boundary(scene_.body, edges_, increment_);
  });
  clock.time("cells", [&] {
    if (!scene_.body.points.on_outline.empty()) keep_on_body_side(*scene_.body.basis, scene_.body.points, cell_);
    if (motion.outside > 0) drop_outside(t + dt, record);
    if (motion.crossed || !scene_.body.points.on_outline.empty()) find_cells();
  });
}

void TimeStep::report(double t, double dt, DynamicRecord& record) {
  record.degrees_of_freedom = free_components();
  Resultants now;
  const StepState here = state(t);
  for (const auto& load : scene_.body.contributions) {
    load->accept(here, velocity_);
    load->report(now);
  }
  Eigen::Matrix2Xd force = mass_.times(acceleration_) - sums_.force;
  const double pic = scene_.settings.pic;  // takes points along with what is held
  if (pic > 0.0) force += pic / dt * (mass_.times(velocity_) - momentum_);
  add_grid_reactions(scene_.body, held_mode_.constraint, force, now.reactions);
  const auto total = [&](const auto& force_on) {
    Vec3 sum = Vec3::Zero();
    for (Index p = 0; p < scene_.body.points.size(); ++p)
      sum += resultant(scene_.body.points.position.col(p), force_on(p));
    return sum;
  };
  if (!scene_.gravity.isZero(0.0))
    now.loads["gravity"] = total([&](Index p) -> Vec2 { return scene_.motion.mass[p] * scene_.gravity; });
  if (point_load_.cols() > 0)
    now.loads[scene_.body_force ? "body_force" : "gravity"] =
        total([&](Index p) -> Vec2 { return point_load_.col(p); });
  record.resultants = std::move(now);
}

Index TimeStep::free_components() const {
  Index count = 0;
  for (const double m : mass_.row_sum()) count += m > 0.0 ? 2 : 0;
  for (const Constraint& c : held_mode_.constraint) count -= mass_.row_sum()[c.function] > 0.0 ? 1 : 0;
  return count;
}

void TimeStep::drop_outside(double t, DynamicRecord& record) {
  std::vector<Index> kept;
  Index first = -1;
  for (Index p = 0; p < scene_.body.points.size(); ++p) {
    if (cell_[at(p)] >= 0) kept.push_back(p);
    if (cell_[at(p)] < 0 && first < 0) first = p;
  }
  const auto dropped = scene_.body.points.size() - static_cast<Index>(kept.size());
  if (dropped == 0) return;
  if (kept.empty()) throw ComputationError("every material point has left the grid; enlarge it");
  if (record.dropped == 0)
    record.warnings.push_back(
        fmt::format("material points left the grid and were dropped, the first at ({:.6g}, "
                    "{:.6g}) at t = {:.6g} s",
                    scene_.body.points.position(0, first), scene_.body.points.position(1, first), t));
  record.dropped += dropped;
  follow_kept(kept, scene_.body.probes);
  reorder(kept, scene_.body.points);
  reorder_columns(kept, scene_.motion.velocity);
  reorder_columns(kept, scene_.motion.deformation);
  reorder_entries(kept, scene_.motion.mass);
  reorder_entries(kept, scene_.motion.volume);
  if (fitted_) fitted_->keep(kept);
  std::erase(cell_, -1);
}

double TimeStep::critical_step(int most, DynamicRecord& record) {
  return record.phases.time("critical_step", [&] {
    const double step = critical_.measure(passes_, {points_, cells_, *scene_.law, mass_, held_mode_}, most);
    record.critical_step_iterations = critical_.iterations();
    return step;
  });
}

}  // namespace shoreline
