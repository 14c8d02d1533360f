// The answer to a tolerance, engine/src/study/answer.hpp, with runs that a test makes up.

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "case_file/overrides.hpp"
#include "shoreline/engine/failures.hpp"
#include "study/answer.hpp"
#include "study_rows.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::failed;
using test::study_row;
using test::study_table;

namespace {

const std::string norm = "stress.l2_relative";

Json square() {
  Json boundaries = Json::array();
  const Json corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const std::size_t k : {0U, 1U, 2U, 3U})
    boundaries.push_back({{"name", std::to_string(k)},
                          {"points", {corners[k], corners[(k + 1) % 4]}},
                          {"condition", {{"type", "roller"}, {"method", "implicit_boundary"}, {"band", 0.01}}}});
  return {{"analysis", {{"type", "quasi_static"}, {"plane", "strain"}}},
          {"material", {{"type", "linear_elastic"}, {"youngs_modulus", 1e6}, {"poissons_ratio", 0.3}}},
          {"grid", {{"lower", {-0.5, -0.5}}, {"upper", {1.5, 1.5}}, {"cell_size", 0.25}}},
          {"boundaries", boundaries},
          {"material_points", {{"per_cell", 2}}}};
}

Json case_of(const PlannedRun& plan) {
  Json json = square();
  for (const std::string& setting : plan.settings) override_value(json, setting);
  return json;
}

bool changes(const std::vector<std::string>& more, const std::string& what) {
  return std::ranges::any_of(more, [&](const std::string& setting) { return setting.find(what) != std::string::npos; });
}

StudyRow with_error(double error) { return study_row("refined", 0.25, {{norm, error}}, 1.0); }

StudyRow row(const std::string& line, double h, double error, double seconds) {
  return study_row(line, h, {{norm, error}}, seconds);
}

/// What is left of the error of any run once the named part is refined; others leave all of it.
RunMore leaving(const std::map<std::string, double>& left, double error) {
  return [=](const PlannedRun&, const std::vector<std::string>& more) {
    for (const auto& [key, share] : left)
      if (changes(more, key)) return with_error(share * error);
    return with_error(error);
  };
}

}  // namespace

TEST_CASE("the cheapest setting that holds on a shifted grid is chosen, and cheaper ones are named as refused",
          "[engine][study]") {
  const StudyTable table = study_table({row("dear", 0.25, 0.001, 4.0), row("good", 0.25, 0.009, 3.0),
                                        row("failing", 0.25, 0.001, 2.0), row("lucky", 0.25, 0.001, 1.0),
                                        row("poor", 0.25, 0.011, 0.1), failed(row("gone", 0.25, 0.0, 0.1), "crashed")});
  std::vector<std::string> shifted;
  const RunMore run = [&](const PlannedRun& plan, const std::vector<std::string>& more) {
    if (!changes(more, "grid.lower")) return with_error(0.009);
    shifted.push_back(plan.line);
    if (plan.line == "lucky") return with_error(0.02);
    return plan.line == "failing" ? failed(with_error(0.0095), "it crashed there") : with_error(0.0095);
  };
  const Answer found = answer(table, {norm, 0.01}, case_of, run);
  CHECK(found.chosen == 1);
  CHECK(shifted == std::vector<std::string>{"lucky", "failing", "good"});
  CHECK_THAT(found.text,
             Contains("not basis lucky, grid.cell_size 0.25: on a grid shifted by (0.37, 0.21) cells 2.00e-02"));
  CHECK_THAT(found.text, Contains("not basis failing, grid.cell_size 0.25: on a shifted grid it crashed there"));
  CHECK_THAT(found.text, Contains("basis good, grid.cell_size 0.25") && !Contains("not basis good"));
}

TEST_CASE("a setting whose grid has no other place is chosen without a look there, and the answer says so",
          "[engine][study]") {
  const auto on_lines = [](const PlannedRun& plan) {
    Json json = case_of(plan);
    json["boundaries"][1]["condition"] = {{"type", "roller"}, {"method", "grid"}};
    return json;
  };
  const StudyTable table = study_table({row("held", 0.25, 0.01, 1.0)});
  const RunMore run = [](const PlannedRun&, const std::vector<std::string>& more) {
    CHECK_FALSE(changes(more, "grid.lower"));
    return with_error(0.01);
  };
  const Answer found = answer(table, {norm, 0.01}, on_lines, run);
  CHECK(found.chosen == 0);
  CHECK_THAT(found.text, Contains("not tried on a shifted grid"));
}

TEST_CASE("an error that is just the tolerance meets it", "[engine][study]") {
  const StudyTable table = study_table({row("good", 0.25, 0.01, 1.0)});
  CHECK(answer(table, {norm, 0.01}, case_of, leaving({}, 0.01)).chosen == 0);
  CHECK_FALSE(answer(table, {norm, std::nextafter(0.01, 0.0)}, case_of, leaving({}, 0.01)).chosen);
}

TEST_CASE("where none holds on a shifted grid none is chosen, and each is named", "[engine][study]") {
  const StudyTable table = study_table({row("a", 0.25, 0.001, 1.0), row("b", 0.25, 0.001, 2.0)});
  const Answer found = answer(table, {norm, 0.01}, case_of, leaving({}, 0.02));
  CHECK_FALSE(found.chosen);
  CHECK_THAT(found.text, Contains("no setting") && Contains("on a shifted grid, too") && Contains("not basis a") &&
                             Contains("not basis b"));
}

