// From a study file to a Study: engine/src/study/study_reader.cpp.

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "output_folder.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/study.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::OutputFolder;
using Json = nlohmann::json;
using Settings = std::vector<std::string>;

namespace {

const Json cell_sizes = {{"key", "grid.cell_size"}, {"values", {0.5, 0.25, 0.125}}};

Json study_with(const std::vector<Json>& sweep) { return {{"case", "case.json"}, {"sweep", sweep}}; }

Json with(Json json, const Json& more) {
  json.update(more);
  return json;
}

/// The study as its file says it; the case beside it is an empty object.
Study read(const Json& json) {
  const OutputFolder folder;
  std::ofstream(folder.path / "case.json") << "{}";
  std::ofstream(folder.path / "plate.json") << json;
  return read_study(folder.path / "plate.json");
}

Settings labels(const Study::Axis& axis) {
  Settings all;
  for (const Study::Choice& choice : axis.choices) all.push_back(choice.label);
  return all;
}

/// Pointer and message of what is wrong.
std::pair<std::string, std::string> fault_of(const Json& json) {
  try {
    static_cast<void>(read(json));
  } catch (const CaseError& error) {
    return {error.pointer(), error.what()};
  }
  return {"", "nothing is wrong"};
}

}  // namespace

TEST_CASE("values of one key are entries with the key set to each", "[engine][study]") {
  const Json axis = {{"key", "material_points.per_cell"}, {"values", {2, "x", Json::array({2, 3}), true}}};
  const Study::Axis read_axis = read(study_with({axis})).axes.at(0);
  CHECK(read_axis.name == "material_points.per_cell");
  CHECK(labels(read_axis) == Settings{"2", "x", "[2,3]", "true"});
  CHECK(read_axis.choices[0].settings == Settings{"material_points.per_cell=2"});
  CHECK(read_axis.choices[1].settings == Settings{"material_points.per_cell=\"x\""});
  CHECK(read_axis.choices[0].number == 2.0);
  CHECK_FALSE(read_axis.choices[1].number);
}

TEST_CASE("keys that change together are one axis, labelled by one of them", "[engine][study]") {
  Json axis = {{"zip", {{"grid.cell_size", {0.5, 0.25}}, {"ghost", {1, 2}}}}};
  const Study::Axis first = read(study_with({axis})).axes.at(0);
  CHECK(first.name == "ghost");  // the first by name
  CHECK(labels(first) == Settings{"1", "2"});
  CHECK(first.choices[1].settings == Settings{"ghost=2", "grid.cell_size=0.25"});
  axis["label"] = "grid.cell_size";
  axis["name"] = "h";
  const Study::Axis other = read(study_with({axis})).axes.at(0);
  CHECK(other.name == "h");
  CHECK(other.choices[1].number == 0.25);
  CHECK(other.choices[1].settings == first.choices[1].settings);
}

TEST_CASE("a named choice sets any keys, or none", "[engine][study]") {
  const Json axis = {{"name", "basis"},
                     {"choices",
                      {{{"name", "bilinear"}, {"set", Json::object()}},
                       {{"name", "quadratic"}, {"set", {{"grid.basis", "bspline"}, {"grid.degree", 2}}}}}}};
  const Study::Axis read_axis = read(study_with({axis})).axes.at(0);
  CHECK(labels(read_axis) == Settings{"bilinear", "quadratic"});
  CHECK(read_axis.choices[0].settings.empty());
  CHECK(read_axis.choices[1].settings == Settings{"grid.basis=\"bspline\"", "grid.degree=2"});
}

TEST_CASE("what a study file leaves out is what a Study starts with", "[engine][study]") {
  const Study study = read(study_with({cell_sizes}));
  const Study start;
  CHECK(study.title == "plate");  // the name of the file
  CHECK(study.base == study.file.parent_path() / "case.json");
  CHECK(study.settings == start.settings);
  CHECK(study.repeat == start.repeat);
  CHECK(study.samples == start.samples);
  CHECK(study.seconds == start.seconds);
  CHECK(study.memory == start.memory);
  CHECK(study.errors == start.errors);
  CHECK_FALSE(study.reference);
  CHECK(study.outside.empty());
}

TEST_CASE("what a study file says is in the Study", "[engine][study]") {
  const Study study = read(with(study_with({cell_sizes}), {{"title", "a title"},
                                                           {"set", {{"ghost", 0.1}}},
                                                           {"repeat", 3},
                                                           {"samples", 0},
                                                           {"budget", {{"seconds", 2.5}, {"memory", 1e9}}},
                                                           {"errors", {"energy"}},
                                                           {"reference", {{"set", {{"grid.cell_size", 0.01}}}}},
                                                           {"outside", {"other.csv"}}}));
  CHECK(study.title == "a title");
  CHECK(study.settings == Settings{"ghost=0.1"});
  CHECK(study.repeat == 3);
  CHECK(study.samples == 0);
  CHECK(study.seconds == 2.5);
  CHECK(study.memory == 1e9);
  CHECK(study.errors == Settings{"energy"});
  CHECK(std::get<Study::OwnRun>(study.reference.value()).settings == Settings{"grid.cell_size=0.01"});
  CHECK(study.outside.at(0) == study.file.parent_path() / "other.csv");
  Json other = study_with({cell_sizes});
  other["reference"] = "richardson";
  CHECK(std::holds_alternative<Study::Richardson>(read(other).reference.value()));
  other["reference"] = "finest";
  CHECK(std::holds_alternative<Study::Finest>(read(other).reference.value()));
}

