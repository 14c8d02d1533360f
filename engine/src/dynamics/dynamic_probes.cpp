#include "dynamic_probes.hpp"

#include <algorithm>

namespace shoreline {

void add_motion(const DynamicScene& scene, Probe& probe, double t, double dt) {
  ProbeState& state = probe.history.back();
  if (!probe.piece && !probe.lost) state.velocity = scene.motion.velocity.col(static_cast<Eigen::Index>(probe.point));
  if (!scene.body.exact) return;
  const auto& exact = scene.body.exact->displacement;
  const Vec2 origin = state.position - state.displacement;
  const double before = dt > 0.0 ? dt : -1e-6 * scene.settings.end_time;
  state.exact_displacement = exact(origin, t);
  state.exact_velocity = (exact(origin, t) - exact(origin, t - before)) / before;
}

void record_probes(DynamicScene& scene, double t, double dt) {
  record_probes(scene.body, t);
  for (Probe& probe : scene.body.probes) add_motion(scene, probe, t, dt);
}

void follow_kept(const std::vector<Index>& kept, std::vector<Probe>& probes) {
  for (Probe& probe : probes) {
    if (probe.piece || probe.lost) continue;
    const auto found = std::ranges::lower_bound(kept, static_cast<Index>(probe.point));
    probe.lost = found == kept.end() || *found != static_cast<Index>(probe.point);
    if (!probe.lost) probe.point = static_cast<std::size_t>(found - kept.begin());
  }
}

}  // namespace shoreline
