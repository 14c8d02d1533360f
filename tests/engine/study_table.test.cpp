// The tables of a study and those of other programs, engine/src/study/study_table.hpp and outside_rows.hpp.

#include "study/study_table.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <random>

#include "output_folder.hpp"
#include "shoreline/engine/failures.hpp"
#include "study_rows.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::failed;
using test::OutputFolder;
using test::study_row;
using test::study_table;

namespace {

const std::vector<std::string> hard_words{"plain", "a, b", "she said \"no\"", "two\nlines", "\"", "a\r\nb", ",", ""};

std::vector<OutsideRow> read_back(const std::string& text) {
  const OutputFolder folder;
  const std::filesystem::path file = folder.path / "rows.csv";
  std::ofstream(file, std::ios::binary) << text;
  return read_outside_rows(file);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text)
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  return lines;
}

}  // namespace

TEST_CASE("the median has as many times below it as above it", "[engine][study]") {
  std::mt19937 draw(3);
  for (const int count : {1, 2, 3, 4, 7, 10}) {
    std::vector<double> seconds;
    for (int k = 0; k < count; ++k) seconds.push_back(std::uniform_real_distribution<double>(0.1, 9.0)(draw));
    const Spread spread = spread_of(seconds);
    CHECK(std::ranges::count_if(seconds, [&](double s) { return s < spread.median; }) ==
          std::ranges::count_if(seconds, [&](double s) { return s > spread.median; }));
    CHECK(spread.least == *std::ranges::min_element(seconds));
    CHECK(spread.greatest == *std::ranges::max_element(seconds));
  }
  CHECK(spread_of({4.0, 1.0}).median == 2.5);
}

TEST_CASE("errors C h^p have the rate p, over sizes that shrink and numbers that grow", "[engine][study]") {
  const double order = GENERATE(0.5, 1.0, 2.0, 4.0);
  const bool counts = GENERATE(false, true);
  std::vector<StudyRow> rows;
  for (const double h : {0.5, 0.25, 0.1}) {
    rows.push_back(study_row("line", h, {{"error", 7.0 * std::pow(h, order)}}, 1.0));
    if (counts) rows.back().plan.refinement = 1.0 / h;
  }
  add_rates(rows);
  CHECK(rows[0].rates.empty());
  for (const std::size_t k : {1U, 2U}) CHECK(rows[k].rates.at("error") == Approx(order).epsilon(1e-13));
}

TEST_CASE("a rate takes two errors beside each other on one line", "[engine][study]") {
  const auto rates = [](std::vector<StudyRow> rows) {
    add_rates(rows);
    return rows.back().rates.size();
  };
  const StudyRow coarse = study_row("line", 0.5, {{"error", 0.1}}, 1.0);
  const StudyRow fine = study_row("line", 0.25, {{"error", 0.01}}, 1.0);
  CHECK(rates({coarse, fine}) == 1);
  CHECK(rates({study_row("another", 0.5, {{"error", 0.1}}, 1.0), fine}) == 0);
  CHECK(rates({study_row("line", 0.5, {{"another", 0.1}}, 1.0), fine}) == 0);
  CHECK(rates({study_row("line", 0.5, {{"error", 0.0}}, 1.0), fine}) == 0);
  CHECK(rates({coarse, study_row("line", 0.25, {{"error", 0.0}}, 1.0)}) == 0);
  CHECK(rates({failed(coarse, "crashed"), fine}) == 0);
  StudyRow without = coarse;
  without.plan.refinement.reset();
  CHECK(rates({without, fine}) == 0);
}

TEST_CASE("any study.csv is read as rows of another program, whatever its words hold", "[engine][study]") {
  StudyTable table = study_table({});
  for (const std::string& word : hard_words) {
    table.rows.push_back(study_row(word, 0.1, {{"error, of " + word, 1.0 / 3.0}}, 0.123456));
    table.rows.push_back(failed(study_row(word, 0.05, {}, 1.0), word));
  }
  const std::vector<OutsideRow> rows = read_back(csv_of(table));
  REQUIRE(rows.size() == hard_words.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    CAPTURE(hard_words[k]);
    CHECK(rows[k].line == hard_words[k]);
    CHECK(rows[k].refinement == 0.1);
    CHECK(rows[k].seconds == 0.123456);
    CHECK(rows[k].unknowns == 800.0);
    CHECK(rows[k].points == 100.0);
    CHECK(rows[k].norms.at("error, of " + hard_words[k]) == Approx(1.0 / 3.0).epsilon(1e-10));
  }
}

