#pragma once
// Equations in the order of the grid, in which a matrix is a band.

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdlib>
#include <numeric>

#include "shoreline/engine/linear_solver.hpp"

namespace shoreline {

struct BandOrder {
  std::vector<Index> position;  ///< (equations) of each in the order
  Index width = 0;              ///< max |position(i) − position(j)| over coupled equations
};

/// Positions of equations sorted by place, along one axis and within it along the other, then by component.
/// @param slow  axis along which the order advances last: 0 for columns of the grid
[[nodiscard]] inline std::vector<Index> grid_positions(const Unknowns& unknowns, int slow) {
  struct Place {
    double line, along;
    Index component, equation;
    auto operator<=>(const Place&) const = default;
  };
  const Eigen::Matrix2Xd& x = unknowns.place;
  const double same = 1e-9 * (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();  // but for rounding
  std::vector<Place> places;
  for (Index e = 0; e < x.cols(); ++e)
    places.push_back({same > 0.0 ? std::round(x(slow, e) / same) : 0.0, x(1 - slow, e), unknowns.component[e], e});
  std::ranges::sort(places, [](const Place& a, const Place& b) { return (a <=> b) < 0; });
  std::vector<Index> position(places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
    position[static_cast<std::size_t>(places[k].equation)] = static_cast<Index>(k);
  return position;
}

/// Columns or rows of the grid, or the numbers as they are: whichever order gives the narrowest band.
/// @param each_pair  calls its argument with both equations of every coupled pair
template <class EachPair>
[[nodiscard]] BandOrder narrowest_order(const Unknowns& unknowns, EachPair&& each_pair) {
  const auto with_width = [&](std::vector<Index> position) {
    Index width = 0;
    each_pair([&](Index i, Index j) {
      width = std::max(width, std::abs(position[static_cast<std::size_t>(i)] - position[static_cast<std::size_t>(j)]));
    });
    return BandOrder{std::move(position), width};
  };
  std::vector<Index> numbers(static_cast<std::size_t>(unknowns.place.cols()));
  std::iota(numbers.begin(), numbers.end(), 0);
  BandOrder best = with_width(std::move(numbers));
  for (const int slow : {0, 1})
    if (BandOrder other = with_width(grid_positions(unknowns, slow)); other.width < best.width) best = std::move(other);
  return best;
}

}  // namespace shoreline
