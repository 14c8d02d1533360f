#include "shoreline/engine/material_points.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "../bases/meshes.hpp"
#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/powell_sabin.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;

namespace {

MaterialPoints random_points(test::Random& random, const Grid& grid, Index count) {
  Eigen::Matrix2Xd position(2, count);
  for (Index p = 0; p < count; ++p) position.col(p) = random.in(grid.bounds());
  MaterialPoints points = points_at(position, Eigen::VectorXd::LinSpaced(count, 1.0, 2.0));
  points.displacement = random.field(count);
  points.stress.setRandom();
  points.strain = Eigen::Matrix3Xd::Random(3, count);
  return points;
}

}  // namespace

TEST_CASE("points start at rest without stress", "[engine][material_points]") {
  const MaterialPoints points = points_at(Eigen::Matrix2Xd::Ones(2, 3), Eigen::VectorXd::Ones(3));
  CHECK(points.size() == 3);
  CHECK(points.displacement == Eigen::Matrix2Xd::Zero(2, 3));
  CHECK(points.stress == Eigen::Matrix4Xd::Zero(4, 3));
  CHECK(points.strain.cols() == 0);
  CHECK(points.on_outline.empty());
}

TEST_CASE("every point is listed once, with its cell and the basis there", "[engine][material_points]") {
  test::Random random(1);
  PointSupports supports;
  for (int draw = 0; draw < 20; ++draw) {
    const BilinearBasis basis(random.grid());
    const MaterialPoints points = random_points(random, basis.grid(), random.whole(1, 60));
    supports = locate_points(basis, points, std::move(supports));

    std::vector<Index> listed = supports.point;
    std::ranges::sort(listed);
    std::vector<Index> all(static_cast<std::size_t>(points.size()));
    std::iota(all.begin(), all.end(), 0);
    CHECK(listed == all);
    CHECK(std::ranges::is_sorted(supports.cell));
    CHECK(std::ranges::count(supports.active, 1) == supports.cells());
    REQUIRE(supports.functions == 4);
    BasisAtPoints at_points(basis, supports);
    for (std::size_t c = 0; c < supports.cell.size(); ++c) {
      CHECK(supports.active[static_cast<std::size_t>(supports.cell[c])] == 1);
      CHECK(supports.first[c] < supports.first[c + 1]);
      at_points.evaluate(static_cast<Index>(c));
      for (Index k = supports.first[c]; k < supports.first[c + 1]; ++k) {
        const Vec2 x = points.position.col(supports.point[static_cast<std::size_t>(k)]);
        CHECK(supports.place[static_cast<std::size_t>(k)] == x);
        CHECK(basis.grid().locate(x, 0) == supports.cell[c]);
        const Support support = basis.support(supports.cell[c], x);
        CHECK(std::equal(support.value.begin(), support.value.end(), at_points.value(k)));
        CHECK(
            std::equal(support.gradient.reshaped().begin(), support.gradient.reshaped().end(), at_points.gradient(k)));
      }
    }
    CHECK(supports.first.back() == points.size());
  }
}

TEST_CASE("an element is active with all its parts as soon as one of them holds a point", "[engine][material_points]") {
  test::Random random(3);
  const PowellSabinBasis basis(test::lattice(4, 3, TrianglePattern::four));
  for (int draw = 0; draw < 20; ++draw) {
    const MaterialPoints points = random_points(random, basis.grid(), random.whole(1, 30));
    const PointSupports supports = locate_points(basis, points);
    std::vector<char> expected(static_cast<std::size_t>(basis.grid().cells()), 0);
    for (const Index cell : supports.cell)
      for (Index part = 0; part < 6; ++part) expected[static_cast<std::size_t>(cell / 6 * 6 + part)] = 1;
    CHECK(supports.active == expected);
    CHECK(std::ranges::count(supports.active, 1) > supports.cells());
  }
}