TEST_CASE("a line with errors C h^p and times c h^-s is extrapolated to where it meets the tolerance",
          "[engine][study]") {
  const double order = GENERATE(1.0, 2.0, 3.5);
  const double growth = GENERATE(1.0, 2.0, 3.0);
  const auto error = [&](double h) { return 0.5 * std::pow(h, order); };
  const auto seconds = [&](double h) { return 0.25 * std::pow(h, -growth); };
  std::vector<StudyRow> rows;
  for (const double h : {0.5, 0.25, 0.125}) rows.push_back(row("line", h, error(h), seconds(h)));
  const double h = 1.0 / 64.0;
  const std::string told = fmt::format("about {:.2g} s: line, grid.cell_size {:.2g}", seconds(h), h);

  const bool last_failed = GENERATE(false, true);  // as where it met its budget
  if (last_failed) rows.push_back(failed(row("line", 0.0625, 0.0, 1.0), "took longer"));
  StudyTable table = study_table(rows);
  add_rates(table.rows);
  CAPTURE(order, growth, last_failed);
  CHECK_THAT(answer(table, {norm, error(h)}, case_of, leaving({}, 0.0)).text, Contains(told));

  for (StudyRow& numbers : table.rows) numbers.plan.refinement = 1.0 / *numbers.plan.refinement;
  CHECK_THAT(answer(table, {norm, error(h)}, case_of, leaving({}, 0.0)).text, Contains("grid.cell_size 64"));

  const Answer met = answer(table, {norm, 10.0 * error(h)}, case_of, leaving({}, 0.0));
  if (met.chosen) CHECK_THAT(met.text, Contains(fmt::format("{:<8.1e}no run", error(h))) && Contains("about"));
}

TEST_CASE("of several lines the one that gets there in the least time is told", "[engine][study]") {
  StudyTable table =
      study_table({row("slow", 0.5, 0.4, 1.0), row("slow", 0.25, 0.2, 4.0), row("fast", 0.5, 0.4, 1.0),
                   row("fast", 0.25, 0.1, 5.0), row("steady", 0.5, 0.3, 0.1), row("steady", 0.25, 0.3, 0.1)});
  add_rates(table.rows);
  const std::string text = answer(table, {norm, 0.025}, case_of, leaving({}, 0.0)).text;
  CHECK_THAT(text, Contains("about 25 s: fast, grid.cell_size 0.12"));  // one more halving
  CHECK_THAT(answer(study_table({table.rows[4], table.rows[5]}), {norm, 0.025}, case_of, leaving({}, 0.0)).text,
             !Contains("about"));
}

TEST_CASE("what the next digits cost is read off the study where it has them", "[engine][study]") {
  StudyTable table = study_table({row("line", 0.5, 0.01, 2.0), row("line", 0.25, 0.001, 6.0)});
  add_rates(table.rows);
  const std::string text = answer(table, {norm, 0.01}, case_of, leaving({}, 0.01)).text;
  CHECK_THAT(text, Contains("1.0e-03 6 s, 3 times as much: basis line, grid.cell_size 0.25"));
  CHECK_THAT(text, Contains("1.0e-04 no run of this study") && Contains("about 18 s"));
}

TEST_CASE("the part whose refinement leaves the least error dominates", "[engine][study]") {
  const StudyTable table = study_table({row("line", 0.25, 0.01, 1.0)});
  const auto found = [&](const std::map<std::string, double>& left) {
    return answer(table, {norm, 0.01}, case_of, leaving(left, 0.01));
  };
  CHECK(found({{"grid.cell_size", 0.3}, {"band", 0.6}}).dominant == "grid");
  CHECK(found({{"grid.cell_size", 0.6}, {"band", 0.3}}).dominant == "band");
  CHECK(found({{"per_cell", 0.3}}).dominant == "points");
  CHECK(found({{"load_steps", 0.89}}).dominant == "time step");
  const Answer none = found({{"load_steps", 0.91}, {"band", 1.2}});
  CHECK(none.dominant.empty());
  CHECK_THAT(none.text, Contains("no part dominates"));
  CHECK(none.error_left.at("time step") == Approx(0.0091));
  CHECK(none.error_left.at("band") == Approx(0.012));
  CHECK(none.error_left.at("grid") == Approx(0.01));
}

TEST_CASE("a part whose refined run fails does not dominate", "[engine][study]") {
  const StudyTable table = study_table({row("line", 0.25, 0.01, 1.0)});
  const RunMore run = [](const PlannedRun&, const std::vector<std::string>& more) {
    if (changes(more, "cell_size")) return failed(with_error(0.001), "out of memory");
    return with_error(changes(more, "band") ? 0.005 : 0.01);
  };
  const Answer found = answer(table, {norm, 0.01}, case_of, run);
  CHECK(found.dominant == "band");
  CHECK(found.error_left.count("grid") == 0);
  CHECK_THAT(found.text, Contains("failed  out of memory"));
}

TEST_CASE("a norm that no run has is refused, and the nearest is told", "[engine][study]") {
  const StudyTable table = study_table({row("line", 0.25, 0.01, 1.0)});
  CHECK_THROWS_WITH(answer(table, {"stress.l2_relativ", 0.01}, case_of, leaving({}, 0.01)),
                    Contains("--tolerance stress.l2_relativ") && Contains("\"stress.l2_relative\""));
  CHECK_THROWS_AS(answer(table, {"energy", 0.01}, case_of, leaving({}, 0.01)), CaseError);
  CHECK_THROWS_WITH(answer(study_table({study_row("line", 0.25, {}, 1.0)}), {norm, 0.01}, case_of, leaving({}, 0.01)),
                    Contains("expected an exact solution or a reference"));
}
