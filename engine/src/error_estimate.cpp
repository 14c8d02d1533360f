#include "shoreline/engine/error_estimate.hpp"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "shoreline/engine/linear_solver.hpp"

namespace shoreline {
namespace {

constexpr double shift = 1e-12;      ///< of the scaled mass, (Z.4): functions that points do not tell apart
constexpr double unseen = 1e-30;     ///< of the largest diagonal entry: the function vanishes at the points
constexpr double vanishing = 1e-12;  ///< of the stress: what is left of it is rounding

/// A symmetric tensor at every function or point: xx, yy, xy.
using Tensors = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// The values of the functions at a point.
using Values = Eigen::Map<const Eigen::VectorXd>;

/// Calls visit(functions, points) for the functions of each cell and its points, a function that calls use(k, values)
/// for each, k in the order of cells.
template <class Visit>
void for_each_cell(const Basis& basis, const PointSupports& supports, Visit&& visit) {
  BasisAtPoints at_points(basis, supports, Evaluate::values);
  for (Index c = 0; c < supports.cells(); ++c) {
    const auto cell = static_cast<std::size_t>(c);
    at_points.evaluate(c);
    visit(basis.functions_of(supports.cell[cell]), [&](auto&& use) {
      for (Index k = supports.first[cell]; k < supports.first[cell + 1]; ++k)
        use(k, Values(at_points.value(k), supports.functions));
    });
  }
}

Index point_at(const PointSupports& supports, Index k) { return supports.point[static_cast<std::size_t>(k)]; }

/// Numbers the functions that some point sees; −1: none does.
std::vector<Index> number_functions(const Basis& basis, const MaterialPoints& points, const PointSupports& supports) {
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(basis.functions());
  for_each_cell(basis, supports, [&](const ShortIndices& functions, auto&& points_of_cell) {
    points_of_cell([&](Index k, const Values& values) {
      for (Index a = 0; a < supports.functions; ++a)
        diagonal[functions[a]] += points.volume[point_at(supports, k)] * std::pow(values[a], 2);
    });
  });
  std::vector<Index> number(static_cast<std::size_t>(basis.functions()), -1);
  Index next = 0;
  for (Index f = 0; f < basis.functions(); ++f)
    if (diagonal[f] > unseen * diagonal.maxCoeff()) number[static_cast<std::size_t>(f)] = next++;
  return number;
}

/// The lower half of the mass of numbered functions, (Z.1).
SparseMatrix mass_of(const Basis& basis, const MaterialPoints& points, const PointSupports& supports,
                     const std::vector<Index>& number) {
  std::vector<Eigen::Triplet<double>> entries;
  for_each_cell(basis, supports, [&](const ShortIndices& functions, auto&& points_of_cell) {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_support, max_support> block;
    block.setZero(supports.functions, supports.functions);
    points_of_cell([&](Index k, const Values& values) {
      block += points.volume[point_at(supports, k)] * values * values.transpose();
    });
    for (Index a = 0; a < supports.functions; ++a)
      for (Index b = 0; b < supports.functions; ++b) {
        const Index row = number[static_cast<std::size_t>(functions[a])];
        const Index column = number[static_cast<std::size_t>(functions[b])];
        if (column >= 0 && row >= column) entries.emplace_back(row, column, block(a, b));
      }
  });
  const Index size = *std::ranges::max_element(number) + 1;
  Eigen::SparseMatrix<double> sum(size, size);
  sum.setFromTriplets(entries.begin(), entries.end());
  return {size,
          {sum.outerIndexPtr(), sum.outerIndexPtr() + size + 1},
          {sum.innerIndexPtr(), sum.innerIndexPtr() + sum.nonZeros()},
          {sum.valuePtr(), sum.valuePtr() + sum.nonZeros()}};
}

/// Coefficients of the recovered stress by function, (Z.1); zero where no point sees it.
Tensors recovered(const Basis& basis, const MaterialPoints& points, const PointSupports& supports,
                  const std::vector<Index>& number) {
  const SparseMatrix mass = mass_of(basis, points, supports, number);
  Tensors load = Tensors::Zero(mass.size, 3);
  for_each_cell(basis, supports, [&](const ShortIndices& functions, auto&& points_of_cell) {
    points_of_cell([&](Index k, const Values& values) {
      const Index p = point_at(supports, k);
      for (Index a = 0; a < supports.functions; ++a)
        if (const Index row = number[static_cast<std::size_t>(functions[a])]; row >= 0)
          load.row(row) += points.volume[p] * values[a] * points.stress.col(p).head<3>().transpose();
    });
  });
  LinearSolver solver;
  solver.analyse(mass);
  solver.factorize(mass, shift);
  for (int component = 0; component < 3; ++component) load.col(component) = solver.solve(load.col(component));
  Tensors stress = Tensors::Zero(basis.functions(), 3);
  for (Index f = 0; f < basis.functions(); ++f)
    if (const Index row = number[static_cast<std::size_t>(f)]; row >= 0) stress.row(f) = load.row(row);
  return stress;
}

}  // namespace

ErrorEstimate error_estimate(const Basis& basis, const MaterialPoints& points, const PointSupports& supports) {
  const std::vector<Index> number = number_functions(basis, points, supports);
  const Tensors stress = recovered(basis, points, supports, number);
  ErrorEstimate estimate{.stress_l2 = 0.0,
                         .stress_l2_relative = {},
                         .stress_at_point = Eigen::VectorXd(points.size()),
                         .functions = *std::ranges::max_element(number) + 1};
  double whole = 0.0;
  for_each_cell(basis, supports, [&](const ShortIndices& functions, auto&& points_of_cell) {
    points_of_cell([&](Index k, const Values& values) {
      const Index p = point_at(supports, k);
      Vec3 there = Vec3::Zero();
      for (Index a = 0; a < supports.functions; ++a) there += values[a] * stress.row(functions[a]).transpose();
      estimate.stress_at_point[p] = (there - points.stress.col(p).head<3>()).norm();
      whole += points.volume[p] * there.squaredNorm();
    });
  });
  const double square = estimate.stress_at_point.cwiseAbs2().dot(points.volume);
  estimate.stress_l2 = std::sqrt(square);
  if (whole > vanishing * vanishing * square) estimate.stress_l2_relative = std::sqrt(square / whole);
  return estimate;
}

}  // namespace shoreline
