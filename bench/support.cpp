// What a basis costs at one material point: the cell that holds it, and values and gradients there. 64 x 64 unit
// squares, 16 points or a few more in each square or triangle, visited cell by cell as a load step does.

#include <memory>

#include "benchmarks.hpp"
#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/bspline.hpp"
#include "shoreline/bases/linear_triangle.hpp"
#include "shoreline/bases/mesh_generators.hpp"
#include "shoreline/bases/powell_sabin.hpp"

namespace shoreline::bench {
namespace {

constexpr Index squares = 64;  ///< a side
constexpr int points_of_element = 16;

using Points = std::vector<std::vector<Vec2>>;  ///< by cell

/// Points of each cell, at fixed convex combinations of its corners.
Points points_in_cells(const Grid& grid) {
  const int count = (points_of_element + grid.parts() - 1) / grid.parts();
  Points points(static_cast<std::size_t>(grid.cells()));
  for (Index cell = 0; cell < grid.cells(); ++cell) {
    const std::vector<Vec2> corner = grid.polygon(cell);
    for (int k = 0; k < count; ++k) {
      Vec2 sum = Vec2::Zero();
      double weights = 0.0;
      for (std::size_t c = 0; c < corner.size(); ++c) {
        const double weight = 1.0 + ((k + 1) * (static_cast<int>(c) + 2)) % 7;
        sum += weight * corner[c];
        weights += weight;
      }
      points[static_cast<std::size_t>(cell)].push_back(sum / weights);
    }
  }
  return points;
}

void locate(const Basis& basis, const Points& points) {
  Index hint = 0;
  for (const auto& cell : points)
    for (const Vec2& x : cell) benchmark::DoNotOptimize(hint = basis.grid().locate(x, hint).value_or(0));
}

void evaluate(const Basis& basis, const Points& points) {
  const std::size_t most = points.front().size() * static_cast<std::size_t>(basis.functions_per_cell());
  std::vector<double> value(most);
  std::vector<double> gradient(2 * most);
  for (std::size_t cell = 0; cell < points.size(); ++cell) {
    basis.evaluate(static_cast<Index>(cell), points[cell], value.data(), gradient.data());
    benchmark::DoNotOptimize(value.data());
    benchmark::ClobberMemory();
  }
}

void add_basis(const std::string& name, const std::shared_ptr<const Basis>& basis) {
  for (const auto& [part, work] : {std::pair{"locate", &locate}, {"evaluate", &evaluate}})
    benchmark::RegisterBenchmark(
        ("support/" + name + "/" + part).c_str(), [basis, work = work](benchmark::State& state) {
          const Points points = points_in_cells(basis->grid());
          for ([[maybe_unused]] const auto _ : state) work(*basis, points);
          state.counters["seconds_a_point"] =
              benchmark::Counter(static_cast<double>(points.size() * points.front().size()),
                                 benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
        });
}

}  // namespace

void register_support() {
  const QuadrilateralGrid grid(Vec2::Zero(), Vec2::Ones(), {squares, squares});
  const TriangleMesh mesh = triangulate(grid, TrianglePattern::diagonal);
  add_basis("bilinear", std::make_shared<BilinearBasis>(grid));
  add_basis("linear", std::make_shared<LinearTriangleBasis>(mesh));
  add_basis("powell_sabin", std::make_shared<PowellSabinBasis>(mesh));
  for (const int degree : {1, 2, 3})
    add_basis("bspline" + std::to_string(degree), std::make_shared<BSplineBasis>(grid, degree));
}

}  // namespace shoreline::bench
