#include "shoreline/bases/projection.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <string>

#include "shoreline/bases/error.hpp"
#include "shoreline/bases/quadrature.hpp"

namespace shoreline {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Cholesky = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower>;

std::size_t at(Index number) { return static_cast<std::size_t>(number); }

std::string text(const Vec2& x) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "(%.6g, %.6g)", x.x(), x.y());
  return buffer;
}

std::string name_of(const Basis& basis, Index function) {
  return "function " + std::to_string(function) + " at " + text(basis.control_point(function));
}

/// What the points of one element see: its functions, ascending, and the sums over its points.
struct Element {
  explicit Element(const Basis& basis, Index cell) : function(basis.functions_of(cell)) {
    std::ranges::sort(function);
    mass.setZero(function.size(), function.size());
    row_sum.setZero(function.size());
  }

  ShortIndices function;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_support, max_support> mass;
  ShortVector row_sum;
};

/// Sums over all points.
struct Sums {
  std::vector<Eigen::Triplet<double>> mass;  ///< lower triangle; 1 on the diagonal of functions not determined
  Eigen::VectorXd row_sum;
  Eigen::MatrixXd load;
  std::vector<char> determined;  ///< functions of elements that hold points
};

void add_point(const Support& support, double weight, const Eigen::RowVectorXd& value, Element& element, Sums& sums) {
  std::array<Eigen::Index, max_support> place{};
  for (Eigen::Index a = 0; a < support.value.size(); ++a) {
    const Index* const first = element.function.data();
    place[static_cast<std::size_t>(a)] =
        std::lower_bound(first, first + element.function.size(), support.function[a]) - first;
    sums.load.row(support.function[a]) += weight * support.value[a] * value;
  }
  for (Eigen::Index a = 0; a < support.value.size(); ++a) {
    const Eigen::Index row = place[static_cast<std::size_t>(a)];
    element.row_sum[row] += weight * support.value[a];
    for (Eigen::Index b = 0; b < support.value.size(); ++b)
      element.mass(row, place[static_cast<std::size_t>(b)]) += weight * support.value[a] * support.value[b];
  }
}

void add_element(const Element& element, Mass mass, Sums& sums) {
  for (Eigen::Index a = 0; a < element.function.size(); ++a) {
    sums.row_sum[element.function[a]] += element.row_sum[a];
    sums.determined[at(element.function[a])] = 1;
    for (Eigen::Index b = 0; b <= a && mass == Mass::consistent; ++b)
      sums.mass.emplace_back(element.function[a], element.function[b], element.mass(a, b));
  }
}

Sums sum_up(const Basis& basis, const WeightedPoints& points, const Eigen::MatrixXd& value, Mass mass) {
  Sums sums{{},
            Eigen::VectorXd::Zero(basis.functions()),
            Eigen::MatrixXd::Zero(basis.functions(), value.cols()),
            std::vector<char>(at(basis.functions()), 0)};
  const Index parts = basis.grid().parts();
  std::vector<Index> order(points.x.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](Index p) { return points.cell[at(p)] / parts; });
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const Index first = points.cell[at(order[begin])];
    Element element(basis, first);
    for (; end < order.size() && points.cell[at(order[end])] / parts == first / parts; ++end) {
      const Index p = order[end];
      add_point(basis.support(points.cell[at(p)], points.x[at(p)]), points.weight[at(p)], value.row(p), element, sums);
    }
    add_element(element, mass, sums);
  }
  for (Index f = 0; f < basis.functions(); ++f)
    if (sums.determined[at(f)] == 0) sums.mass.emplace_back(f, f, 1.0);
  return sums;
}

void require_seen(const Basis& basis, const Sums& sums) {
  const double least = 1e-14 * sums.row_sum.maxCoeff();
  for (Index f = 0; f < basis.functions(); ++f)
    if (sums.determined[at(f)] != 0 && sums.row_sum[f] <= least)
      throw InvalidArgument("project: " + name_of(basis, f) +
                            " sees no point, although its cell holds some; spread points over every cell");
}

