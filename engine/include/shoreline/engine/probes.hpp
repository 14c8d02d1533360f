#pragma once
// Probes: the history of single points of the body.

#include <optional>
#include <string>
#include <vector>

#include "shoreline/engine/material.hpp"
#include "shoreline/engine/material_points.hpp"

namespace shoreline {

struct Case;
struct Scene;

/// One point of the body at the end of a step.
struct ProbeState {
  double t;
  Vec2 position;                             ///< [m]
  Vec2 displacement;                         ///< since the start [m]
  std::optional<Stress> stress;              ///< [Pa]; not of tracking points
  std::optional<Vec2> velocity{};            ///< [m/s]; dynamics alone
  std::optional<Vec2> exact_displacement{};  ///< [m]; dynamics with an exact solution alone
  std::optional<Vec2> exact_velocity{};      ///< [m/s]; dynamics with an exact solution alone
};

/// A point that is followed, and where it has been.
struct Probe {
  std::string name;
  std::optional<std::size_t> piece;  ///< whose tracking point it is; none: a material point or a place
  std::size_t point;                 ///< number of the material point, of the tracking point on its piece, or the place
  std::vector<ProbeState> history;   ///< from the start on, one a step; all hold the same fields
  bool lost = false;                 ///< its material point was dropped: it stays where it was last
  bool at_place = false;             ///< it follows the material that was at its very place, Scene::places
};

/// What a probe follows, in words: "material point", "tracking point" or "place".
[[nodiscard]] const char* followed_by(const Probe& probe);

/// The places of the probes that follow the material there, as points without volume; none where no probe does.
///
/// @throws CaseError with the first place that lies neither in the body nor as near to its outline as a listed material
///         point must
[[nodiscard]] std::optional<MaterialPoints> places_of_probes(const Case& problem, const Scene& scene);

/// The probes of a case at the start: each the nearest of all material points and tracking points, or at its place.
///
/// Of points that are equally near (to 1e-9 of a cell) a material point comes first, then the earlier piece.
///
/// @pre scene.places are those of the case
/// @throws CaseError with the probe where its tracking point may be re-spaced: it would not stay with the material
[[nodiscard]] std::vector<Probe> place_probes(const Case& problem, const Scene& scene);

/// Appends the present state to the history of every probe of a scene.
void record_probes(Scene& scene, double t);

}  // namespace shoreline
