#pragma once
// A case as plain data: read, checked, in SI units. The JSON ends in the reader that fills it.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "shoreline/boundary/conditions.hpp"
#include "shoreline/engine/expression.hpp"

namespace shoreline {

enum class Plane { strain, stress };

/// What a load step balances: the increment of load alone, or the load less all that is carried already, (E.3).
enum class Loading { residual, incremental };

/// How the volumes of material points follow from the outline.
enum class VolumeRule {
  lattice,  ///< points inside keep the whole sub-cell
  clipped   ///< a point sits at the centroid of its clipped sub-cell and has its area
};

struct Case {
  /// @name Conditions as a case states them; scene.hpp turns them into boundary conditions.
  ///@{
  struct Free {};
  struct Traction {
    std::array<Quantity, 2> value;  ///< [Pa]
  };
  struct Pressure {
    Quantity value;  ///< [Pa]
  };
  using Condition = std::variant<Free, Traction, Pressure, Essential>;
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
  /// Points on the centres of the sub-cells of every cell.
  struct LatticeFill {
    std::array<int, 2> per_cell;
    VolumeRule volumes;
  };
  /// Points on the nodes of a lattice whose outer layer lies on the outline.
  struct VertexFill {
    std::array<int, 2> per_cell{};
    bool adjusted = true;  ///< halves on edges, quarters at corners; else every point has the whole sub-cell
  };
  struct ListedPoint {
    Vec2 position;  ///< [m]
    double volume;  ///< [m³ per metre of thickness]
  };
  using MaterialPoints = std::variant<LatticeFill, VertexFill, std::vector<ListedPoint>>;
  /// An exact solution, functions of the original position and t.
  struct Exact {
    std::array<Expression, 2> displacement;  ///< [m]
    std::array<Expression, 3> stress;        ///< xx, yy, xy [Pa]
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
  Material material;
  Grid grid;
  std::vector<Boundary> boundaries;
  MaterialPoints material_points;
  std::optional<std::array<Quantity, 2>> body_force;  ///< [N/m³]
  std::optional<Vec2> gravity;                        ///< [m/s²]
  double ghost = 0.0;                                 ///< γ of the ghost penalty; 0: none is built
  std::optional<Exact> exact;
  int threads = 0;  ///< 0: all cores
  bool condition_estimate = false;
  Output output;
};

}  // namespace shoreline
