#include "shoreline/engine/macro_elements.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "../every_grid.hpp"

using namespace shoreline;

namespace {

std::vector<Index> sizes(const MacroElements& groups) {
  std::vector<Index> size(static_cast<std::size_t>(groups.count), 0);
  for (const Index group : groups.of_element) ++size.at(static_cast<std::size_t>(group));
  return size;
}

/// Numbers of the elements of a group that can be reached from its first one over shared faces.
std::size_t connected(const MacroElements& groups, const Grid& grid, Index group) {
  const auto first = std::ranges::find(groups.of_element, group) - groups.of_element.begin();
  std::vector<Index> reached{static_cast<Index>(first)};
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (Index part = 0; part < grid.parts(); ++part)
      for (const Face& face : grid.faces(reached[k] * grid.parts() + part)) {
        const Index other = face.neighbour / grid.parts();
        if (groups.of_element[static_cast<std::size_t>(other)] == group && std::ranges::count(reached, other) == 0)
          reached.push_back(other);
      }
  return reached.size();
}

}  // namespace

TEST_CASE(
    "each element is in one macro-element, which hangs together, polynomials are a third of the unknowns, or half",
    "[engine][macro_elements]") {
  for (const Index cells : {1, 2, 3, 7, 12})
    for (const auto& [name, grid] : test::every_grid(Vec2::Zero(), 1.0, cells)) {
      CAPTURE(name, cells);
      const auto basis = test::basis_of(grid);
      const MacroElements groups = macro_elements(*basis);
      REQUIRE(static_cast<Index>(groups.of_element.size()) == basis->grid().cells() / basis->grid().parts());
      const std::vector<Index> size = sizes(groups);
      for (Index group = 0; group < groups.count; ++group) {
        CHECK(size[static_cast<std::size_t>(group)] > 0);
        CHECK(connected(groups, basis->grid(), group) ==
              static_cast<std::size_t>(size[static_cast<std::size_t>(group)]));
      }
      if (cells > 1)
        CHECK(static_cast<double>(groups.polynomials.size() * groups.count) <=
              0.5 * 2.0 * static_cast<double>(basis->functions()));
    }
}

TEST_CASE("blocks of cells are 3 x 3 where their number allows, else as even as can be", "[engine][macro_elements]") {
  Case::Grid grid{.lower = Vec2::Zero(), .upper = Vec2(9.0, 6.0), .cell_size = Vec2(1.0, 1.0)};
  CHECK(sizes(macro_elements(*test::basis_of(grid))) == std::vector<Index>(6, 9));
  grid.upper = Vec2(8.0, 3.0);
  CHECK(sizes(macro_elements(*test::basis_of(grid))) == std::vector<Index>{12, 12});
}

TEST_CASE("polynomials are those of the degree", "[engine][macro_elements]") {
  const Vec2 x(2.0, 3.0);
  CHECK(PolynomialSpace{2}(x) == (Eigen::VectorXd(6) << 1, 2, 4, 3, 6, 9).finished());
  CHECK(PolynomialSpace{1, true}(x) == (Eigen::VectorXd(4) << 1, 2, 3, 6).finished());
}

TEST_CASE("macro-elements that are less than half full are joined to those beside them", "[engine][macro_elements]") {
  const Case::Grid grid{.lower = Vec2::Zero(), .upper = Vec2(9.0, 3.0), .cell_size = Vec2(1.0, 1.0)};
  const auto basis = test::basis_of(grid);
  const MacroElements groups = macro_elements(*basis);
  REQUIRE(groups.count == 3);
  std::vector<double> volume(27, 1.0);
  CHECK(without_slivers(groups, basis->grid(), volume).of_element == groups.of_element);
  for (std::size_t c = 0; c < volume.size(); ++c)
    if (c % 9 > 6) volume[c] = 0.0;  // of the last block, one column in three is left
  const MacroElements joined = without_slivers(groups, basis->grid(), volume);
  for (std::size_t c = 0; c < volume.size(); ++c) CHECK(joined.of_element[c] == std::min(groups.of_element[c], 1));
}
