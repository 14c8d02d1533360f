#pragma once
// Cells of tensor-product functions: what their points add up to, from moments of places instead of functions at them.

#include <array>
#include <span>

#include "shoreline/bases/basis.hpp"

namespace shoreline {

/// Functions of one direction of a cell, at most 4, and pairs of them.
inline constexpr int max_factors = 4;
inline constexpr int max_pairs = max_factors * max_factors;

/// Place of the pair (a, b) of two of the n functions of a direction where order matters, and where it does not.
constexpr int ordered(int a, int b, int n) { return a * n + b; }
constexpr int unordered(int a, int b) { return a >= b ? a * (a + 1) / 2 + b : unordered(b, a); }

/// Coefficients ((p + 1)²) of polynomials in ξ, function fastest, as those of polynomials in ξ − ½: powers of places
/// about the middle of a cell lose fewer digits.
[[nodiscard]] std::array<double, max_pairs> about_middle(int p, std::span<const double> coefficient);

/// Products of two of the p + 1 polynomials X_a of one direction of a cell as polynomials in ξ − ½: [power][pair]. What
/// is beyond the last pair is zero.
struct FactorPairs {
  template <int powers>
  using Coefficients = std::array<std::array<double, max_pairs>, powers>;

  Coefficients<2 * max_factors - 1> value{};  ///< X_a X_b, unordered
  Coefficients<2 * max_factors - 2> mixed{};  ///< X_a' X_b, ordered [1/m]
  Coefficients<2 * max_factors - 3> slope{};  ///< X_a' X_b', unordered [1/m²]

  /// Does nothing where the polynomials are those of the call before: they are the same in most cells.
  /// @param coefficient  ((p + 1)²) function fastest, then power of ξ
  /// @param size         of the cell in this direction [m]
  void make(int p, std::span<const double> coefficient, double size);

 private:
  std::array<double, max_pairs> made_of_{};
  double size_ = 0.0;
};

/// Σ V ∂φ_a ∂φ_b over the points of a cell for all functions a = (i, j), b = (k, l), (E.10): [pair in x][pair in y].
struct ProductMoments {
  using Plane = std::array<double, max_pairs * max_pairs>;
  alignas(32) Plane xx;  ///< ∂x ∂x, pairs unordered
  alignas(32) Plane xy;  ///< ∂x ∂y: pair (i, k) in x, (l, j) in y, ordered
  alignas(32) Plane yy;  ///< ∂y ∂y, pairs unordered
};

/// Where the sums of two functions stand in the planes of ProductMoments.
struct PairPlace {
  int same;    ///< in xx and yy
  int xy, yx;  ///< ∂x φ_a ∂y φ_b and ∂y φ_a ∂x φ_b, both in xy
};

/// Those of all functions a and b of a cell, (n² × n²) for n = p + 1.
template <int n>
constexpr std::array<std::array<PairPlace, n * n>, n * n> pair_places() {
  std::array<std::array<PairPlace, n * n>, n * n> places{};
  for (int a = 0; a < n * n; ++a)
    for (int b = 0; b < n * n; ++b) {
      const int i = a % n, j = a / n, k = b % n, l = b / n;
      places[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = {
          .same = max_pairs * unordered(i, k) + unordered(j, l),
          .xy = max_pairs * ordered(i, k, n) + ordered(l, j, n),
          .yx = max_pairs * ordered(k, i, n) + ordered(j, l, n)};
    }
  return places;
}

/// Σ w (ξ − ½)^r (η − ½)^s over points, 0 <= r, s < powers, (ξ, η) = (x − corner)/size. Groups of four points are
/// summed one after the other, then the four sums: the same whatever registers the processor has.
/// @param powers  3, 4, 5 or 7
/// @param weight  (points)
/// @param sum     (powers, powers), s fastest
void power_sums(int powers, const ProductCell& cell, std::span<const Vec2> x, std::span<const double> weight,
                double* sum);

/// @param p    2 or 3
/// @param sum  power_sums of the volumes with 2p + 1 powers
void multiply(int p, const FactorPairs& x, const FactorPairs& y, const double* sum, ProductMoments& moments);

}  // namespace shoreline
