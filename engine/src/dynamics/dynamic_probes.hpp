#pragma once
// Probes of a body in motion.

#include "shoreline/engine/dynamics.hpp"

namespace shoreline {

/// Adds velocity, and what is exact, to the last state of a probe.
/// @param dt  of the step that led there [s]; 0 at the start
void add_motion(const DynamicScene& scene, Probe& probe, double t, double dt);

/// Appends the present state to the history of every probe.
void record_probes(DynamicScene& scene, double t, double dt);

/// Renumbers the points of probes when points are dropped; a probe whose point is gone stays where it was last.
/// @param kept  numbers of the points that are not dropped, ascending
void follow_kept(const std::vector<Index>& kept, std::vector<Probe>& probes);

}  // namespace shoreline
