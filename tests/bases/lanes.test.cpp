#include "shoreline/bases/lanes.hpp"

#include <catch2/catch.hpp>

using namespace shoreline;

namespace {

/// Entry k of point l is 10 k + l.
LaneTensor numbered() {
  LaneTensor tensor;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t l = 0; l < lanes; ++l) tensor[k][l] = 10.0 * static_cast<double>(k) + static_cast<double>(l);
  return tensor;
}

/// Whether put_sums of M numbers, and of as many again, gives those of each.
template <std::size_t M>
bool sums_are_right() {
  std::array<Lanes, M> numbers;
  for (std::size_t k = 0; k < M; ++k)
    for (std::size_t l = 0; l < lanes; ++l) numbers[k][l] = 0.1 * static_cast<double>(7 * k + 3 * l * l + 1);
  std::array<double, M> sum{};
  bool right = true;
  for (const double times : {1.0, 2.0}) {
    put_sums(numbers, times > 1.0, sum.data());
    for (std::size_t k = 0; k < M; ++k) right &= sum[k] == times * sum_of(numbers[k]);
  }
  return right;
}

}  // namespace

TEST_CASE("rows and lanes of four points change places, and back", "[bases][lanes]") {
  const LaneTensor before = numbered();
  const LaneTensor rows = transposed(before);
  const LaneTensor after = transposed(rows);
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t l = 0; l < lanes; ++l) {
      CHECK(rows[l][k] == before[k][l]);
      CHECK(after[k][l] == before[k][l]);
    }
}

TEST_CASE("sums over lanes are those of each number, to the last digit, however many there are", "[bases][lanes]") {
  CHECK(sums_are_right<1>());
  CHECK(sums_are_right<4>());
  CHECK(sums_are_right<6>());
  CHECK(sums_are_right<27>());
}

TEST_CASE("a comparison holds where it holds in every lane", "[bases][lanes]") {
  const Lanes numbers{1.0, 2.0, 3.0, 4.0};
  CHECK(all_of(numbers > 0.5));
  for (std::size_t l = 0; l < lanes; ++l) {
    Lanes other = numbers;
    other[l] = 0.0;
    CHECK_FALSE(all_of(other > 0.5));
  }
}
