#pragma once
// Four points side by side, on which processors work at once.

#include <array>
#include <cstddef>

/// Before a function: compiled for plain x86-64 and again for wider registers, of which the processor at hand chooses.
/// Every clone does the same additions and multiplications in the same order, so they agree to the last digit.
/// Functions that it calls gain by it only where they are inlined: SHORELINE_INLINE, and SHORELINE_INLINED for lambdas.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define SHORELINE_CLONES __attribute__((target_clones("default", "avx2")))
#else
#define SHORELINE_CLONES
#endif
#define SHORELINE_INLINED __attribute__((always_inline))
#define SHORELINE_INLINE SHORELINE_INLINED inline

namespace shoreline {

/// Points side by side.
inline constexpr std::size_t lanes = 4;

/// One number of each of four points. Aligned for the widest registers, which the bare vector is not everywhere.
struct alignas(lanes * sizeof(double)) Lanes {
  using Vector = double __attribute__((vector_size(lanes * sizeof(double))));

  Lanes() = default;
  SHORELINE_INLINE Lanes(const Lanes& other) : v(other.v) {}  // as a vector: the implicit copy goes through memory
  SHORELINE_INLINE Lanes(Vector vector) : v(vector) {}
  SHORELINE_INLINE Lanes(double all) : v{all, all, all, all} {}
  SHORELINE_INLINE Lanes(double a, double b, double c, double d) : v{a, b, c, d} {}

  SHORELINE_INLINE Lanes& operator=(const Lanes& other) {
    v = other.v;
    return *this;
  }
  [[nodiscard]] SHORELINE_INLINE double operator[](std::size_t lane) const { return v[lane]; }
  [[nodiscard]] SHORELINE_INLINE double& operator[](std::size_t lane) { return reinterpret_cast<double*>(&v)[lane]; }

  SHORELINE_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.v + b.v; }
  SHORELINE_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.v - b.v; }
  SHORELINE_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.v * b.v; }
  SHORELINE_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.v / b.v; }
  SHORELINE_INLINE friend Lanes operator-(const Lanes& a) { return -a.v; }
  SHORELINE_INLINE Lanes& operator+=(const Lanes& b) {
    v += b.v;
    return *this;
  }
  SHORELINE_INLINE friend auto operator==(const Lanes& a, const Lanes& b) { return a.v == b.v; }
  SHORELINE_INLINE friend auto operator<(const Lanes& a, const Lanes& b) { return a.v < b.v; }
  SHORELINE_INLINE friend auto operator<=(const Lanes& a, const Lanes& b) { return a.v <= b.v; }
  SHORELINE_INLINE friend auto operator>(const Lanes& a, const Lanes& b) { return a.v > b.v; }
  SHORELINE_INLINE friend auto operator>=(const Lanes& a, const Lanes& b) { return a.v >= b.v; }

  Vector v;
};
/// x and y of four points.
using LanePoint = std::array<Lanes, 2>;
/// A stress (xx, yy, xy, zz) or a matrix (xx, yx, xy, yy) of four points.
using LaneTensor = std::array<Lanes, 4>;

/// Four numbers that lie anywhere. (Copied by memcpy, they may be taken in halves, for which the next load has to
/// wait.)
using LooseLanes = double __attribute__((vector_size(lanes * sizeof(double)), aligned(sizeof(double)), may_alias));
SHORELINE_INLINE const LooseLanes* lanes_at(const double* from) { return reinterpret_cast<const LooseLanes*>(from); }
SHORELINE_INLINE LooseLanes* lanes_at(double* to) { return reinterpret_cast<LooseLanes*>(to); }

/// Four numbers of each of four points: from the points' order to that of lanes, or back.
SHORELINE_INLINE LaneTensor transposed(const LaneTensor& row) {
  const auto even_01 = __builtin_shufflevector(row[0].v, row[1].v, 0, 4, 2, 6);
  const auto odd_01 = __builtin_shufflevector(row[0].v, row[1].v, 1, 5, 3, 7);
  const auto even_23 = __builtin_shufflevector(row[2].v, row[3].v, 0, 4, 2, 6);
  const auto odd_23 = __builtin_shufflevector(row[2].v, row[3].v, 1, 5, 3, 7);
  return {__builtin_shufflevector(even_01, even_23, 0, 1, 4, 5), __builtin_shufflevector(odd_01, odd_23, 0, 1, 4, 5),
          __builtin_shufflevector(even_01, even_23, 2, 3, 6, 7), __builtin_shufflevector(odd_01, odd_23, 2, 3, 6, 7)};
}

/// (l₀ + l₁) + (l₂ + l₃).
SHORELINE_INLINE double sum_of(const Lanes& l) { return (l[0] + l[1]) + (l[2] + l[3]); }

/// Whether a comparison holds in all lanes.
template <class Comparison>
SHORELINE_INLINE bool all_of(const Comparison& c) {
  return (c[0] & c[1] & c[2] & c[3]) != 0;
}

/// Sums over the lanes, as sum_of has them.
/// @param out   (M)
/// @param add   to what is there
template <std::size_t M>
SHORELINE_INLINE void put_sums(const std::array<Lanes, M>& l, bool add, double* out) {
  std::size_t k = 0;
  for (; k + lanes <= M; k += lanes) {
    const Lanes::Vector& a = l[k].v;
    const Lanes::Vector& b = l[k + 1].v;
    const Lanes::Vector& c = l[k + 2].v;
    const Lanes::Vector& d = l[k + 3].v;
    const auto pairs_01 = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const auto pairs_23 = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
    const auto sums = __builtin_shufflevector(pairs_01, pairs_23, 0, 1, 4, 5) +
                      __builtin_shufflevector(pairs_01, pairs_23, 2, 3, 6, 7);
    LooseLanes* const to = lanes_at(out + k);
    *to = add ? *to + sums : sums;
  }
  for (; k < M; ++k) out[k] = add ? out[k] + sum_of(l[k]) : sum_of(l[k]);
}

}  // namespace shoreline
