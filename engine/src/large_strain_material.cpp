#include "shoreline/engine/large_strain_material.hpp"

#include <Eigen/LU>
#include <cmath>

#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

struct Lame {
  Lame(double youngs_modulus, double poissons_ratio)
      : lambda(youngs_modulus * poissons_ratio / ((1.0 + poissons_ratio) * (1.0 - 2.0 * poissons_ratio))),
        mu(youngs_modulus / (2.0 * (1.0 + poissons_ratio))) {
    if (!(youngs_modulus > 0.0) || !std::isfinite(youngs_modulus))
      throw InvalidArgument("large-strain law: Young's modulus must be positive, got " +
                            std::to_string(youngs_modulus));
    if (!(poissons_ratio > -1.0 && poissons_ratio < 0.5))
      throw InvalidArgument("large-strain law: Poisson's ratio must lie in (-1, 0.5), got " +
                            std::to_string(poissons_ratio));
  }

  [[nodiscard]] double wave_modulus() const { return lambda + 2.0 * mu; }

  /// λ tr(ε) I + 2μ ε of a plane strain.
  [[nodiscard]] Stress stress(double xx, double yy, double xy) const {
    const double volumetric = lambda * (xx + yy);
    return {volumetric + 2.0 * mu * xx, volumetric + 2.0 * mu * yy, 2.0 * mu * xy, volumetric};
  }

  double lambda;
  double mu;
};

/// The update of many points by a law that is known here, which is inlined.
template <class Law>
void update_all(const Law& law, std::span<Stress> stress, std::span<const Mat2> increment,
                std::span<const Mat2> deformation) {
  for (std::size_t k = 0; k < stress.size(); ++k) stress[k] = law.updated(stress[k], increment[k], deformation[k]);
}

class LinearLarge final : public LargeStrainMaterial {
 public:
  explicit LinearLarge(const Lame& lame) : lame_(lame) {}

  [[nodiscard]] std::string name() const override { return "linear_large"; }
  [[nodiscard]] Stress updated(const Stress&, const Mat2&, const Mat2& d) const override {
    return lame_.stress(d(0, 0) - 1.0, d(1, 1) - 1.0, 0.5 * (d(0, 1) + d(1, 0)));
  }
  void update(std::span<Stress> stress, std::span<const Mat2> increment,
              std::span<const Mat2> deformation) const override {
    update_all(*this, stress, increment, deformation);
  }
  [[nodiscard]] double energy(const Stress& s, const Mat2& d) const override {
    return 0.5 * (s[0] * (d(0, 0) - 1.0) + s[1] * (d(1, 1) - 1.0) + s[2] * (d(0, 1) + d(1, 0)));
  }
  [[nodiscard]] bool objective() const override { return false; }
  [[nodiscard]] double wave_modulus() const override { return lame_.wave_modulus(); }

 private:
  Lame lame_;
};

class NeoHookean final : public LargeStrainMaterial {
 public:
  explicit NeoHookean(const Lame& lame) : lame_(lame) {}

  [[nodiscard]] std::string name() const override { return "neo_hookean"; }
  [[nodiscard]] Stress updated(const Stress&, const Mat2&, const Mat2& d) const override {
    const double j = d.determinant();
    const double volumetric = lame_.lambda * std::log(j) / j;
    const double shear = lame_.mu / j;
    return {volumetric + shear * (d.row(0).squaredNorm() - 1.0), volumetric + shear * (d.row(1).squaredNorm() - 1.0),
            shear * d.row(0).dot(d.row(1)), volumetric};
  }
  void update(std::span<Stress> stress, std::span<const Mat2> increment,
              std::span<const Mat2> deformation) const override {
    update_all(*this, stress, increment, deformation);
  }
  [[nodiscard]] double energy(const Stress&, const Mat2& d) const override {
    const double log_j = std::log(d.determinant());
    return 0.5 * lame_.mu * (d.squaredNorm() - 2.0 - 2.0 * log_j) + 0.5 * lame_.lambda * log_j * log_j;
  }
  [[nodiscard]] bool objective() const override { return true; }
  [[nodiscard]] double wave_modulus() const override { return lame_.wave_modulus(); }

 private:
  Lame lame_;
};

/// Stress after a rotation by half of an angle: Voigt components turn by twice of that.
Stress half_turned(const Stress& s, double cosine, double sine) {
  const double mean = 0.5 * (s[0] + s[1]);
  const double deviator = 0.5 * (s[0] - s[1]);
  const double turned = deviator * cosine - s[2] * sine;
  return {mean + turned, mean - turned, deviator * sine + s[2] * cosine, s[3]};
}

class Hypoelastic final : public LargeStrainMaterial {
 public:
  explicit Hypoelastic(const Lame& lame) : lame_(lame) {}

  [[nodiscard]] std::string name() const override { return "hypoelastic"; }
  [[nodiscard]] Stress updated(const Stress& s, const Mat2& increment, const Mat2&) const override {
    const Mat2 middle = increment * (Mat2::Identity() + 0.5 * increment).inverse();
    const double tangent = 0.25 * (middle(1, 0) - middle(0, 1));  // of half the angle of the turn
    const double cosine = (1.0 - tangent * tangent) / (1.0 + tangent * tangent);
    const double sine = 2.0 * tangent / (1.0 + tangent * tangent);
    const double half_growth = 0.5 * middle.trace();
    const Stress strained = lame_.stress(middle(0, 0), middle(1, 1), 0.5 * (middle(0, 1) + middle(1, 0)));
    return half_turned(((1.0 - half_growth) * half_turned(s, cosine, sine) + strained) / (1.0 + half_growth), cosine,
                       sine);
  }
  void update(std::span<Stress> stress, std::span<const Mat2> increment,
              std::span<const Mat2> deformation) const override {
    update_all(*this, stress, increment, deformation);
  }
  [[nodiscard]] double energy(const Stress& s, const Mat2& d) const override {
    const double trace = (s[0] + s[1]) / (2.0 * (lame_.lambda + lame_.mu));  // of the strain C⁻¹ σ
    const double half = 0.5 / lame_.mu;
    const double xx = half * (s[0] - lame_.lambda * trace);
    const double yy = half * (s[1] - lame_.lambda * trace);
    return 0.5 * d.determinant() * (s[0] * xx + s[1] * yy + 2.0 * half * s[2] * s[2]);
  }
  [[nodiscard]] bool objective() const override { return true; }
  [[nodiscard]] double wave_modulus() const override { return lame_.wave_modulus(); }

 private:
  Lame lame_;
};

}  // namespace

void LargeStrainMaterial::update(std::span<Stress> stress, std::span<const Mat2> increment,
                                 std::span<const Mat2> deformation) const {
  update_all(*this, stress, increment, deformation);
}

std::unique_ptr<LargeStrainMaterial> linear_large(double youngs_modulus, double poissons_ratio) {
  return std::make_unique<LinearLarge>(Lame(youngs_modulus, poissons_ratio));
}

std::unique_ptr<LargeStrainMaterial> neo_hookean(double youngs_modulus, double poissons_ratio) {
  return std::make_unique<NeoHookean>(Lame(youngs_modulus, poissons_ratio));
}

std::unique_ptr<LargeStrainMaterial> hypoelastic(double youngs_modulus, double poissons_ratio) {
  return std::make_unique<Hypoelastic>(Lame(youngs_modulus, poissons_ratio));
}

}  // namespace shoreline
