#pragma once
// The error estimate as a part of a run, of load steps and of time steps.

#include <fmt/format.h>

#include "shoreline/engine/error_estimate.hpp"
#include "shoreline/engine/scene.hpp"
#include "timed_effect.hpp"

namespace shoreline {

/// Puts the estimate into the record of a run, and a warning where there are too few points for it: the recovered
/// stress can then follow whatever they carry.
/// @param supports  where the last step found its strains
template <class Record>
void estimate_at_end(const Scene& scene, const PointSupports& supports, Record& record) {
  record.error_estimate = timed_effect(record, "estimate", "error_estimate",
                                       [&] { return error_estimate(*scene.basis, scene.points, supports); });
  const Index functions = record.error_estimate->functions;
  if (scene.points.size() >= 2 * functions) return;
  record.warnings.push_back(
      fmt::format("the error of the stress cannot be estimated from {} material points for {} functions, expected at "
                  "least two points a function: what is recovered follows the points, and the estimate is far too "
                  "small. Raise material_points.per_cell",
                  scene.points.size(), functions));
}

}  // namespace shoreline