TEST_CASE("the cell of a point on an edge depends neither on the order of points nor on the number of threads",
          "[engine][material_points]") {
  test::Random random(4);
  const PowellSabinBasis basis(delaunay(test::jittered_points(6, 6, random)));
  Eigen::Matrix2Xd position(2, 30000);  // more than one thread needs
  for (Index p = 0; p < position.cols(); ++p) {
    const auto corner = corners(basis.grid().mesh(), random.whole(0, basis.grid().cells() - 1));
    const double s = random.whole(0, 4) / 4.0;  // on edges, vertices among them
    position.col(p) = (1.0 - s) * corner[0] + s * corner[1];
  }
  const auto cell_of = [&](const Eigen::Matrix2Xd& places) {
    const PointSupports supports = locate_points(basis, points_at(places, Eigen::VectorXd::Ones(places.cols())));
    std::vector<Index> cell(static_cast<std::size_t>(places.cols()));
    for (std::size_t c = 0; c < supports.cell.size(); ++c)
      for (Index k = supports.first[c]; k < supports.first[c + 1]; ++k)
        cell[static_cast<std::size_t>(supports.point[static_cast<std::size_t>(k)])] = supports.cell[c];
    return cell;
  };
  const std::vector<Index> cell = cell_of(position);
  std::vector<Index> backwards = cell_of(position.rowwise().reverse());
  std::ranges::reverse(backwards);
  CHECK(cell == backwards);
  for (std::size_t p = 0; p < cell.size(); ++p)
    REQUIRE(cell[p] == basis.grid().locate(position.col(static_cast<Index>(p)), 0));
}

TEST_CASE("points outside the grid are counted and the first is placed", "[engine][material_points]") {
  const BilinearBasis basis(QuadrilateralGrid(Vec2::Zero(), Vec2::Ones(), {2, 2}));
  Eigen::Matrix2Xd position(2, 4);
  position << 0.5, 2.5, 1.0, -0.25, 0.5, 1.5, 1.0, 0.75;
  const MaterialPoints points = points_at(position, Eigen::VectorXd::Ones(4));
  CHECK_THROWS_AS(locate_points(basis, points), ComputationError);
  CHECK_THROWS_WITH(locate_points(basis, points), Contains("2 of 4") && Contains("point 1") && Contains("(2.5, 1.5)") &&
                                                      Contains("enlarge the grid"));
  CHECK_THROWS_WITH(check_inside(basis, points), Contains("2 of 4") && Contains("point 1"));
  position(0, 1) = position(0, 3) = std::nan("");
  CHECK_THROWS_WITH(check_inside(basis, points_at(position, Eigen::VectorXd::Ones(4))), Contains("2 of 4"));
  position(0, 1) = position(0, 3) = 2.0;
  CHECK_NOTHROW(check_inside(basis, points_at(position, Eigen::VectorXd::Ones(4))));
}

TEST_CASE("a point on the outline and on a grid line belongs to the body's side", "[engine][material_points]") {
  const BilinearBasis basis(QuadrilateralGrid(Vec2::Zero(), Vec2(0.1, 0.1), {4, 4}));
  for (Index i = 0; i <= 4; ++i)
    for (Index j = 0; j <= 4; ++j)
      for (const Vec2& inward : {Vec2(0.6, 0.8), Vec2(-0.6, 0.8), Vec2(-0.6, -0.8), Vec2(0.6, -0.8)}) {
        const Vec2 node = basis.grid().node(i + 5 * j);
        const auto side = basis.grid().locate(node + 0.01 * inward, 0);
        if (!side) continue;
        MaterialPoints points = points_at(node, Eigen::VectorXd::Ones(1));
        points.on_outline.push_back({0, inward});
        CHECK(locate_points(basis, points).cell == std::vector<Index>{*side});
      }
}

TEST_CASE("sorting by cell keeps every point with all that it carries, in ascending cells",
          "[engine][material_points]") {
  test::Random random(2);
  for (int draw = 0; draw < 20; ++draw) {
    const BilinearBasis basis(random.grid());
    const MaterialPoints before = random_points(random, basis.grid(), 50);
    MaterialPoints after = before;
    after.on_outline = {{7, Vec2::UnitX()}, {31, -Vec2::UnitY()}};
    sort_by_cell(basis, after);

    Index cell = 0;
    for (Index k = 0; k < 50; ++k) {
      const Index here = basis.grid().locate(after.position.col(k), 0).value();
      CHECK(here >= cell);
      cell = here;
      Index p = 0;
      while (before.volume[p] != after.volume[k]) ++p;  // each point has its own volume
      CHECK(after.position.col(k) == before.position.col(p));
      CHECK(after.displacement.col(k) == before.displacement.col(p));
      CHECK(after.stress.col(k) == before.stress.col(p));
      CHECK(after.strain.col(k) == before.strain.col(p));
    }
    CHECK_THAT(after.volume.sum(), Catch::Matchers::WithinAbs(before.volume.sum(), 1e-12));
    CHECK(after.position.col(after.on_outline[0].point) == before.position.col(7));
    CHECK(after.position.col(after.on_outline[1].point) == before.position.col(31));
  }
}
