#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "output_folder.hpp"
#include "shoreline/engine/pictures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::OutputFolder;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::array<const char*, 4> pictures{"error_time.png", "error_refinement.png", "phases.png", "memory.png"};

/// A run on cells of size h whose error is of the given order.
Json run(const std::string& basis, double order, double h) {
  const double unknowns = 8.0 / h / h, seconds = 1e-5 * unknowns;
  return {{"line", basis},
          {"labels", {{"basis", basis}, {"grid.cell_size", h}}},
          {"refinement", h},
          {"status", "completed"},
          {"reason", ""},
          {"points", 2.0 * unknowns},
          {"unknowns", unknowns},
          {"steps", 1},
          {"threads", 2},
          {"errors", {{"stress.l2_relative", std::pow(h, order)}, {"probe.tip $.displacement", 0.0}}},
          {"rates", {{"stress.l2_relative", order}}},
          {"seconds", {{"median", seconds}, {"least", 0.9 * seconds}, {"greatest", 1.2 * seconds}}},
          {"phases", {{"setup", 0.3 * seconds}, {"solve", 0.695 * seconds}, {"output", 0.005 * seconds}}},
          {"peak_memory_bytes", 1e7 + 1e3 * unknowns}};
}

Json failed(Json row, const std::string& reason) {
  row["status"] = "failed";
  row["reason"] = reason;
  for (const char* key : {"rates", "phases", "peak_memory_bytes"}) row.erase(key);
  row["errors"] = row["seconds"] = nullptr;
  return row;
}

Json study(const Json& rows) {
  return {{"title", "100 % of {it} for $1_^, or $2"},
          {"program", "shoreline"},
          {"machine", "a machine, 2 cores"},
          {"device", "errors at 31,000 sample points"},
          {"refine", "grid.cell_size"},
          {"axes",
           {{{"name", "basis"}, {"values", {"bilinear $", "bspline 2"}}},
            {{"name", "grid.cell_size"}, {"values", {0.5, 0.25, 0.125}}}}},
          {"errors", {"stress.l2_relative", "probe.tip $.displacement"}},
          {"rows", rows},
          {"outside", Json::array()}};
}

Json both_bases() {
  Json rows = Json::array();
  for (const double h : {0.5, 0.25, 0.125}) {
    rows.push_back(run("bilinear $", 1.0, h));
    rows.push_back(run("bspline 2", 2.0, h));
  }
  return rows;
}

std::string drawn(const std::filesystem::path& folder, const Json& content) {
  std::ofstream(folder / "study.json") << content;
  return make_study_pictures(folder).value_or("");
}

bool is_picture(const std::filesystem::path& file) {
  std::string start(8, ' ');
  std::ifstream(file, std::ios::binary).read(start.data(), 8);
  return start == "\x89PNG\r\n\x1a\n" && std::filesystem::file_size(file) > 10000;
}

/// Width and height of a PNG picture, from its header.
std::array<int, 2> size_of(const std::filesystem::path& file) {
  std::array<unsigned char, 24> head{};
  std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(head.data()), head.size());
  const auto number = [&](std::size_t k) {
    return (head[k] << 24) | (head[k + 1] << 16) | (head[k + 2] << 8) | head[k + 3];
  };
  return {number(16), number(20)};
}

}  // namespace

TEST_CASE("a study has four pictures, be it of one run or of lines with gaps, other programs and a tolerance",
          "[engine][pictures][study]") {
  const OutputFolder folder;
  Json with_all = study(both_bases());
  with_all["rows"][4] = failed(with_all["rows"][4], "out of memory");
  with_all["outside"].push_back({{"line", "a $ program"},
                                 {"points", 1},
                                 {"unknowns", 1},
                                 {"refinement", nullptr},
                                 {"seconds", {{"median", 0.1}}},
                                 {"errors", {{"stress.l2_relative", 0.1}}}});
  with_all["tolerance"] = {{"norm", "stress.l2_relative"}, {"value", 0.07}, {"chosen", 3}};
  for (const Json& content : {with_all, study(Json::array({run("bspline 2", 2.0, 0.25)}))}) {
    for (const char* name : pictures) std::filesystem::remove(folder.path / name);
    REQUIRE(drawn(folder.path, content) == "");
    for (const char* name : pictures) {
      CAPTURE(name);
      CHECK(is_picture(folder.path / name));
    }
  }
}

TEST_CASE("a norm whose errors are all zero or missing has no panel", "[engine][pictures][study]") {
  const OutputFolder folder;
  REQUIRE(drawn(folder.path, study(both_bases())) == "");
  const std::array<int, 2> one = size_of(folder.path / "error_time.png");
  Json rows = both_bases();
  for (std::size_t k = 0; k < rows.size(); k += 2) rows[k]["errors"]["probe.tip $.displacement"] = 1e-3;
  Json four = study(rows);
  four["errors"] = {"stress.l2_relative", "probe.tip $.displacement", "stress.l2_relative", "energy"};
  REQUIRE(drawn(folder.path, four) == "");
  const std::array<int, 2> three = size_of(folder.path / "error_time.png");
  CHECK(three[0] == one[0]);
  CHECK(three[1] > one[1] + 100);  // two rows of panels instead of one, which is higher
}

TEST_CASE("errors over a refinement that is no number are not drawn, nor is what a former study left",
          "[engine][pictures][study]") {
  const OutputFolder folder;
  REQUIRE(drawn(folder.path, study(both_bases())) == "");
  Json rows = both_bases();
  for (Json& row : rows) row["refinement"] = nullptr;
  REQUIRE(drawn(folder.path, study(rows)) == "");
  CHECK_FALSE(std::filesystem::exists(folder.path / "error_refinement.png"));
  for (Json& row : rows) row["errors"] = Json::object();
  REQUIRE(drawn(folder.path, study(rows)) == "");
  CHECK_FALSE(std::filesystem::exists(folder.path / "error_time.png"));
  CHECK(is_picture(folder.path / "memory.png"));
}

TEST_CASE("bars are one a line, and no more than thirty", "[engine][pictures][study]") {
  const OutputFolder folder;
  const auto height = [&](int lines) {
    Json rows = Json::array();
    for (int k = 0; k < lines; ++k)
      for (const double h : {0.5, 0.25}) rows.push_back(run("basis " + std::to_string(k), 1.0 + 0.05 * k, h));
    REQUIRE(drawn(folder.path, study(rows)) == "");
    return size_of(folder.path / "phases.png")[1];
  };
  const int of_30 = height(30);
  CHECK(of_30 - height(10) > 400);
  CHECK(height(33) == of_30);
}

TEST_CASE("a study without a completed run gives the reason of its first", "[engine][pictures][study]") {
  const OutputFolder folder;
  const Json rows = {failed(run("bspline 2", 2.0, 0.5), "material.nu = 0.5:\n must be below 0.5"),
                     failed(run("bspline 2", 2.0, 0.25), "another")};
  CHECK_THAT(drawn(folder.path, study(rows)),
             Contains("no picture") && Contains("all 2 runs") && Contains("material.nu = 0.5: must be below 0.5"));
  for (const char* name : pictures) CHECK_FALSE(std::filesystem::exists(folder.path / name));
  CHECK_THAT(drawn(folder.path, study(Json::array())), Contains("no run"));
  std::filesystem::remove(folder.path / "study.json");
  CHECK_THAT(make_study_pictures(folder.path).value(), Contains("study.json"));
}
