#pragma once
// A case as plain data: read, checked, in SI units. The JSON ends in the reader that fills it.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "shoreline/bases/mesh_generators.hpp"
#include "shoreline/bases/projection.hpp"
#include "shoreline/boundary/conditions.hpp"
#include "shoreline/engine/contribution.hpp"
#include "shoreline/engine/exact_solutions.hpp"
#include "shoreline/engine/expression.hpp"
#include "shoreline/engine/fill.hpp"
#include "shoreline/engine/solver_choice.hpp"

namespace shoreline {

/// Load steps in equilibrium.
struct QuasiStatic {
  Loading loading = Loading::residual;
  int load_steps = 1;
  Geometry geometry = Geometry::updated;
  std::optional<Expression> load{};  ///< load factor, a formula of t, by which plain numbers ramp; else t itself
};

/// The L2 projection of one field onto the basis.
struct Projection {
  std::variant<Expression, std::vector<double>> value;  ///< a function of place, or one number a listed point
  std::optional<std::array<Expression, 2>> gradient{};  ///< of the function, for the errors of the derivatives
  Mass mass = Mass::consistent;
  bool at_points = false;  ///< weights are the volumes of the case's material points; else integrals over all cells
};

/// The form of the mass matrix, (Y.5)–(Y.7).
enum class MassForm { consistent, lumped, partly_lumped };

/// As a case names it.
[[nodiscard]] constexpr const char* name_of(MassForm mass) {
  return mass == MassForm::consistent ? "consistent" : mass == MassForm::lumped ? "lumped" : "partly_lumped";
}

/// Time steps by explicit dynamics.
struct ExplicitDynamics {
  std::optional<double> time_step{};  ///< [s]; none: a share of the critical step, found anew as it changes
  double safety = 0.7;                ///< that share
  double end_time = 0.0;              ///< [s]
  MassForm mass = MassForm::lumped;
  double ghost = 0.0;         ///< γ of the ghost mass, (G.4); 0: none
  double pic = 0.0;           ///< share of the projected velocity in that of a point: 0 is flip, 1 is pic
  double damping = 0.0;       ///< α of local damping, (Y.12)
  bool drop_outside = false;  ///< points that leave the grid are dropped; else they end the run
};

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
  enum class BasisType { bilinear, bspline, linear, powell_sabin };
  struct Grid {
    Vec2 lower = Vec2::Zero();      ///< [m]
    Vec2 upper = Vec2::Zero();      ///< [m]
    Vec2 cell_size = Vec2::Zero();  ///< of the rectangles [m]; upper is moved out to whole ones
    BasisType basis = BasisType::bilinear;
    int degree = 2;                                       ///< of a tensor-product B-spline
    TrianglePattern pattern = TrianglePattern::diagonal;  ///< how triangle bases cut the rectangles
    std::shared_ptr<const TriangleMesh> mesh{};           ///< triangles instead of cut rectangles
  };
  enum class Law { linear_elastic, linear_large, neo_hookean, hypoelastic };
  struct Material {
    Law law = Law::linear_elastic;
    double youngs_modulus = 0.0;  ///< [Pa]
    double poissons_ratio = 0.0;
    std::optional<double> density;      ///< [kg/m³]
    bool projected_dilatation = false;  ///< (I.3); plane strain
  };
  struct ListedPoint {
    Vec2 position;  ///< [m]
    double volume;  ///< [m³ per metre of thickness]
  };
  using MaterialPoints =
      std::variant<LatticeFill, BlockFill, AcrossFill, VertexFill, PolarFill, RandomFill, std::vector<ListedPoint>>;
  /// An exact solution by formulas, functions of the original position and t.
  struct ExactExpressions {
    std::array<Expression, 2> displacement;  ///< [m]
    std::array<Expression, 3> stress;        ///< xx, yy, xy [Pa]
  };
  using Exact = std::variant<ThickCylinder, PlateWithHole, SelfWeightColumn, ExactExpressions>;
  /// Asks for the history of the material point or tracking point that is nearest to a place at the start.
  struct Probe {
    std::string name;
    Vec2 position;          ///< [m]
    bool at_place = false;  ///< instead of the material at that very place; load steps alone
  };
  struct Output {
    int every = 1;  ///< steps between saved ones, the last is always saved; 0: every fiftieth of the time in dynamics
    bool strain = true;  ///< saved with the material points, which else keep none
    bool pictures = true;
  };

  std::filesystem::path file;
  std::string title;
  Plane plane = Plane::strain;
  std::variant<QuasiStatic, Projection, ExplicitDynamics> analysis;
  Material material;
  Grid grid;
  std::vector<Boundary> boundaries;
  MaterialPoints material_points;
  bool fitted = false;                                ///< the points' weights are fitted to the outline at every step
  std::optional<std::array<Quantity, 2>> body_force;  ///< [N/m³]
  std::optional<Vec2> gravity;                        ///< [m/s²]
  /// @name Dynamics alone.
  ///@{
  std::optional<std::array<Expression, 2>> gravity_field;     ///< gravity as formulas, instead of numbers [m/s²]
  std::optional<std::array<Expression, 2>> initial_velocity;  ///< [m/s]
  std::optional<int> history;  ///< steps from one record of energies, momentum and probes to the next
  ///@}
  double ghost = 0.0;  ///< γ of the ghost penalty; 0: none is built
  std::optional<Exact> exact;
  std::optional<int> samples;  ///< errors are measured at so many sample points along the body, not its material points
  std::vector<Probe> probes;
  double respacing = 0.0;  ///< tracking points are re-spaced where chords differ by more than this factor; 0: never
  int threads = 0;         ///< 0: all cores
  SolverType solver = SolverType::automatic;
  /// Measured where a case asks for them under `diagnostics`.
  bool condition_estimate = false, cut_fractions = false, strain_energy = false, error_estimate = false;
  Output output;
};

}  // namespace shoreline
