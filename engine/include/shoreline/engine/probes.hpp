#pragma once
// Probes: the history of single points of the body.

#include <optional>
#include <string>
#include <vector>

#include "shoreline/engine/material.hpp"

namespace shoreline {

struct Case;
struct Scene;

/// One point of the body at the end of a step.
struct ProbeState {
  double t;
  Vec2 position;                             ///< [m]
  Vec2 displacement;                         ///< since the start [m]
  std::optional<Stress> stress;              ///< [Pa]; of material points alone
  std::optional<Vec2> velocity{};            ///< [m/s]; dynamics alone
  std::optional<Vec2> exact_displacement{};  ///< [m]; dynamics with an exact solution alone
  std::optional<Vec2> exact_velocity{};      ///< [m/s]; dynamics with an exact solution alone
};

/// A point that is followed, and where it has been.
struct Probe {
  std::string name;
  std::optional<std::size_t> piece;  ///< whose tracking point it is; none: a material point
  std::size_t point;                 ///< number of the material point, or of the tracking point on its piece
  std::vector<ProbeState> history;   ///< from the start on, one a step; all hold the same fields
  bool lost = false;                 ///< its material point was dropped: it stays where it was last
};

/// The probes of a case at the start: each the nearest of all material points and tracking points.
///
/// Of points that are equally near (to 1e-9 of a cell) a material point comes first, then the earlier piece.
///
/// @throws CaseError with the probe where its tracking point may be re-spaced: it would not stay with the material
[[nodiscard]] std::vector<Probe> place_probes(const Case& problem, const Scene& scene);

/// Appends the present state to the history of every probe of a scene.
void record_probes(Scene& scene, double t);

}  // namespace shoreline
