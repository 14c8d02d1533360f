// What a basis costs at one material point: nanoseconds for the cell that holds it, and for values and gradients there.
//
//   shoreline_bench_support [repetitions]
//
// 64 x 64 unit squares, 16 points or a few more in each square or triangle, visited cell by cell as a load step does,
// on one thread. Prints medians over the repetitions, and the ratio to the bilinear basis.

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/bspline.hpp"
#include "shoreline/bases/linear_triangle.hpp"
#include "shoreline/bases/mesh_generators.hpp"
#include "shoreline/bases/powell_sabin.hpp"

using namespace shoreline;

namespace {

constexpr Index squares = 64;  ///< a side
constexpr int points_of_element = 16;

/// Points of each cell, at fixed convex combinations of its corners.
std::vector<std::vector<Vec2>> points_in_cells(const Grid& grid) {
  const int count = (points_of_element + grid.parts() - 1) / grid.parts();
  std::vector<std::vector<Vec2>> points(static_cast<std::size_t>(grid.cells()));
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

struct Cost {
  double locate;    ///< [ns a point]
  double evaluate;  ///< [ns a point]
};

/// Processor time, which other programs do not lengthen [ns].
double now() { return 1e9 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

Cost measure(const Basis& basis, int repetitions) {
  const std::vector<std::vector<Vec2>> points = points_in_cells(basis.grid());
  const std::size_t most = points.front().size() * static_cast<std::size_t>(basis.functions_per_cell());
  std::vector<double> value(most);
  std::vector<double> gradient(2 * most);
  const double count = static_cast<double>(points.size() * points.front().size());
  std::vector<double> locate;
  std::vector<double> evaluate;
  double checksum = 0.0;
  for (int r = 0; r < repetitions; ++r) {
    double begin = now();
    Index hint = 0;
    for (const auto& cell : points)
      for (const Vec2& x : cell) checksum += hint = basis.grid().locate(x, hint).value_or(0);
    locate.push_back((now() - begin) / count);
    begin = now();
    for (std::size_t cell = 0; cell < points.size(); ++cell) {
      basis.evaluate(static_cast<Index>(cell), points[cell], value.data(), gradient.data());
      checksum += value[0] + gradient[1];
    }
    evaluate.push_back((now() - begin) / count);
  }
  if (checksum == 0.5) fmt::print("\n");  // keeps the loops
  return {median(locate), median(evaluate)};
}

}  // namespace

int main(int argc, char** argv) {
  const int repetitions = argc > 1 ? std::stoi(argv[1]) : 15;
  const QuadrilateralGrid grid(Vec2::Zero(), Vec2::Ones(), {squares, squares});
  const TriangleMesh mesh = triangulate(grid, TrianglePattern::diagonal);
  std::vector<std::pair<std::string, std::unique_ptr<Basis>>> bases;
  bases.emplace_back("bilinear", std::make_unique<BilinearBasis>(grid));
  bases.emplace_back("linear", std::make_unique<LinearTriangleBasis>(mesh));
  bases.emplace_back("powell_sabin", std::make_unique<PowellSabinBasis>(mesh));
  for (const int degree : {1, 2, 3})
    bases.emplace_back(fmt::format("bspline, degree {}", degree), std::make_unique<BSplineBasis>(grid, degree));

  fmt::print("nanoseconds a point, medians of {} runs\n{:<18} {:>9} {:>9} {:>9} {:>9}\n", repetitions, "basis",
             "locate", "evaluate", "sum", "/bilinear");
  double bilinear = 0.0;
  for (const auto& [name, basis] : bases) {
    const Cost cost = measure(*basis, repetitions);
    const double sum = cost.locate + cost.evaluate;
    if (bilinear == 0.0) bilinear = sum;
    fmt::print("{:<18} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.2f}\n", name, cost.locate, cost.evaluate, sum, sum / bilinear);
  }
}
