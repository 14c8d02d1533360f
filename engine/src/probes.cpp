#include "shoreline/engine/probes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "body.hpp"
#include "body_boundary.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/scene.hpp"

namespace shoreline {
namespace {

/// Where a tracking point was at the start.
Vec2 origin(const SplineCurve& original, std::size_t point) {
  const bool last = point == original.spans.size();  // of an open piece
  return last ? original.spans.back().position(1.0) : original.spans[point].position(0.0);
}

ProbeState state(const Scene& scene, const Probe& probe, double t) {
  if (probe.lost) {
    ProbeState last = probe.history.back();
    last.t = t;
    return last;
  }
  if (probe.piece) {
    const BoundaryPiece& b = scene.boundary[*probe.piece];
    const Vec2& position = b.piece.points[probe.point];
    return {t, position, position - origin(*b.original, probe.point), std::nullopt};
  }
  const MaterialPoints& points = probe.at_place ? scene.places.value() : scene.points;
  const auto p = static_cast<Eigen::Index>(probe.point);
  return {t, points.position.col(p), points.displacement.col(p), Stress(points.stress.col(p))};
}

/// The point that is nearest to a place, without history.
Probe nearest(const Scene& scene, const Case::Probe& asked) {
  const double tie = 1e-9 * scene.basis->grid().size(0);
  Probe probe{.name = asked.name, .piece = {}, .point = 0, .history = {}};
  Eigen::Index nearest = 0;
  double distance = (scene.points.position.colwise() - asked.position).colwise().norm().minCoeff(&nearest);
  probe.point = static_cast<std::size_t>(nearest);
  for (std::size_t k = 0; k < scene.boundary.size(); ++k) {
    const std::vector<Vec2>& points = scene.boundary[k].piece.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double here = (points[i] - asked.position).norm();
      if (here >= distance - tie) continue;
      distance = here;
      probe.piece = k;
      probe.point = i;
    }
  }
  return probe;
}

}  // namespace

const char* followed_by(const Probe& probe) {
  if (probe.at_place) return "place";
  return probe.piece ? "tracking point" : "material point";
}

std::optional<MaterialPoints> places_of_probes(const Case& problem, const Scene& scene) {
  if (std::ranges::none_of(problem.probes, &Case::Probe::at_place)) return std::nullopt;
  const Region body(curves_at_start(scene.boundary));
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < problem.probes.size(); ++i) {
    if (!problem.probes[i].at_place) continue;
    places.push_back(problem.probes[i].position);
    if (const char* left = left_by(places.back(), scene.basis->grid(), &body))
      throw CaseError(problem.file.string(), fmt::format("/probes/{}/position", i),
                      fmt::format("found ({:.6g}, {:.6g}), outside the {}, for a probe at its very place; expected a "
                                  "place in the body or on its outline; move it, or set \"at\" to \"nearest\"",
                                  places.back().x(), places.back().y(), left));
  }
  const auto count = static_cast<Eigen::Index>(places.size());
  return points_at(Eigen::Map<const Eigen::Matrix2Xd>(places.front().data(), 2, count), Eigen::VectorXd::Zero(count));
}

std::vector<Probe> place_probes(const Case& problem, const Scene& scene) {
  std::vector<Probe> probes;
  std::size_t places = 0;
  for (std::size_t i = 0; i < problem.probes.size(); ++i) {
    const Case::Probe& asked = problem.probes[i];
    probes.push_back(asked.at_place
                         ? Probe{.name = asked.name, .piece = {}, .point = places++, .history = {}, .at_place = true}
                         : nearest(scene, asked));
    Probe& probe = probes.back();
    if (probe.piece && problem.respacing > 0.0)
      throw CaseError(
          problem.file.string(), fmt::format("/probes/{}/position", i),
          fmt::format("found tracking point {} of piece \"{}\" nearest, which tracking.respace may move along "
                      "the curve; expected a place nearer to a material point, or no re-spacing",
                      probe.point, scene.boundary[*probe.piece].piece.name));
    probe.history.push_back(state(scene, probe, 0.0));
  }
  return probes;
}

void record_probes(Scene& scene, double t) {
  for (Probe& probe : scene.probes) probe.history.push_back(state(scene, probe, t));
}

}  // namespace shoreline
