#pragma once
// A contribution: one effect of a scene, as its part of stiffness and force. A new effect is a new class.

#include <map>
#include <string>
#include <vector>

#include "shoreline/boundary/edge.hpp"
#include "shoreline/boundary/respacing.hpp"
#include "shoreline/engine/dilatation.hpp"
#include "shoreline/engine/element_blocks.hpp"
#include "shoreline/engine/material_points.hpp"

namespace shoreline {

/// What a load step balances: the increment of load alone, or the load less all that is carried already, (E.3).
enum class Loading { residual, incremental };

/// Where a load step evaluates functions and edges: where the body is by then, or where it was at the start. In the
/// second case all steps have the same stiffness.
enum class Geometry { updated, initial };

/// What every contribution sees at one load step: the state at its start, on the current curve.
struct StepState {
  const Basis& basis;
  const MaterialPoints& points;
  const PointSupports& supports;
  const std::vector<Edge>& edges;  ///< one a boundary piece
  Loading loading;
  double t;         ///< at the end of the step
  double t_before;  ///< at its start; 0 in the first step, before which nothing acts
  /// (2, functions) coefficients of the increment that pieces prescribe, (D.8) [m]; no columns where none does.
  const Eigen::Matrix2Xd& prescribed;
  const Dilatation* dilatation = nullptr;  ///< none where it is not projected, (I.3)

  /// A load that is prescribed as a function of time: its total (residual loading) or its increment, (E.3).
  template <class Value>
  [[nodiscard]] auto load(Value&& value) const {
    return loading == Loading::incremental ? increment(value) : value(t);
  }

  /// What a function of time gains in the step; in the first one, all of its value.
  template <class Value>
  [[nodiscard]] auto increment(Value&& value) const {
    auto gain = value(t);
    if (t_before > 0.0) gain -= value(t_before);
    return gain;
  }
};

/// Resultants by boundary piece (or effect): Fx, Fy, M about the origin [N, N, N m per metre of thickness].
struct Resultants {
  std::map<std::string, Vec3> loads;
  std::map<std::string, Vec3> reactions;
  std::map<std::string, double> displacement_errors;  ///< L2 against the exact solution, (N.5) [m^1.5]
};

/// (Fx, Fy, M about the origin) of a force at a point.
[[nodiscard]] inline Vec3 resultant(const Vec2& x, const Vec2& force) {
  return {force.x(), force.y(), cross(x, force)};
}

class Contribution {
 public:
  virtual ~Contribution() = default;

  [[nodiscard]] virtual std::string name() const = 0;

  /// What it evaluates, and where, in words: "values on the edge".
  [[nodiscard]] virtual std::string needs() const = 0;

  /// Appends blocks: tangent, and force = external − internal at the start of the step (residual loading) or the
  /// increment of external force (incremental loading).
  virtual void add(const StepState& step, ElementBlocks& blocks) const = 0;

  /// Takes note of the increment that the step found, before points and curves move.
  /// @param increment  (2, functions) Δd [m]
  virtual void accept(const StepState& step, const Eigen::Matrix2Xd& increment);

  /// Takes note that a piece has new tracking points: what was remembered at a place is at places(place) of the new
  /// curve.
  virtual void respace(int piece, const PlaceMap& places);

  /// Adds what acts at the end of the step to the resultants.
  virtual void report(Resultants& resultants) const;
};

}  // namespace shoreline
