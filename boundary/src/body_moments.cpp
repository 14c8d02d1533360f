#include "shoreline/boundary/body_moments.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "shoreline/bases/counters.hpp"
#include "shoreline/bases/error.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/triangle_moments.hpp"

namespace shoreline {
namespace {

constexpr int highest_on_triangles = 2;

BodyMoments sized(std::size_t cells, int order) {
  const auto n = static_cast<Eigen::Index>(cells);
  return {.cell = {}, .centre = {2, n}, .whole = Eigen::VectorXd(n), .moment = {monomials(order), n}};
}

/// Moments about another centre, @p d back from the one they were taken about: ξ becomes ξ + d.
Eigen::VectorXd shifted(const Eigen::Ref<const Eigen::VectorXd>& moments, const Vec2& d, int order) {
  const auto place = [](int a, int b) { return monomials(a + b - 1) + b; };
  const auto binomial = [](int n, int k) {
    double value = 1.0;
    for (int i = 1; i <= k; ++i) value *= static_cast<double>(n - k + i) / i;
    return value;
  };
  Eigen::VectorXd result = Eigen::VectorXd::Zero(moments.size());
  for (int degree = 0; degree <= order; ++degree)
    for (int b = 0; b <= degree; ++b)
      for (int i = 0; i <= degree - b; ++i)
        for (int j = 0; j <= b; ++j)
          result[place(degree - b, b)] += binomial(degree - b, i) * binomial(b, j) * std::pow(d.x(), degree - b - i) *
                                          std::pow(d.y(), b - j) * moments[place(i, j)];
  return result;
}

/// Adds moments to those of a cell, which may not be there yet.
void add(Index cell, const Eigen::VectorXd& moment, std::vector<Index>& cells, std::vector<double>& moments) {
  const auto place = std::ranges::lower_bound(cells, cell) - cells.begin();
  const auto first = moments.begin() + place * moment.size();
  if (place == std::ssize(cells) || cells[static_cast<std::size_t>(place)] != cell) {
    cells.insert(cells.begin() + place, cell);
    moments.insert(first, moment.begin(), moment.end());
  } else {
    std::ranges::transform(moment, std::ranges::subrange(first, first + moment.size()), first, std::plus());
  }
}

/// A frame of cells around the grid takes what bulges out of it, which then counts for the cells at its border.
BodyMoments of_rectangles(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid, int order) {
  const QuadrilateralGrid framed(grid.bounds().lower - grid.spacing(), grid.spacing(),
                                 {grid.columns() + 2, grid.rows() + 2});
  const CellMoments found = cell_moments(curves, framed, order);
  std::vector<Index> cells;  // ascending, as those of the frame's lattice are
  std::vector<double> flat;
  std::vector<std::pair<Index, Eigen::VectorXd>> bulges;
  for (std::size_t k = 0; k < found.cell.size(); ++k) {
    const Index column = found.cell[k] % framed.columns() - 1;
    const Index row = found.cell[k] / framed.columns() - 1;
    const Index i = std::clamp(column, 0, grid.columns() - 1);
    const Index j = std::clamp(row, 0, grid.rows() - 1);
    const auto moment = found.moment.col(static_cast<Eigen::Index>(k));
    if (i == column && j == row) {
      cells.push_back(i + j * grid.columns());
      flat.insert(flat.end(), moment.begin(), moment.end());
    } else {
      const Vec2 from = Vec2(column - i, row - j).cwiseProduct(grid.spacing());
      bulges.emplace_back(i + j * grid.columns(), shifted(moment, from, order));
    }
  }
  for (const auto& [cell, moment] : bulges) add(cell, moment, cells, flat);
  BodyMoments moments = sized(cells.size(), order);
  moments.moment = Eigen::Map<const Eigen::MatrixXd>(flat.data(), moments.moment.rows(), moments.moment.cols());
  moments.whole.setConstant(grid.spacing().prod());
  for (Eigen::Index k = 0; k < moments.centre.cols(); ++k)
    moments.centre.col(k) = grid.corner(cells[static_cast<std::size_t>(k)]) + 0.5 * grid.spacing();
  moments.cell = std::move(cells);
  return moments;
}

BodyMoments of_triangles(std::span<const SplineCurve> curves, const TriangleGrid& grid, int order) {
  if (order < 0 || order > highest_on_triangles)
    throw InvalidArgument("body_moments: the order on triangles must be 0 to 2, got " + std::to_string(order));
  TriangleMoments found = triangle_moments(curves, grid, 1);
  BodyMoments moments = sized(found.sub_cell.size(), order);
  moments.cell = std::move(found.sub_cell);
  moments.moment = found.moment.topRows(monomials(order));
  for (Eigen::Index k = 0; k < moments.centre.cols(); ++k) {
    const auto [a, b, c] = corners(grid.mesh(), moments.cell[static_cast<std::size_t>(k)]);
    moments.centre.col(k) = (a + b + c) / 3.0;
    moments.whole[k] = 0.5 * twice_area(a, b, c);
  }
  return moments;
}

}  // namespace

int highest_order(const Grid& grid) {
  return dynamic_cast<const TriangleGrid*>(&grid) != nullptr ? highest_on_triangles : max_moment_order;
}

BodyMoments body_moments(std::span<const SplineCurve> curves, const Grid& grid, int order) {
  const auto* triangles = dynamic_cast<const TriangleGrid*>(&grid);
  BodyMoments moments = triangles != nullptr
                            ? of_triangles(curves, *triangles, order)
                            : of_rectangles(curves, dynamic_cast<const QuadrilateralGrid&>(grid), order);
  count(Work::moments, static_cast<long>(moments.cell.size()));
  return moments;
}

}  // namespace shoreline
