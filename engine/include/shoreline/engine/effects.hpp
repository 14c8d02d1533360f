#pragma once
// The effects that a scene can hold, each a contribution of its own file.

#include <functional>
#include <memory>

#include "shoreline/boundary/conditions.hpp"
#include "shoreline/engine/contribution.hpp"
#include "shoreline/engine/expression.hpp"
#include "shoreline/engine/material.hpp"

namespace shoreline {

/// The material: K = Σ Bᵀ D B V and internal force Σ Bᵀ σ V, (E.1).
[[nodiscard]] std::unique_ptr<Contribution> stiffness_of(std::shared_ptr<const Material> material);

/// The part of the stiffness that resists the projected dilatation, λ 𝐆ᵀ𝐆 of every patch, (I.5). The other effects of
/// the scene take a law without λ; their internal forces are those of the whole stress.
/// @pre StepState::dilatation
[[nodiscard]] std::unique_ptr<Contribution> projected_dilatation();

/// A force per volume at the material points, f = Σ Mᵀ b V, (E.2).
/// @param value  b at a place and time [N/m³]
[[nodiscard]] std::unique_ptr<Contribution> body_force(std::function<Vec2(const PlaceTime&)> value);

/// A traction on one boundary piece, f = ∫ Mᵀ t dS, (B.7).
/// @param piece  number of the piece
[[nodiscard]] std::unique_ptr<Contribution> traction_on(int piece, std::string piece_name, Traction traction);

/// A pressure on one boundary piece, the traction p n, n inward, (B.8).
[[nodiscard]] std::unique_ptr<Contribution> pressure_on(int piece, std::string piece_name, Pressure pressure);

/// A piece held, or moved as prescribed, by the implicit boundary method or Nitsche's, (D.4), (D.9).
/// @param gamma  γ of the scene's ghost penalty, by which a band that narrows does, (D.10)
/// @pre condition.method is not grid
[[nodiscard]] std::unique_ptr<Contribution> essential_on(int piece, std::string piece_name, Essential condition,
                                                         std::shared_ptr<const Material> material, double gamma = 0.0);

/// A displacement at a boundary point and time [m].
using DisplacementOnPiece = std::function<Vec2(const BoundaryPoint&, double)>;

/// Follows the displacement of an essential piece and measures its error, √(∫ |P(u_h − u)|² dS), (N.5). Adds nothing to
/// the equations.
/// @param normal_only  P = n nᵀ (roller), else I
[[nodiscard]] std::unique_ptr<Contribution> boundary_error(int piece, std::string piece_name, bool normal_only,
                                                           DisplacementOnPiece exact);

/// Ghost penalty over the faces of elements at the boundary, (G.1), on jumps of the derivatives of order p of a basis
/// of degree p whose lower derivatives are continuous.
/// @param gamma  γ > 0
[[nodiscard]] std::unique_ptr<Contribution> ghost_penalty(double gamma, std::shared_ptr<const Material> material);

}  // namespace shoreline
