#include "shoreline/engine/exact_solutions.hpp"

#include <array>
#include <cmath>
#include <string>

#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

/// What plane solutions depend on: shear modulus [Pa] and Kolosov's constant.
struct PlaneElasticity {
  double shear;
  double kolosov;

  explicit PlaneElasticity(const ElasticConstants& m)
      : shear(m.youngs_modulus / (2.0 * (1.0 + m.poissons_ratio))),
        kolosov(m.plane == Plane::strain ? 3.0 - 4.0 * m.poissons_ratio
                                         : (3.0 - m.poissons_ratio) / (1.0 + m.poissons_ratio)) {}
};

/// A solution under the full load, times the load factor.
template <class Displacement, class Stress>
ExactSolution scaled(std::function<double(double)> factor, Displacement displacement, Stress stress) {
  return {.displacement = [=](const Vec2& x, double t) -> Vec2 { return factor(t) * displacement(x); },
          .stress = [=](const Vec2& x, double t) -> Vec3 { return factor(t) * stress(x); }};
}

Vec2 kirsch_displacement(const PlateWithHole& plate, const PlaneElasticity& law, const Vec2& x) {
  const double a = plate.radius / x.norm();
  const double angle = std::atan2(x.y(), x.x());
  const double k = law.kolosov;
  const double far = 1.0 / a;
  const double near = 2.0 * (a - a * a * a);
  return plate.far_field_stress * plate.radius / (8.0 * law.shear) *
         Vec2((far * (k + 1.0) + 2.0 * a * (1.0 + k)) * std::cos(angle) + near * std::cos(3.0 * angle),
              (far * (k - 3.0) + 2.0 * a * (1.0 - k)) * std::sin(angle) + near * std::sin(3.0 * angle));
}

Vec3 kirsch_stress(const PlateWithHole& plate, const Vec2& x) {
  const double a2 = plate.radius * plate.radius / x.squaredNorm();
  const double angle = std::atan2(x.y(), x.x());
  const double c2 = std::cos(2.0 * angle), c4 = std::cos(4.0 * angle);
  const double s2 = std::sin(2.0 * angle), s4 = std::sin(4.0 * angle);
  const double near = 1.5 * a2 * a2;
  return plate.far_field_stress * Vec3(1.0 - a2 * (1.5 * c2 + c4) + near * c4,  //
                                       -a2 * (0.5 * c2 - c4) - near * c4,       //
                                       -a2 * (0.5 * s2 + s4) + near * s4);
}

void require_positive(double radius, const char* what) {
  if (!(radius > 0.0))
    throw InvalidArgument(std::string(what) + ": expected a radius > 0, got " + std::to_string(radius));
}

/// z²/2 − H z on [0, H], continued symmetrically about H and antisymmetrically about 0, and its derivative, (X.3).
struct Reflected {
  double value;
  double slope;

  Reflected(double z, double height) {
    z -= 4.0 * height * std::floor(z / (4.0 * height));
    const double sign = z < 2.0 * height ? 1.0 : -1.0;
    if (sign < 0.0) z -= 2.0 * height;
    value = sign * z * (0.5 * z - height);
    slope = sign * (z - height);
  }
};

}  // namespace

ExactSolution exact_solution(const ThickCylinder& problem, const ElasticConstants& material,
                             std::function<double(double)> factor) {
  require_positive(problem.inner_radius, "thick cylinder");
  if (!(problem.outer_radius > problem.inner_radius))
    throw InvalidArgument("thick cylinder: expected an outer radius > " + std::to_string(problem.inner_radius) +
                          ", got " + std::to_string(problem.outer_radius));
  const PlaneElasticity law(material);
  const double ratio = problem.outer_radius / problem.inner_radius;
  const double mean = problem.pressure / (ratio * ratio - 1.0);  // (σ_r + σ_θ)/2 [Pa]
  const auto b2 = [b = problem.outer_radius](const Vec2& x) { return b * b / x.squaredNorm(); };
  return scaled(
      std::move(factor),
      [=](const Vec2& x) -> Vec2 { return mean / (2.0 * law.shear) * (0.5 * (law.kolosov - 1.0) + b2(x)) * x; },
      [=](const Vec2& x) -> Vec3 {
        const double c2 = (x.x() * x.x() - x.y() * x.y()) / x.squaredNorm();
        const double s2 = 2.0 * x.x() * x.y() / x.squaredNorm();
        return mean * Vec3(1.0 - b2(x) * c2, 1.0 + b2(x) * c2, -b2(x) * s2);
      });
}

ExactSolution exact_solution(const PlateWithHole& problem, const ElasticConstants& material,
                             std::function<double(double)> factor) {
  require_positive(problem.radius, "plate with a hole");
  const PlaneElasticity law(material);
  return scaled(
      std::move(factor), [=](const Vec2& x) { return kirsch_displacement(problem, law, x); },
      [=](const Vec2& x) { return kirsch_stress(problem, x); });
}

ExactSolution exact_solution(const SelfWeightColumn& problem, const ElasticConstants& material) {
  if (!(problem.height > 0.0))
    throw InvalidArgument("self-weight column: expected a height > 0, got " + std::to_string(problem.height));
  const double nu = material.poissons_ratio;
  const double modulus = material.youngs_modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const double sideways = nu / (1.0 - nu);  // σ_xx/σ_yy
  const double speed = std::sqrt(modulus / problem.density);
  const double scale = problem.density * problem.gravity / modulus;
  const auto waves = [=, h = problem.height](double y, double t) {
    return std::array{Reflected(y, h), Reflected(y - speed * t, h), Reflected(y + speed * t, h)};
  };
  return {.displacement = [=](const Vec2& x, double t) -> Vec2 {
            const auto [rest, up, down] = waves(x.y(), t);
            return {0.0, scale * (rest.value - 0.5 * (up.value + down.value))};
          },
          .stress = [=](const Vec2& x, double t) -> Vec3 {
            const auto [rest, up, down] = waves(x.y(), t);
            const double stress = modulus * scale * (rest.slope - 0.5 * (up.slope + down.slope));
            return {sideways * stress, stress, 0.0};
          }};
}

}  // namespace shoreline
