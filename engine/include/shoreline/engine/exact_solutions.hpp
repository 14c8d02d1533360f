#pragma once
// Exact solutions of linear elasticity against which errors are measured.

#include <functional>

#include "shoreline/engine/linear_elastic.hpp"

namespace shoreline {

/// An exact solution as a function of the original position and time.
struct ExactSolution {
  std::function<Vec2(const Vec2&, double)> displacement;  ///< [m]
  std::function<Vec3(const Vec2&, double)> stress;        ///< xx, yy, xy [Pa]
};

/// A ring about the origin under internal pressure.
struct ThickCylinder {
  double inner_radius;  ///< a > 0 [m]
  double outer_radius;  ///< b > a [m]
  double pressure;      ///< p [Pa]
};

/// An unbounded plate with a circular hole about the origin, pulled along x.
struct PlateWithHole {
  double radius;            ///< a > 0 [m]
  double far_field_stress;  ///< S [Pa]
};

/// A column of height H on a fixed base, between smooth walls, onto which gravity is let at t = 0.
struct SelfWeightColumn {
  double height;   ///< H > 0 [m]; the base lies at y = 0
  double density;  ///< ρ at the start [kg/m³]
  double gravity;  ///< g, downward [m/s²]
};

/// The constants that exact solutions depend on.
struct ElasticConstants {
  double youngs_modulus;  ///< E [Pa]
  double poissons_ratio;  ///< ν
  Plane plane;
};

/// Lamé's solution, (X.1), times a load factor.
/// @param factor  of the pressure, at time t
/// @throws InvalidArgument if not 0 < a < b
[[nodiscard]] ExactSolution exact_solution(const ThickCylinder& problem, const ElasticConstants& material,
                                           std::function<double(double)> factor);

/// Kirsch's solution, (X.2), times a load factor. Inside the hole its formulas are continued, but not at the centre.
/// @throws InvalidArgument if not a > 0
[[nodiscard]] ExactSolution exact_solution(const PlateWithHole& problem, const ElasticConstants& material,
                                           std::function<double(double)> factor);

/// The vibration of the column with σ = λ tr(E) I + 2μ E, at any amplitude, (X.3); u_x = 0.
/// @throws InvalidArgument if not H > 0
[[nodiscard]] ExactSolution exact_solution(const SelfWeightColumn& problem, const ElasticConstants& material);

}  // namespace shoreline
