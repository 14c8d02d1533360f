#include "shoreline/engine/element_blocks.hpp"

#include <array>
#include <catch2/catch.hpp>

#include "dense_blocks.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;

TEST_CASE("a block is zero at first and holds the sum of what is added to it", "[engine][element_blocks]") {
  test::Random random(1);
  ElementBlocks blocks;
  CHECK(blocks.size() == 0);
  blocks.append(std::array<Index, 1>{9});
  const std::size_t b = blocks.append(std::array<Index, 3>{7, 2, 4});
  CHECK(b == 1);
  CHECK(blocks.size() == 2);
  CHECK(blocks.functions_in(b) == 3);
  CHECK(test::block_matrix(blocks, b).isZero(0.0));
  CHECK(blocks.force_of(b).isZero(0.0));

  const Eigen::MatrixXd half = Eigen::MatrixXd::NullaryExpr(6, 6, [&] { return random.uniform(-1.0, 1.0); });
  const Eigen::MatrixXd symmetric = half + half.transpose();
  blocks.add(b, symmetric);
  blocks.add(b, 2.0 * symmetric);
  blocks.append(std::array<Index, 2>{0, 1});  // the store may move: nothing is lost
  CHECK((test::block_matrix(blocks, b) - 3.0 * symmetric).norm() < 1e-14);
  CHECK(test::block_matrix(blocks, 0).isZero(0.0));
}

TEST_CASE("many blocks appended at once are as if appended one by one", "[engine][element_blocks]") {
  ElementBlocks one_by_one;
  ElementBlocks at_once;
  for (ElementBlocks* blocks : {&one_by_one, &at_once}) blocks->append(std::array<Index, 1>{4});
  for (int b = 0; b < 3; ++b) one_by_one.append(std::array<Index, 2>{b, b + 1});
  CHECK(at_once.append(3, 2) == 1);
  for (Index b = 0; b < 3; ++b)
    for (Index k = 0; k < 2; ++k) at_once.function[static_cast<std::size_t>(at_once.first[1] + 2 * b + k)] = b + k;
  CHECK(at_once.first == one_by_one.first);
  CHECK(at_once.function == one_by_one.function);
  CHECK(at_once.entry == one_by_one.entry);
  CHECK(at_once.matrix == one_by_one.matrix);
  CHECK(at_once.force == one_by_one.force);
}

TEST_CASE("a block times coefficients is the dense product", "[engine][element_blocks]") {
  test::Random random(2);
  for (int draw = 0; draw < 20; ++draw) {
    const ElementBlocks blocks = test::random_blocks(random, 12, 8);
    const Eigen::Matrix2Xd field = random.field(12);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      Eigen::VectorXd local(2 * blocks.functions_in(b));
      for (Eigen::Index a = 0; a < blocks.functions_in(b); ++a)
        local.segment<2>(2 * a) = field.col(blocks.function[static_cast<std::size_t>(blocks.first[b] + a)]);
      CHECK_THAT((blocks.times(b, field) - test::block_matrix(blocks, b) * local).norm(), WithinAbs(0.0, 1e-13));
    }
  }
}

TEST_CASE("cleared blocks are gone, and new ones start from zero", "[engine][element_blocks]") {
  test::Random random(3);
  ElementBlocks blocks = test::random_blocks(random, 6, 5);
  blocks.clear();
  CHECK(blocks.size() == 0);
  const std::size_t b = blocks.append(std::array<Index, 2>{3, 1});
  CHECK(b == 0);
  CHECK(test::block_matrix(blocks, b).isZero(0.0));
  CHECK(blocks.force_of(b).isZero(0.0));
}
