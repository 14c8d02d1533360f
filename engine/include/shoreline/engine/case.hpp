#pragma once
// A case as plain data: read, checked, in SI units. The JSON ends in the reader that fills it.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "shoreline/boundary/conditions.hpp"
#include "shoreline/engine/contribution.hpp"
#include "shoreline/engine/exact_solutions.hpp"
#include "shoreline/engine/expression.hpp"
#include "shoreline/engine/fill.hpp"

namespace shoreline {

struct Case {
  /// @name Conditions as a case states them; scene.hpp turns them into boundary conditions.
  ///@{
  struct Free {};
  /// The value of the case's exact solution.
  struct FromExact {};
  struct Traction {
    std::variant<std::array<Quantity, 2>, FromExact> value;  ///< [Pa]
  };
  struct Pressure {
    Quantity value;  ///< [Pa]
  };
  /// A prescribed displacement: both components, or the one into the body alone (then support.normal_only).
  struct Displacement {
    std::variant<std::array<Quantity, 2>, Quantity, FromExact> value;  ///< [m]
    Essential support;                                                 ///< how it is held; its value is empty
  };
  using Condition = std::variant<Free, Traction, Pressure, Essential, Displacement>;
  ///@}

  struct Boundary {
    Piece piece;
    Condition condition;
  };
  struct Grid {
    Vec2 lower = Vec2::Zero();      ///< [m]
    Vec2 upper = Vec2::Zero();      ///< [m]
    Vec2 cell_size = Vec2::Zero();  ///< [m]; upper is moved out to whole cells
  };
  struct Material {
    double youngs_modulus = 0.0;  ///< [Pa]
    double poissons_ratio = 0.0;
    std::optional<double> density;  ///< [kg/m³]
  };
  struct ListedPoint {
    Vec2 position;  ///< [m]
    double volume;  ///< [m³ per metre of thickness]
  };
  using MaterialPoints = std::variant<LatticeFill, VertexFill, PolarFill, std::vector<ListedPoint>>;
  /// An exact solution by formulas, functions of the original position and t.
  struct ExactExpressions {
    std::array<Expression, 2> displacement;  ///< [m]
    std::array<Expression, 3> stress;        ///< xx, yy, xy [Pa]
  };
  using Exact = std::variant<ThickCylinder, PlateWithHole, ExactExpressions>;
  /// Asks for the history of the material point or tracking point that is nearest to a place at the start.
  struct Probe {
    std::string name;
    Vec2 position;  ///< [m]
  };
  struct Output {
    int every = 1;  ///< steps between saved ones; the last is always saved
    bool pictures = true;
  };

  std::filesystem::path file;
  std::string title;
  Plane plane = Plane::strain;
  Loading loading = Loading::residual;
  int load_steps = 1;
  std::optional<Expression> load;  ///< load factor, a formula of t, by which plain numbers ramp; else t itself
  Material material;
  Grid grid;
  std::vector<Boundary> boundaries;
  MaterialPoints material_points;
  std::optional<std::array<Quantity, 2>> body_force;  ///< [N/m³]
  std::optional<Vec2> gravity;                        ///< [m/s²]
  double ghost = 0.0;                                 ///< γ of the ghost penalty; 0: none is built
  std::optional<Exact> exact;
  std::vector<Probe> probes;
  double respacing = 0.0;  ///< tracking points are re-spaced where chords differ by more than this factor; 0: never
  int threads = 0;         ///< 0: all cores
  bool condition_estimate = false;
  Output output;
};

}  // namespace shoreline