TEST_CASE("a table may end its lines like any system, leave some empty and say more", "[engine][study]") {
  for (const std::string& end : {std::string("\n"), std::string("\r\n")})
    for (const std::string& last : {std::string(), end, end + end}) {
      const auto rows = read_back("seconds,remark,line,error" + end + end + "2.5,a word,other,1e-3" + last);
      REQUIRE(rows.size() == 1);
      CHECK(rows[0].line == "other");
      CHECK(rows[0].seconds == 2.5);
      CHECK(rows[0].norms == std::map<std::string, double>{{"error", 1e-3}});
      CHECK_FALSE(rows[0].refinement);
    }
}

TEST_CASE("a table of another program that is wrong is refused with file and row", "[engine][study]") {
  CHECK_THROWS_WITH(read_back(""), Contains("rows.csv: ") && Contains("is empty"));
  CHECK_THROWS_WITH(read_back("line,points\na,1\n"), Contains("no column \"seconds\" among line, points"));
  CHECK_THROWS_WITH(read_back("method,seconds\na,1\n"), Contains("no column \"line\""));
  CHECK_THROWS_WITH(read_back("line,seconds\na,1\nb\n"), Contains("row 3: found 1 cells, expected 2"));
  CHECK_THROWS_WITH(read_back("line,seconds\n\"a,1\n"), Contains("row 2: found 1 cells, expected 2"));
  for (const std::string seconds : {"fast", "", "0", "-1", "nan", "inf", "1 s"}) {
    CAPTURE(seconds);
    CHECK_THROWS_AS(read_back("line,seconds\na," + seconds + "\n"), CaseError);
  }
}

TEST_CASE("every line of study.md has as many cells as its head, whatever its words hold", "[engine][study]") {
  StudyTable table = study_table({});
  for (const std::string& word : {std::string("plain"), std::string("a|b"), std::string("two\nlines")}) {
    table.rows.push_back(study_row(word, 0.5, {{"error", 0.1}}, 1.0));
    table.rows.push_back(study_row(word, 0.25, {{"error", 0.01}}, 4.0));
    table.rows.push_back(failed(study_row(word, 0.125, {}, 1.0), "crashed"));
  }
  table.errors = {"error", "missing"};
  add_rates(table.rows);
  const std::vector<std::string> lines = lines_of(markdown_of(table));
  const auto bars = [](const std::string& line) {
    std::ptrdiff_t count = 0;
    for (std::size_t k = 0; k < line.size(); ++k) count += line[k] == '|' && (k == 0 || line[k - 1] != '\\');
    return count;
  };
  REQUIRE(lines.size() >= 2 + table.rows.size());
  for (std::size_t k = 0; k < 2 + table.rows.size(); ++k) {
    CAPTURE(lines[k]);
    CHECK(bars(lines[k]) == 1 + 2 + 2 + 4 + 2);
  }
  CHECK_THAT(lines[3], Contains("| 1.00e-02 | 3.32 |"));  // log2 10
  CHECK_THAT(lines[4], Contains("failed"));
}

TEST_CASE("study.json has every row in order, with labels that are numbers as numbers", "[engine][study]") {
  StudyTable table =
      study_table({study_row("fast", 0.5, {{"error", 0.1}}, 1.0), study_row("fast", 0.25, {{"error", 0.01}}, 4.0),
                   failed(study_row("slow", 0.5, {}, 1.0), "crashed")});
  table.rows[1].result.seconds = {3.0, 9.0, 4.0};
  table.outside = {{.line = "other", .refinement = {}, .points = 1, .unknowns = 2, .seconds = 3, .norms = {}}};
  add_rates(table.rows);
  const Json json = json_of(table);
  CHECK(json["refine"] == "grid.cell_size");
  CHECK(json["axes"][1]["values"] == Json({0.5, 0.25}));
  REQUIRE(json["rows"].size() == 3);
  CHECK(json["rows"][1]["labels"] == Json({{"basis", "fast"}, {"grid.cell_size", 0.25}}));
  CHECK(json["rows"][1]["seconds"] == Json({{"median", 4.0}, {"least", 3.0}, {"greatest", 9.0}}));
  CHECK(json["rows"][1]["rates"]["error"] == table.rows[1].rates.at("error"));
  CHECK(json["rows"][2]["status"] == "failed");
  CHECK(json["rows"][2]["reason"] == "crashed");
  CHECK_FALSE(json["rows"][2].contains("errors"));
  CHECK(json["outside"][0]["refinement"].is_null());
}
