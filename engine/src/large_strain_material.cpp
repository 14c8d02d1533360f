#include "shoreline/engine/large_strain_material.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstring>

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

  double lambda;
  double mu;
};

/// A tensor of one point (Number = double) or of four: a stress as (xx, yy, xy, zz), a matrix as (xx, yx, xy, yy).
template <class Number>
using Tensor = std::array<Number, 4>;

template <class To, class From>
To copied(const From& from) {
  To to;
  std::memcpy(to.data(), from.data(), sizeof(To));
  return to;
}

/// λ tr(ε) I + 2μ ε of a plane strain.
template <class Number>
SHORELINE_INLINE Tensor<Number> stress_of(const Lame& l, const Number& xx, const Number& yy, const Number& xy) {
  const Number volumetric = l.lambda * (xx + yy);
  return {volumetric + 2.0 * l.mu * xx, volumetric + 2.0 * l.mu * yy, 2.0 * l.mu * xy, volumetric};
}

/// (M.5).
template <class Number>
SHORELINE_INLINE Tensor<Number> linear_stress(const Lame& l, const Tensor<Number>& d) {
  return stress_of<Number>(l, d[0] - 1.0, d[3] - 1.0, 0.5 * (d[2] + d[1]));
}

inline double logarithm(double x) { return std::log(x); }
inline Lanes logarithm(const Lanes& x) { return Lanes{std::log(x[0]), std::log(x[1]), std::log(x[2]), std::log(x[3])}; }

/// (M.7).
template <class Number>
SHORELINE_INLINE Tensor<Number> neo_hookean_stress(const Lame& l, const Tensor<Number>& d) {
  const Number j = d[0] * d[3] - d[2] * d[1];
  const Number volumetric = l.lambda * logarithm(j) / j;
  const Number shear = l.mu / j;
  return {volumetric + shear * (d[0] * d[0] + d[2] * d[2] - 1.0),
          volumetric + shear * (d[1] * d[1] + d[3] * d[3] - 1.0), shear * (d[0] * d[1] + d[2] * d[3]), volumetric};
}

/// Stress after a rotation by half of an angle: Voigt components turn by twice of that.
template <class Number>
SHORELINE_INLINE Tensor<Number> half_turned(const Tensor<Number>& s, const Number& cosine, const Number& sine) {
  const Number mean = 0.5 * (s[0] + s[1]);
  const Number deviator = 0.5 * (s[0] - s[1]);
  const Number turned = deviator * cosine - s[2] * sine;
  return {mean + turned, mean - turned, deviator * sine + s[2] * cosine, s[3]};
}

/// (M.10).
template <class Number>
SHORELINE_INLINE Tensor<Number> hypoelastic_stress(const Lame& l, const Tensor<Number>& s, const Tensor<Number>& g) {
  const Number xx = 1.0 + 0.5 * g[0], yx = 0.5 * g[1], xy = 0.5 * g[2], yy = 1.0 + 0.5 * g[3];
  const Number inverse = 1.0 / (xx * yy - xy * yx);
  const Tensor<Number> middle{inverse * (g[0] * yy - g[2] * yx), inverse * (g[1] * yy - g[3] * yx),
                              inverse * (g[2] * xx - g[0] * xy), inverse * (g[3] * xx - g[1] * xy)};
  const Number tangent = 0.25 * (middle[1] - middle[2]);  // of half the angle of the turn
  const Number square = tangent * tangent;
  const Number cosine = (1.0 - square) / (1.0 + square);
  const Number sine = 2.0 * tangent / (1.0 + square);
  const Number half_growth = 0.5 * (middle[0] + middle[3]);
  Tensor<Number> sum = half_turned<Number>(s, cosine, sine);
  const Tensor<Number> strained = stress_of<Number>(l, middle[0], middle[3], 0.5 * (middle[2] + middle[1]));
  for (std::size_t k = 0; k < 4; ++k) sum[k] = ((1.0 - half_growth) * sum[k] + strained[k]) / (1.0 + half_growth);
  return half_turned<Number>(sum, cosine, sine);
}

SHORELINE_CLONES void update_linear(const Lame& l, std::span<LaneTensor> stress, std::span<const LaneTensor> d) {
  for (std::size_t k = 0; k < stress.size(); ++k) stress[k] = linear_stress<Lanes>(l, d[k]);
}

SHORELINE_CLONES void update_neo_hookean(const Lame& l, std::span<LaneTensor> stress, std::span<const LaneTensor> d) {
  for (std::size_t k = 0; k < stress.size(); ++k) stress[k] = neo_hookean_stress<Lanes>(l, d[k]);
}

SHORELINE_CLONES void update_hypoelastic(const Lame& l, std::span<LaneTensor> stress,
                                         std::span<const LaneTensor> increment) {
  for (std::size_t k = 0; k < stress.size(); ++k) stress[k] = hypoelastic_stress<Lanes>(l, stress[k], increment[k]);
}

class LinearLarge final : public LargeStrainMaterial {
 public:
  explicit LinearLarge(const Lame& lame) : lame_(lame) {}

  [[nodiscard]] std::string name() const override { return "linear_large"; }
  [[nodiscard]] Stress updated(const Stress&, const Mat2&, const Mat2& d) const override {
    return copied<Stress>(linear_stress(lame_, copied<Tensor<double>>(d)));
  }
  void update(std::span<LaneTensor> stress, std::span<const LaneTensor>, std::span<const LaneTensor> d) const override {
    update_linear(lame_, stress, d);
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
    return copied<Stress>(neo_hookean_stress(lame_, copied<Tensor<double>>(d)));
  }
  void update(std::span<LaneTensor> stress, std::span<const LaneTensor>, std::span<const LaneTensor> d) const override {
    update_neo_hookean(lame_, stress, d);
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

class Hypoelastic final : public LargeStrainMaterial {
 public:
  explicit Hypoelastic(const Lame& lame) : lame_(lame) {}

  [[nodiscard]] std::string name() const override { return "hypoelastic"; }
  [[nodiscard]] Stress updated(const Stress& s, const Mat2& increment, const Mat2&) const override {
    return copied<Stress>(hypoelastic_stress(lame_, copied<Tensor<double>>(s), copied<Tensor<double>>(increment)));
  }
  void update(std::span<LaneTensor> stress, std::span<const LaneTensor> increment,
              std::span<const LaneTensor>) const override {
    update_hypoelastic(lame_, stress, increment);
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

void LargeStrainMaterial::update(std::span<LaneTensor> stress, std::span<const LaneTensor> increment,
                                 std::span<const LaneTensor> deformation) const {
  const auto of = [](const LaneTensor& tensor, std::size_t l) {
    return Tensor<double>{tensor[0][l], tensor[1][l], tensor[2][l], tensor[3][l]};
  };
  for (std::size_t k = 0; k < stress.size(); ++k)
    for (std::size_t l = 0; l < lanes; ++l) {
      const Stress after = updated(copied<Stress>(of(stress[k], l)), copied<Mat2>(of(increment[k], l)),
                                   copied<Mat2>(of(deformation[k], l)));
      for (std::size_t c = 0; c < 4; ++c) stress[k][c][l] = after[static_cast<Eigen::Index>(c)];
    }
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
