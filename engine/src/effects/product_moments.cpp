#include "product_moments.hpp"

#include <algorithm>

namespace shoreline {
namespace {

/// Points in groups of four of which the powers are kept at once.
constexpr std::size_t groups_at_once = 8;

template <int powers>
struct Powers {
  std::array<std::array<Lanes, powers>, groups_at_once> x;  ///< w ξ^r
  std::array<std::array<Lanes, powers>, groups_at_once> y;  ///< η^s
};

/// Up to four points, and what they weigh. What a group lacks weighs nothing.
struct Group {
  Lanes x, y, weight;

  SHORELINE_INLINE Group(const Vec2* p, const double* w)
      : x(p[0].x(), p[1].x(), p[2].x(), p[3].x()), y(p[0].y(), p[1].y(), p[2].y(), p[3].y()), weight(*lanes_at(w)) {}
  SHORELINE_INLINE Group(const Vec2* p, const double* w, std::size_t points) : x(p->x()), y(p->y()), weight(0.0) {
    for (std::size_t lane = 0; lane < points; ++lane) {
      x[lane] = p[lane].x();
      y[lane] = p[lane].y();
      weight[lane] = w[lane];
    }
  }
};

template <int powers>
SHORELINE_INLINE void note_powers(const ProductCell& cell, const Group& group, std::array<Lanes, powers>& in_x,
                                  std::array<Lanes, powers>& in_y) {
  const Lanes xi = (group.x - cell.corner.x()) * (1.0 / cell.size.x()) - 0.5;
  const Lanes eta = (group.y - cell.corner.y()) * (1.0 / cell.size.y()) - 0.5;
  in_x[0] = group.weight;
  in_y[0] = 1.0;
  for (std::size_t r = 1; r < powers; ++r) {
    in_x[r] = in_x[r - 1] * xi;
    in_y[r] = in_y[r - 1] * eta;
  }
}

template <int powers>
SHORELINE_INLINE void add_powers(const ProductCell& cell, std::span<const Vec2> x, std::span<const double> weight,
                                 double* out) {
  std::array<std::array<Lanes, powers>, powers> sum;
  for (auto& row : sum) row.fill(0.0);
  Powers<powers> of;
  for (std::size_t first = 0; first < x.size(); first += groups_at_once * lanes) {
    const std::size_t groups = std::min(groups_at_once, (x.size() - first + lanes - 1) / lanes);
    for (std::size_t g = 0; g < groups; ++g) {
      const std::size_t begin = first + lanes * g;
      const std::size_t left = x.size() - begin;
      const Group group = left >= lanes ? Group(&x[begin], &weight[begin]) : Group(&x[begin], &weight[begin], left);
      note_powers<powers>(cell, group, of.x[g], of.y[g]);
    }
    for (std::size_t r = 0; r < powers; ++r) {
      std::array<Lanes, powers> row = sum[r];
      for (std::size_t g = 0; g < groups; ++g)
        for (std::size_t s = 0; s < powers; ++s) row[s] += of.x[g][r] * of.y[g][s];
      sum[r] = row;
    }
  }
  for (std::size_t r = 0; r < powers; ++r) put_sums(sum[r], false, out + r * powers);
}

/// Coefficients that remain to be multiplied by powers of ξ, for pairs in groups of four: [power][group].
template <std::size_t powers, std::size_t groups>
using AlongY = std::array<std::array<Lanes, groups>, powers>;

constexpr std::size_t groups_of(std::size_t pairs) { return (pairs + lanes - 1) / lanes; }

/// Σ_s sum(r, s) c_s for all r < powers.
/// @param degree  of the pairs
/// @param stride  from one r to the next
template <std::size_t degree, std::size_t powers, std::size_t groups, std::size_t terms>
SHORELINE_INLINE void along_y(const std::array<std::array<double, max_pairs>, terms>& c, const double* sum,
                              std::size_t stride, AlongY<powers, groups>& out) {
  for (std::size_t r = 0; r < powers; ++r)
    for (std::size_t g = 0; g < groups; ++g) {
      Lanes total(0.0);
      for (std::size_t s = 0; s <= degree; ++s) total += Lanes(*lanes_at(&c[s][lanes * g])) * sum[r * stride + s];
      out[r][g] = total;
    }
}

/// Σ_r c_r in_r for the first pairs.
template <std::size_t pairs, std::size_t powers, std::size_t groups, std::size_t terms>
SHORELINE_INLINE void along_x(const std::array<std::array<double, max_pairs>, terms>& c,
                              const AlongY<powers, groups>& in, ProductMoments::Plane& plane) {
  for (std::size_t pair = 0; pair < pairs; ++pair)
    for (std::size_t g = 0; g < groups; ++g) {
      Lanes total(0.0);
      for (std::size_t r = 0; r < powers; ++r) total += in[r][g] * c[r][pair];
      *lanes_at(&plane[max_pairs * pair + lanes * g]) = total.v;
    }
}

template <std::size_t P>
SHORELINE_INLINE void multiply_degree(const FactorPairs& x, const FactorPairs& y, const double* sum,
                                      ProductMoments& moments) {
  constexpr std::size_t unordered = (P + 1) * (P + 2) / 2;
  constexpr std::size_t ordered = (P + 1) * (P + 1);
  constexpr std::size_t stride = 2 * P + 1;
  AlongY<2 * P - 1, groups_of(unordered)> value;
  along_y<2 * P>(y.value, sum, stride, value);
  along_x<unordered>(x.slope, value, moments.xx);
  AlongY<2 * P, groups_of(ordered)> mixed;
  along_y<2 * P - 1>(y.mixed, sum, stride, mixed);
  along_x<ordered>(x.mixed, mixed, moments.xy);
  AlongY<2 * P + 1, groups_of(unordered)> slope;
  along_y<2 * P - 2>(y.slope, sum, stride, slope);
  along_x<unordered>(x.value, slope, moments.yy);
}

}  // namespace

/// Horner's scheme, carried on to all derivatives.
std::array<double, max_pairs> about_middle(int p, std::span<const double> coefficient) {
  std::array<double, max_pairs> c{};
  std::ranges::copy(coefficient, c.begin());
  const auto n = static_cast<std::size_t>(p + 1);
  for (std::size_t done = 0; done < n; ++done)
    for (std::size_t power = n - 1; power > done; --power)
      for (std::size_t a = 0; a < n; ++a) c[(power - 1) * n + a] += 0.5 * c[power * n + a];
  return c;
}

void FactorPairs::make(int p, std::span<const double> coefficient, double size) {
  if (size == size_ && std::ranges::equal(coefficient, std::span(made_of_).first(coefficient.size()))) return;
  *this = {};
  std::ranges::copy(coefficient, made_of_.begin());
  size_ = size;
  const int n = p + 1;
  const std::array<double, max_pairs> middle = about_middle(p, coefficient);
  const auto c = [&](int a, int power) { return middle[static_cast<std::size_t>(a + power * n)]; };
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      const auto in_order = static_cast<std::size_t>(ordered(a, b, n));
      const auto pair = static_cast<std::size_t>(unordered(a, b));
      for (int r = 0; r < n; ++r)
        for (int s = 0; s < n; ++s) {
          const double product = c(a, r) * c(b, s);
          const auto power = static_cast<std::size_t>(r + s);
          if (a >= b) value[power][pair] += product;
          if (r > 0) mixed[power - 1][in_order] += r * product / size;
          if (r > 0 && s > 0 && a >= b) slope[power - 2][pair] += r * s * product / (size * size);
        }
    }
}

SHORELINE_CLONES void power_sums(int powers, const ProductCell& cell, std::span<const Vec2> x,
                                 std::span<const double> weight, double* sum) {
  switch (powers) {
    case 3:
      return add_powers<3>(cell, x, weight, sum);
    case 4:
      return add_powers<4>(cell, x, weight, sum);
    case 5:
      return add_powers<5>(cell, x, weight, sum);
    default:
      return add_powers<7>(cell, x, weight, sum);
  }
}

SHORELINE_CLONES void multiply(int p, const FactorPairs& x, const FactorPairs& y, const double* sum,
                               ProductMoments& moments) {
  if (p == 2)
    multiply_degree<2>(x, y, sum, moments);
  else
    multiply_degree<3>(x, y, sum, moments);
}

}  // namespace shoreline
