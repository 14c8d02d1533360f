#include "../../engine/src/constraint_rows.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "../random.hpp"
#include "constrained.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

TEST_CASE("rows are solved: all hold, none twice, and no slave is a master", "[engine][constraint_rows]") {
  test::Random random(1);
  constexpr Index unknowns = 12;
  for (int draw = 0; draw < 50; ++draw) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::NullaryExpr(
        10, unknowns, [&] { return random.uniform(0.0, 1.0) < 0.3 ? random.uniform(-1.0, 1.0) : 0.0; });
    for (const Eigen::Index r : {2, 5, 8}) matrix.row(r) = matrix.row(r - 1) - 0.5 * matrix.row(r - 2);  // implied
    const Eigen::VectorXd value = matrix * random.field(unknowns / 2).reshaped();
    ConstraintRows rows;
    for (Eigen::Index r = 0; r < 10; ++r) {
      ConstraintRow row{.coefficient = {}, .value = value[r], .piece = 7};
      for (Index c = 0; c < unknowns; ++c)
        if (matrix(r, c) != 0.0) row.coefficient.emplace(c, matrix(r, c) + random.uniform(-1e-11, 1e-11));  // rounding
      rows.add(row);
    }
    const std::vector<Constraint> solved = rows.solved();
    CHECK(test::count(solved) == test::rank(matrix));
    std::set<std::pair<Index, int>> slaves;
    for (const Constraint& c : solved) slaves.emplace(c.function, c.component);
    CHECK(slaves.size() == solved.size());
    for (const Constraint& c : solved) {
      CHECK(c.piece == 7);
      for (const ComponentTerm& m : c.masters) CHECK_FALSE(slaves.contains({m.function, m.component}));
    }
    const Eigen::Matrix2Xd any = test::constrained(random.field(unknowns / 2), solved);
    CHECK_THAT((matrix * any.reshaped() - value).norm(), WithinAbs(0.0, 1e-7));
  }
}
