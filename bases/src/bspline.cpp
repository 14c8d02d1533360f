#include "shoreline/bases/bspline.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// Open uniform knot @p number over @p spans spans of length 1.
double knot(Index number, Index spans, int degree) { return std::clamp(number - degree, Index{0}, spans); }

/// Value and first two derivatives of a polynomial with coefficients c_0, c_1, … at ξ.
template <class Row>
std::array<double, 3> taylor(const Row& c, double xi) {
  std::array<double, 3> d{0.0, 0.0, 0.0};
  for (Eigen::Index k = c.size() - 1; k >= 0; --k) {
    d[2] = d[2] * xi + 2.0 * d[1];
    d[1] = d[1] * xi + d[0];
    d[0] = d[0] * xi + c[k];
  }
  return d;
}

/// The P + 1 polynomials of a span and their derivatives by ξ.
template <int P, class Number>
struct Splines {
  Number value[P + 1];
  Number slope[P + 1];
};

/// Horner's scheme.
/// @param c  coefficient (function, power of ξ)
template <int P, class Number>
SHORELINE_INLINE Splines<P, Number> splines(const Eigen::Map<const Eigen::Matrix<double, P + 1, P + 1>>& c,
                                            const Number& xi) {
  Splines<P, Number> at_xi;
  for (int a = 0; a <= P; ++a) {
    Number f = c(a, P) * xi + c(a, P - 1);
    auto d = Number(c(a, P));
    for (int k = P - 2; k >= 0; --k) {
      d = d * xi + f;
      f = f * xi + c(a, k);
    }
    at_xi.value[a] = f;
    at_xi.slope[a] = d;
  }
  return at_xi;
}

}  // namespace

BSplineBasis::BSplineBasis(QuadrilateralGrid grid, int degree) : grid_(std::move(grid)), degree_(degree) {
  if (degree < 1 || degree > 3)
    throw InvalidArgument("BSplineBasis: expected a degree from 1 to 3, got " + std::to_string(degree));
  column_ = all_spans(grid_.columns(), degree);
  row_ = all_spans(grid_.rows(), degree);
}

/// Cox's and de Boor's recursion for polynomials in ξ = x − span.
std::vector<BSplineBasis::SpanPolynomials> BSplineBasis::all_spans(Index spans, int degree) {
  std::vector<SpanPolynomials> all;
  for (Index s = 0; s < spans; ++s) {
    SpanPolynomials n = SpanPolynomials::Zero(degree + 1, degree + 1);
    n(0, 0) = 1.0;
    for (int k = 1; k <= degree; ++k) {
      const SpanPolynomials lower = n;
      n.setZero();
      for (int a = 0; a < k; ++a) {  // lower function a lives on knots left … right
        const double left = knot(s + degree - k + 1 + a, spans, degree);
        const double right = knot(s + degree + 1 + a, spans, degree);
        for (int power = 0; power < k; ++power) {
          const double c = lower(a, power) / (right - left);
          n(a, power) += c * (right - s);
          n(a, power + 1) -= c;
          n(a + 1, power) += c * (s - left);
          n(a + 1, power + 1) += c;
        }
      }
    }
    all.push_back(n);
  }
  return all;
}

ShortIndices BSplineBasis::functions_of(Index cell) const {
  const Index i = cell % grid_.columns();
  const Index j = cell / grid_.columns();
  ShortIndices functions(functions_per_cell());
  for (Index b = 0, k = 0; b <= degree_; ++b)
    for (Index a = 0; a <= degree_; ++a, ++k) functions[k] = i + a + (j + b) * (grid_.columns() + degree_);
  return functions;
}

Vec2 BSplineBasis::control_point(Index function) const {
  const auto greville = [&](Index i, Index spans) {
    double sum = 0.0;
    for (int k = 1; k <= degree_; ++k) sum += knot(i + k, spans, degree_);
    return sum / degree_;
  };
  const Index columns = grid_.columns() + degree_;
  return grid_.corner(0) + grid_.spacing().cwiseProduct(Vec2(greville(function % columns, grid_.columns()),
                                                             greville(function / columns, grid_.rows())));
}