/// Solves with the mass scaled to a unit diagonal, so that its pivots tell how well functions are told apart.
Eigen::MatrixXd solve_consistent(const Basis& basis, const Sums& sums) {
  constexpr double smallest_pivot = 1e-13;
  const Index n = basis.functions();
  SparseMatrix mass(n, n);
  mass.setFromTriplets(sums.mass.begin(), sums.mass.end());
  const Eigen::VectorXd scale = mass.diagonal().cwiseSqrt().cwiseInverse();
  mass = scale.asDiagonal() * mass * scale.asDiagonal();
  const Cholesky factor(mass);
  Eigen::Index worst = 0;
  const double pivot = factor.vectorD().minCoeff(&worst);
  if (factor.info() != Eigen::Success || !(pivot > smallest_pivot))
    throw InvalidArgument("project: the mass matrix is singular: the points do not tell " +
                          name_of(basis, factor.permutationPinv().indices()[worst]) +
                          " from its neighbours; use more points in every cell, or the lumped mass");
  return scale.asDiagonal() * factor.solve(scale.asDiagonal() * sums.load);
}

Eigen::MatrixXd divide_lumped(const Sums& sums) {
  Eigen::MatrixXd coefficient = sums.load;
  for (Eigen::Index f = 0; f < coefficient.rows(); ++f)
    if (sums.determined[static_cast<std::size_t>(f)] != 0) coefficient.row(f) /= sums.row_sum[f];
  return coefficient;
}

}  // namespace

WeightedPoints integration_points(const Grid& grid, int degree) {
  if (degree < 0 || degree > 63)
    throw InvalidArgument("integration_points: degree must be 0 to 63, got " + std::to_string(degree));
  const QuadratureRule along = gauss(degree / 2 + 1);
  const QuadratureRule outward = gauss((degree + 1) / 2 + 1);  // from the vertex; the width there adds a degree
  WeightedPoints points;
  for (Index cell = 0; cell < grid.cells(); ++cell) {
    const std::vector<Vec2> p = grid.polygon(cell);
    const bool triangle = p.size() == 3;
    const Vec2 u = p[1] - p[0];
    const Vec2 v = triangle ? p[2] - p[1] : p[3] - p[0];
    const QuadratureRule& first = triangle ? outward : along;
    for (Eigen::Index i = 0; i < first.point.size(); ++i)
      for (Eigen::Index j = 0; j < along.point.size(); ++j) {
        const double width = triangle ? first.point[i] : 1.0;
        points.cell.push_back(cell);
        points.x.emplace_back(p[0] + first.point[i] * u + width * along.point[j] * v);
        points.weight.push_back(first.weight[i] * along.weight[j] * width * cross(u, v));
      }
  }
  return points;
}

WeightedPoints points_in(const Grid& grid, std::span<const Vec2> x, std::span<const double> weight) {
  WeightedPoints points{{}, {x.begin(), x.end()}, {weight.begin(), weight.end()}};
  Index hint = 0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    const std::optional<Index> cell = grid.locate(x[p], hint);
    if (!cell)
      throw InvalidArgument("point " + std::to_string(p) + " at " + text(x[p]) +
                            " lies outside the grid; enlarge the grid or remove the point");
    points.cell.push_back(hint = *cell);
  }
  return points;
}

Eigen::MatrixXd project(const Basis& basis, const WeightedPoints& points, const Eigen::MatrixXd& value, Mass mass) {
  if (points.x.empty() || static_cast<std::size_t>(value.rows()) != points.x.size())
    throw InvalidArgument("project: need a value for each of at least 1 point, got " + std::to_string(value.rows()) +
                          " for " + std::to_string(points.x.size()));
  const Sums sums = sum_up(basis, points, value, mass);
  require_seen(basis, sums);
  return mass == Mass::consistent ? solve_consistent(basis, sums) : divide_lumped(sums);
}

}  // namespace shoreline
