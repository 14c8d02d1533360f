#include "body_boundary.hpp"

namespace shoreline {

namespace {

/// Whether a piece lies on grid lines that hold it there.
const Essential* held_on_lines(const BoundaryPiece& b) {
  const auto* condition = std::get_if<Essential>(&b.condition);
  return condition != nullptr && condition->method == EssentialMethod::grid && !condition->value ? condition : nullptr;
}

/// Takes out of the motion of a held tracking point what the piece does not allow. The field on the grid allows it to
/// rounding, but a point that is off its line by a rounding error is carried further off in every step.
void hold_point(const Essential& held, const std::vector<Vec2>& before, std::size_t k, Vec2& point) {
  if (!held.normal_only) point = before[k];
  const auto slide_along = [&](const Vec2& chord) {
    const Vec2 along = chord.normalized();
    point = before[k] + along.dot(point - before[k]) * along;
  };
  if (held.normal_only && k > 0) slide_along(before[k] - before[k - 1]);
  if (held.normal_only && k + 1 < before.size()) slide_along(before[k + 1] - before[k]);
}

}  // namespace

std::vector<SplineCurve> curves_at_start(const std::vector<BoundaryPiece>& boundary) {
  std::vector<SplineCurve> curves;
  for (const BoundaryPiece& b : boundary) curves.push_back(*b.original);
  return curves;
}

void move_boundary(Scene& scene, const std::vector<Edge>& edges, const Eigen::Matrix2Xd& increment) {
  std::vector<std::vector<Vec2>> before;
  for (std::size_t k = 0; k < scene.boundary.size(); ++k) {
    before.push_back(scene.boundary[k].piece.points);
    move_piece(scene.boundary[k].piece, edges[k], [&](Index cell, const Vec2& x) -> Motion {
      const Support support = scene.basis->support(cell, x);
      return {support.interpolate(increment), support.gradient_of(increment)};
    });
    std::vector<Vec2>& points = scene.boundary[k].piece.points;
    if (const Essential* held = held_on_lines(scene.boundary[k]))
      for (std::size_t i = 0; i < points.size(); ++i) hold_point(*held, before[k], i, points[i]);
  }
  for (const std::vector<int>& loop : scene.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto here = static_cast<std::size_t>(loop[k]);
      const auto there = static_cast<std::size_t>(loop[(k + 1) % loop.size()]);
      std::vector<Vec2>& points = scene.boundary[here].piece.points;
      if (scene.boundary[here].piece.closed) continue;
      Vec2 joint = 0.5 * (points.back() + scene.boundary[there].piece.points.front());
      if (const Essential* held = held_on_lines(scene.boundary[here]))
        hold_point(*held, before[here], points.size() - 1, joint);
      if (const Essential* held = held_on_lines(scene.boundary[there])) hold_point(*held, before[there], 0, joint);
      points.back() = scene.boundary[there].piece.points.front() = joint;
    }
}

void add_grid_reactions(const Scene& scene, const std::vector<Constraint>& constraints, const Eigen::Matrix2Xd& force,
                        std::map<std::string, Vec3>& reactions) {
  const auto reaction = [&](int piece) -> Vec3& {
    const std::string& name = scene.boundary[static_cast<std::size_t>(piece)].piece.name;
    return reactions.try_emplace(name, Vec3::Zero()).first->second;
  };
  for (const Constraint& c : constraints) {
    const double multiplier = force(c.component, c.function);
    const auto part = [&](const ComponentTerm& term) {
      return resultant(scene.basis->control_point(term.function),
                       multiplier * term.coefficient * Vec2::Unit(term.component));
    };
    reaction(c.piece) += part({c.function, c.component, 1.0});
    for (const ComponentTerm& m : c.masters) reaction(c.piece) -= part(m);
    for (const PieceTerm& other : c.others) {
      reaction(c.piece) -= part(other.term);
      reaction(other.piece) += part(other.term);
    }
  }
}

}  // namespace shoreline
