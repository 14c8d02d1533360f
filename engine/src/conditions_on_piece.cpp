#include "conditions_on_piece.hpp"

#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

using VectorOnPiece = std::function<Vec2(const BoundaryPoint&, double)>;
using NumberOnPiece = std::function<double(const BoundaryPoint&, double)>;

/// Original position of the material at a boundary point.
Vec2 origin(const SplineCurve& original, const BoundaryPoint& p) {
  return original.spans[static_cast<std::size_t>(p.span)].position(p.u);
}

NumberOnPiece on_piece(const Quantity& value, const OnPiece& where) {
  return [value, curve = where.original, ramp = where.factor](const BoundaryPoint& p, double t) {
    return value(PlaceTime{p.x, origin(*curve, p), t, ramp(t)});
  };
}

VectorOnPiece on_piece(const std::array<Quantity, 2>& value, const OnPiece& where) {
  return [x = on_piece(value[0], where), y = on_piece(value[1], where)](const BoundaryPoint& p, double t) {
    return Vec2(x(p, t), y(p, t));
  };
}

const ExactSolution& exact_of(const OnPiece& where) {
  if (!where.exact) throw InvalidArgument("a condition takes its value from an exact solution, and there is none");
  return *where.exact;
}

/// σ ν of an exact stress.
VectorOnPiece exact_traction(const OnPiece& where) {
  return [stress = exact_of(where).stress, curve = where.original](const BoundaryPoint& p, double t) -> Vec2 {
    const Vec3 s = stress(origin(*curve, p), t);
    return -Vec2(s[0] * p.normal.x() + s[2] * p.normal.y(), s[2] * p.normal.x() + s[1] * p.normal.y());
  };
}

Essential prescribed(const Case::Displacement& c, const OnPiece& where) {
  Essential condition = c.support;
  condition.value = std::visit(
      Overloaded{
          [&](const std::array<Quantity, 2>& value) { return on_piece(value, where); },
          [&](const Quantity& normal) -> VectorOnPiece {
            return [value = on_piece(normal, where)](const BoundaryPoint& p, double t) -> Vec2 {
              return value(p, t) * p.normal;
            };
          },
          [&](const Case::FromExact&) -> VectorOnPiece { return exact_displacement(where.original, exact_of(where)); }},
      c.value);
  return condition;
}

}  // namespace

DisplacementOnPiece exact_displacement(std::shared_ptr<const SplineCurve> original, const ExactSolution& exact) {
  return [displacement = exact.displacement, curve = std::move(original)](const BoundaryPoint& p, double t) {
    return displacement(origin(*curve, p), t);
  };
}

Condition to_condition(const Case::Condition& condition, const OnPiece& where) {
  const auto traction = Overloaded{[&](const std::array<Quantity, 2>& value) { return on_piece(value, where); },
                                   [&](const Case::FromExact&) { return exact_traction(where); }};
  return std::visit(
      Overloaded{[](const Case::Free&) -> Condition { return Free{}; },
                 [&](const Case::Traction& c) -> Condition { return Traction{std::visit(traction, c.value)}; },
                 [&](const Case::Pressure& c) -> Condition { return Pressure{on_piece(c.value, where)}; },
                 [](const Essential& c) -> Condition { return c; },
                 [&](const Case::Displacement& c) -> Condition { return prescribed(c, where); }},
      condition);
}

}  // namespace shoreline
