#pragma once
// The boundary conditions of a piece: a closed family.

#include <functional>
#include <variant>

#include "shoreline/boundary/trace.hpp"

namespace shoreline {

/// Nothing acts on the piece.
struct Free {};

/// A traction on the body [Pa] at a boundary point and time.
struct Traction {
  std::function<Vec2(const BoundaryPoint&, double)> value;
};

/// A pressure that pushes into the body and follows it [Pa]: the traction p n, n inward.
struct Pressure {
  std::function<double(const BoundaryPoint&, double)> value;
};

/// How an essential condition enters the equations.
enum class EssentialMethod {
  implicit_boundary,  ///< penalty of a D-function's band with half of the boundary traction (c = ½), (D.4)
  nitsche,            ///< the same with the whole traction (c = 1): consistent
  grid                ///< coefficients on the piece are eliminated; it must lie on grid lines
};

/// The displacement of the piece, or its component across the piece, is zero or prescribed.
struct Essential {
  bool normal_only = false;  ///< roller: the tangential displacement is free
  EssentialMethod method = EssentialMethod::implicit_boundary;
  double band = 1e-3;    ///< δ/h, width of the band in cells; unused by grid
  bool narrows = false;  ///< the band becomes as narrow as (D.10) asks where a thin layer lies behind the edge
  /// Prescribed displacement since the start at a boundary point and time [m]; empty: zero.
  std::function<Vec2(const BoundaryPoint&, double)> value{};
};

using Condition = std::variant<Free, Traction, Pressure, Essential>;

/// One visitor from several lambdas.
template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

}  // namespace shoreline