template <int P, class Point, class Number>
SHORELINE_INLINE void BSplineBasis::evaluate_degree(Index cell, std::span<const Point> x, Number* value,
                                                    Number* gradient) const {
  using Coefficients = Eigen::Matrix<double, P + 1, P + 1>;
  const Index i = cell % grid_.columns();
  const Index j = cell / grid_.columns();
  const Eigen::Map<const Coefficients> column(column_[at(i)].data());
  const Eigen::Map<const Coefficients> row(row_[at(j)].data());
  const Vec2 corner(grid_.line(0, i), grid_.line(1, j));
  const Vec2 inverse = grid_.spacing().cwiseInverse();
  for (const Point& point : x) {
    const auto in_x = splines<P, Number>(column, (point[0] - corner.x()) * inverse.x());
    const auto in_y = splines<P, Number>(row, (point[1] - corner.y()) * inverse.y());
    for (int b = 0; b <= P; ++b)
      for (int a = 0; a <= P; ++a) *value++ = in_x.value[a] * in_y.value[b];
    if (gradient == nullptr) continue;
    for (int b = 0; b <= P; ++b) {
      const Number fy = in_y.value[b] * inverse.x();
      const Number dy = in_y.slope[b] * inverse.y();
      for (int a = 0; a <= P; ++a) {
        *gradient++ = in_x.slope[a] * fy;
        *gradient++ = in_x.value[a] * dy;
      }
    }
  }
}

template <class Point, class Number>
SHORELINE_INLINE void BSplineBasis::evaluate_all(Index cell, std::span<const Point> x, Number* value,
                                                 Number* gradient) const {
  switch (degree_) {
    case 1:
      return evaluate_degree<1>(cell, x, value, gradient);
    case 2:
      return evaluate_degree<2>(cell, x, value, gradient);
    default:
      return evaluate_degree<3>(cell, x, value, gradient);
  }
}

void BSplineBasis::evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const {
  evaluate_all(cell, x, value, gradient);
}

SHORELINE_CLONES void BSplineBasis::evaluate_lanes(Index cell, std::span<const LanePoint> x, Lanes* value,
                                                   Lanes* gradient) const {
  evaluate_all(cell, x, value, gradient);
}

void BSplineBasis::evaluate(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const {
  evaluate_lanes(cell, x, value, gradient);
}

std::optional<ProductCell> BSplineBasis::product_cell(Index cell) const {
  const SpanPolynomials& column = column_[at(cell % grid_.columns())];
  const SpanPolynomials& row = row_[at(cell / grid_.columns())];
  const auto coefficients = [](const SpanPolynomials& c) { return std::span(c.data(), at(c.size())); };
  return ProductCell{grid_.corner(cell), grid_.spacing(), coefficients(column), coefficients(row)};
}

ShortCurvatures BSplineBasis::curvatures(Index cell, const Vec2& x) const {
  const Vec2 inverse = grid_.spacing().cwiseInverse();
  const Vec2 local = (x - grid_.corner(cell)).cwiseProduct(inverse);
  ShortCurvatures second(3, functions_per_cell());
  for (Eigen::Index b = 0, k = 0; b <= degree_; ++b)
    for (Eigen::Index a = 0; a <= degree_; ++a, ++k) {
      const auto in_x = taylor(column_[at(cell % grid_.columns())].row(a), local.x());
      const auto in_y = taylor(row_[at(cell / grid_.columns())].row(b), local.y());
      second.col(k) << in_x[2] * in_y[0] * inverse.x() * inverse.x(), in_x[0] * in_y[2] * inverse.y() * inverse.y(),
          in_x[1] * in_y[1] * inverse.prod();
    }
  return second;
}

}  // namespace shoreline
