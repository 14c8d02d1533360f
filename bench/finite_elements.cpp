// The yardstick of assembly: plain bilinear finite elements of equal size, without material points. Four Gauss points
// an element, matrices straight into the same sparse pattern; assembled twice, as two load steps do.

#include <omp.h>

#include <Eigen/LU>
#include <cmath>

#include "benchmarks.hpp"
#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/quadrature.hpp"
#include "shoreline/engine/assembler.hpp"
#include "shoreline/engine/clock.hpp"
#include "shoreline/engine/linear_elastic.hpp"

namespace shoreline::bench {
namespace {

using Corners = Eigen::Matrix<double, 2, 4>;

/// ∂φ/∂ξ, ∂φ/∂η of the four functions in the unit square, in the order of the basis.
Corners reference_gradients(double xi, double eta) {
  Corners d;
  d << eta - 1.0, 1.0 - eta, -eta, eta,  //
      xi - 1.0, -xi, 1.0 - xi, xi;
  return d;
}

/// ∫ Bᵀ D B over one element.
Eigen::Matrix<double, 8, 8> stiffness(const Corners& corner, const Mat3& tangent,
                                      const std::vector<Corners>& at_gauss) {
  Eigen::Matrix<double, 8, 8> k = Eigen::Matrix<double, 8, 8>::Zero();
  for (const Corners& d : at_gauss) {
    const Eigen::Matrix2d jacobian = d * corner.transpose();
    const Corners g = jacobian.inverse() * d;
    Eigen::Matrix<double, 3, 8> b = Eigen::Matrix<double, 3, 8>::Zero();
    for (Eigen::Index a = 0; a < 4; ++a) {
      b(0, 2 * a) = b(2, 2 * a + 1) = g(0, a);
      b(1, 2 * a + 1) = b(2, 2 * a) = g(1, a);
    }
    const Eigen::Matrix<double, 3, 8> db = 0.25 * jacobian.determinant() * tangent * b;
    k.noalias() += b.transpose() * db;
  }
  return k;
}

void add_elements(const BilinearBasis& basis, const Mat3& tangent, const std::vector<Corners>& at_gauss,
                  ElementBlocks& blocks) {
  blocks.clear();
  blocks.append(static_cast<std::size_t>(basis.grid().cells()), 4);
  Corners corner;
  for (Index cell = 0; cell < basis.grid().cells(); ++cell) {
    const ShortIndices functions = basis.functions_of(cell);
    for (Index a = 0; a < 4; ++a) {
      blocks.function[static_cast<std::size_t>(4 * cell + a)] = functions[a];
      corner.col(a) = basis.control_point(functions[a]);
    }
    blocks.add(static_cast<std::size_t>(cell), stiffness(corner, tangent, at_gauss));
  }
}

double run(Index cells, benchmark::UserCounters& counters) {
  omp_set_num_threads(1);
  const BilinearBasis basis(QuadrilateralGrid(Vec2::Zero(), Vec2::Constant(1.0 / cells), {cells, cells}));
  const Mat3 tangent = LinearElastic(1e6, 0.25, Plane::strain).tangent({});
  const QuadratureRule rule = gauss(2);
  std::vector<Corners> at_gauss;
  for (const double xi : rule.point)
    for (const double eta : rule.point) at_gauss.push_back(reference_gradients(xi, eta));
  ElementBlocks blocks;
  Assembler assembler;
  SparseMatrix matrix;
  Eigen::VectorXd force;
  double second = 0.0;
  for (const std::string step : {"step1_", "step2_"}) {
    Clock clock;
    clock.time("elements", [&] { add_elements(basis, tangent, at_gauss, blocks); });
    clock.time("pattern", [&] { assembler.prepare(blocks, {}, basis.functions()); });
    clock.time("scatter", [&] { assembler.assemble(blocks, matrix, force); });
    second = 0.0;
    for (const Clock::Entry& e : clock.entries()) {
      counters[step + e.name] = e.seconds;
      second += e.seconds;
    }
  }
  counters["cells"] = static_cast<double>(cells) * cells;
  counters["unknowns"] = assembler.equations();
  return second;
}

}  // namespace

void register_finite_elements() {
  for (const Index cells : {25, 79, 250, 791})
    add("finite_elements/bilinear/cells:" + std::to_string(cells * cells),
        [cells](benchmark::UserCounters& counters) { return run(cells, counters); });
}

}  // namespace shoreline::bench
