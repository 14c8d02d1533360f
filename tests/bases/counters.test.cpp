#include "shoreline/bases/counters.hpp"

#include <catch2/catch.hpp>
#include <thread>
#include <vector>

using namespace shoreline;

TEST_CASE("counts of all threads add up, also of those that have ended", "[bases][counters]") {
  const Counts before = counted();
  std::vector<std::thread> threads;
  for (int k = 1; k <= 4; ++k)
    threads.emplace_back([k] {
      for (int n = 0; n < 1000; ++n) count(Work::traces, k);
      count(Work::splines);
    });
  for (std::thread& thread : threads) thread.join();
  const Counts after = counted();
  for (std::size_t k = 0; k < after.size(); ++k) {
    const long expected = k == static_cast<std::size_t>(Work::traces)    ? 10000
                          : k == static_cast<std::size_t>(Work::splines) ? 4
                                                                         : 0;
    CHECK(after[k] - before[k] == expected);
  }
}

TEST_CASE("every count has a name of its own", "[bases][counters]") {
  for (std::size_t k = 0; k < Counts{}.size(); ++k) {
    CHECK(!name_of(static_cast<Work>(k)).empty());
    for (std::size_t j = 0; j < k; ++j) CHECK(name_of(static_cast<Work>(k)) != name_of(static_cast<Work>(j)));
  }
}