TEST_CASE("the axis to refine sets the cell size, else is the last one of numbers, unless it is named",
          "[engine][study]") {
  const Json points = {{"key", "material_points.per_cell"}, {"values", {2, 3}}};
  const Json words = {{"key", "grid.basis"}, {"values", {"bilinear", "bspline"}}};
  const Json signs = {{"key", "gravity.1"}, {"values", {-1, 1}}};  // no sizes
  CHECK(read(study_with({points, cell_sizes, with(points, {{"name", "again"}})})).refine == 1);
  CHECK(read(study_with({points, words, with(points, {{"name", "again"}}), signs})).refine == 2);
  CHECK_FALSE(read(study_with({words, signs})).refine);
  CHECK(read(with(study_with({points, cell_sizes}), {{"refine", "material_points.per_cell"}})).refine == 0);
}

TEST_CASE("what is wrong in a study file is told with its place", "[engine][study]") {
  const Json points = {{"key", "material_points.per_cell"}, {"values", {2, 3}}};
  const Json words = {{"key", "grid.basis"}, {"values", {"bilinear", "bspline"}}};
  const auto [json, pointer, said] = GENERATE_COPY(table<Json, std::string, std::string>({
      {study_with({{{"zip", {{"a", {1, 2}}, {"b", {1}}}}}}), "/sweep/0/zip/b", "found 1 values, expected 2"},
      {study_with({{{"zip", {{"ghost", {1}}}}, {"label", "gost"}}}), "/sweep/0/label", "\"ghost\""},
      {study_with({{{"zip", Json::object()}}}), "/sweep/0/zip", "found no key"},
      {study_with({points, points}), "/sweep/1", "a second axis"},
      {study_with({{{"key", "ghost"}, {"values", {1, 2, 1}}}}), "/sweep/0", "found \"1\" twice"},
      {study_with({{{"key", "ghost"}, {"values", {1, 1.0}}}}), "/sweep/0", "found \"1\" twice"},
      {study_with({{{"key", "grid..basis"}, {"values", {1}}}}), "/sweep/0/key", "found \"grid..basis\""},
      {study_with({{{"zip", {{"", {1}}}}}}), "/sweep/0/zip", "found \"\""},
      {with(study_with({points}), {{"set", {{"ghost=1", 1}}}}), "/set", "found \"ghost=1\""},
      {with(study_with({points}), {{"refine", "grid"}}), "/refine", "expected"},
      {with(study_with({words}), {{"refine", "grid.basis"}}), "/refine", "numbers > 0"},
      {with(study_with({points}), {{"reference", "richardson"}}), "/reference", "at least 3 entries"},
      {with(study_with({words}), {{"reference", "richardson"}}), "/reference", "at least 3 entries"},
      {with(study_with({points}), {{"samples", 1}}), "/samples", "found 1"},
      {with(study_with({points}), {{"sweeps", 1}}), "", "unknown key \"sweeps\""},
  }));
  CAPTURE(json);
  CHECK(fault_of(json).first == pointer);
  CHECK_THAT(fault_of(json).second, Contains(said) && Contains("expected"));
}

TEST_CASE("a study has at most 100,000 runs", "[engine][study]") {
  const auto numbers = [](const std::string& key, int count) {
    Json values = Json::array();
    for (int k = 1; k <= count; ++k) values.push_back(k);
    return Json{{"key", key}, {"values", values}};
  };
  CHECK(read(study_with({numbers("a", 1000), numbers("b", 100)})).axes.size() == 2);
  const auto [pointer, said] = fault_of(study_with({numbers("a", 1001), numbers("b", 100)}));
  CHECK(pointer == "/sweep");
  CHECK_THAT(said, Contains("found 1e+05 runs, expected at most 100000"));
}

TEST_CASE("the case of a study must be there and be an object", "[engine][study]") {
  const OutputFolder folder;
  std::ofstream(folder.path / "study.json") << study_with({cell_sizes});
  const auto said = [&] {
    try {
      static_cast<void>(read_study(folder.path / "study.json"));
    } catch (const CaseError& error) {
      return std::string(error.what());
    }
    return std::string("nothing is wrong");
  };
  CHECK_THAT(said(), Contains("case.json: cannot be read") && Contains("expected a case file"));
  std::ofstream(folder.path / "case.json") << "[1]";
  CHECK_THAT(said(), Contains("case.json: found [1]") && Contains("expected a case"));
  std::ofstream(folder.path / "case.json") << "{,}";
  CHECK_THAT(said(), Contains("case.json: no valid JSON: line 1, column 2"));
}
