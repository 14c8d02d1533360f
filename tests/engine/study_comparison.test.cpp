// What runs without an exact solution are compared with, engine/src/study/comparison.hpp.

#include <catch2/catch.hpp>
#include <cmath>

#include "study/comparison.hpp"
#include "study_rows.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::failed;
using test::study_row;

namespace {

/// Runs at sizes h whose vectors q are q0 + c hᵖ.
std::vector<StudyRow> sequence(const std::vector<double>& sizes, double order) {
  std::vector<StudyRow> rows;
  for (const double h : sizes) {
    rows.push_back(study_row("line", h, {}, 1.0));
    const double power = std::pow(h, order);
    rows.back().result.quantities = {{"q", {2.0 + 3.0 * power, -1.0 + 0.5 * power, 4.0 * power}},
                                     {"energy", {7.0 - power}}};
  }
  return rows;
}

}  // namespace

TEST_CASE("Richardson's limit of q0 + c h^p is q0, whatever the order and the ratio", "[engine][study]") {
  const double order = GENERATE(0.5, 1.0, 2.0, 3.7);
  const double ratio = GENERATE(0.5, 0.7);
  CAPTURE(order, ratio);
  std::vector<double> sizes{1.0, ratio, ratio * ratio, ratio * ratio * ratio};
  std::vector<StudyRow> rows = sequence(sizes, order);
  rows[0].result.quantities["q"] = {100.0, 100.0, 100.0};  // not among the last three
  const Json limit = richardson_limit(rows).quantities;
  const std::vector<double> expected{2.0, -1.0, 0.0};
  for (std::size_t i = 0; i < 3; ++i) CHECK(limit["q"][i].get<double>() == Approx(expected[i]).margin(1e-12));
  CHECK(limit["energy"][0].get<double>() == Approx(7.0).epsilon(1e-13));
}

TEST_CASE("Richardson's limit is the same for numbers that grow as for sizes that shrink", "[engine][study]") {
  std::vector<StudyRow> rows = sequence({0.5, 0.25, 0.125}, 2.0);
  const Json limit = richardson_limit(rows).quantities;
  for (StudyRow& row : rows) row.plan.refinement = 1.0 / *row.plan.refinement;
  CHECK(richardson_limit(rows).quantities == limit);
}

TEST_CASE("a Richardson limit takes three completed runs of one ratio on the line of the finest", "[engine][study]") {
  CHECK_THAT(richardson_limit(sequence({1.0, 0.5}, 2.0)).with, Contains("2 completed runs"));
  CHECK(richardson_limit(sequence({1.0, 0.5}, 2.0)).quantities.is_null());

  std::vector<StudyRow> rows = sequence({1.0, 0.5, 0.25}, 2.0);
  rows[1] = failed(rows[1], "out of memory");
  CHECK(richardson_limit(rows).quantities.is_null());
  rows = sequence({1.0, 0.5, 0.25}, 2.0);
  rows[0].plan.line = "another";
  CHECK(richardson_limit(rows).quantities.is_null());

  const Comparison uneven = richardson_limit(sequence({1.0, 0.5, 0.2}, 2.0));
  CHECK(uneven.quantities.is_null());
  CHECK_THAT(uneven.with, Contains("one ratio (2, 2.5)"));
  CHECK_FALSE(richardson_limit(sequence({1.0, 0.5, 0.251}, 2.0)).quantities.is_null());  // one to 1 %
  CHECK_THAT(richardson_limit({}).with, Contains("no run completed"));
}

TEST_CASE("quantities whose differences do not fall have no limit", "[engine][study]") {
  const auto of = [](const std::vector<std::vector<double>>& values) {
    std::vector<StudyRow> rows = sequence({1.0, 0.5, 0.25}, 1.0);
    for (std::size_t i = 0; i < 3; ++i) {
      rows[i].result.quantities["q"] = values[i];
      rows[i].result.quantities["sure"] = Json::array({1.0 + 0.1 / (1 << i)});
    }
    return richardson_limit(rows).quantities;
  };
  CHECK_FALSE(of({{1.0}, {2.0}, {3.0}}).contains("q"));                         // steady
  CHECK_FALSE(of({{1.0}, {2.0}, {4.0}}).contains("q"));                         // growing
  CHECK(of({{2.0}, {2.0}, {2.0}})["q"][0] == 2.0);                              // the same
  CHECK_FALSE(of({{1.0}, {1.5}, {1.7, 1.8}}).contains("q"));                    // other points
  CHECK_FALSE(of({{1.0}, {std::nan("")}, {1.7}}).contains("q"));                // not a number
  CHECK(of({{1.0}, {2.0}, {2.0}})["q"][0] == 2.0);                              // has arrived
  CHECK(of({{1.0}, {2.0}, {1.5}})["q"][0].get<double>() == Approx(1.5 - 0.5));  // to and fro
  CHECK(of({{1.0}, {2.0}, {4.0}})["sure"][0].get<double>() == Approx(1.0));     // the others keep theirs
}

TEST_CASE("the finest run is the completed one with the most unknowns, of several the last", "[engine][study]") {
  std::vector<StudyRow> rows = sequence({0.25, 0.5, 0.25, 0.125}, 1.0);
  rows[3] = failed(rows[3], "crashed");
  const Comparison comparison = finest_run(rows);
  CHECK(comparison.row == 2);
  CHECK(comparison.quantities == rows[2].result.quantities);
  CHECK(finest_run({rows[3]}).quantities.is_null());
}

TEST_CASE("a difference is relative to the reference, and absolute where that vanishes", "[engine][study]") {
  std::vector<StudyRow> rows = sequence({1.0, 0.5, 0.25}, 1.0);
  rows[0].result.quantities = {{"q", {3.0, 8.0}}, {"null", {0.3, 0.4}}, {"curve", {1.0, 2.0}}, {"mine", {1.0}}};
  rows[1] = failed(rows[1], "crashed");
  const Json reference = {{"q", {3.0, 4.0}}, {"null", {0.0, 0.0}}, {"curve", {1.0}}, {"other", {1.0}}};
  for (const std::size_t r : {0U, 1U}) compare({"differences", reference, {}}, rows[r]);
  CHECK(rows[0].norms.at("q") == Approx(4.0 / 5.0));
  CHECK(rows[0].norms.at("null") == Approx(0.5));
  CHECK(rows[0].norms.size() == 2);  // what only one of them has, or in other numbers, cannot be compared
  CHECK(rows[1].norms.empty());
  compare({"nothing", Json(), {}}, rows[2]);
  CHECK(rows[2].norms.empty());
}
