// The runs of a study and the cases that they compute: engine/src/study/planned_run.hpp and refinements.hpp.

#include <omp.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "case_file/overrides.hpp"
#include "shoreline/engine/case_reader.hpp"
#include "study/planned_run.hpp"
#include "study/refinements.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Settings = std::vector<std::string>;

namespace {

Study::Axis axis(const std::string& name, const std::vector<std::string>& labels, bool numbers) {
  Study::Axis made{name, {}};
  for (const std::string& label : labels)
    made.choices.push_back({label, numbers ? std::optional(std::stod(label)) : std::nullopt, {name + "=" + label}});
  return made;
}

Study study_of(std::vector<Study::Axis> axes, std::optional<std::size_t> refine) {
  Study study;
  study.title = "the title";
  study.base = "folder/plate.json";
  study.settings = {"ghost=0.1"};
  study.axes = std::move(axes);
  study.refine = refine;
  return study;
}

/// A body with an arc, a circle and bands on a grid, in two load steps.
Json half_disc() {
  return {{"title", "half a disc"},
          {"analysis", {{"type", "quasi_static"}, {"plane", "strain"}, {"load_steps", 2}}},
          {"material", {{"type", "linear_elastic"}, {"youngs_modulus", 1e6}, {"poissons_ratio", 0.3}}},
          {"grid", {{"lower", {-1.5, -0.5}}, {"upper", {1.5, 1.5}}, {"cell_size", {0.25, 0.125}}}},
          {"boundaries",
           {{{"name", "base"},
             {"points", {{-1, 0}, {1, 0}}},
             {"condition", {{"type", "fixed"}, {"method", "implicit_boundary"}, {"band", 0.02}}}},
            {{"name", "rim"}, {"arc", {{"centre", {0, 0}}, {"radius", 1}, {"from", 0}, {"to", 180}, {"points", 9}}}},
            {{"name", "hole"}, {"circle", {{"centre", {0, 0.5}}, {"radius", 0.2}, {"points", 12}, {"hole", true}}}}}},
          {"material_points", {{"per_cell", {2, 3}}}}};
}

Json changed(Json json, const Settings& settings) {
  for (const std::string& setting : settings) override_value(json, setting);
  return json;
}

/// Where two cases differ.
std::set<std::string> differences(const Json& one, const Json& other) {
  std::set<std::string> places;
  for (const Json& change : Json::diff(one, other)) places.insert(change["path"]);
  return places;
}

std::map<std::string, Settings> parts_of(const Json& json) {
  std::map<std::string, Settings> parts;
  for (const Refinement& refinement : refinements_of(json)) parts[refinement.part] = refinement.settings;
  return parts;
}

Json prepared(const Study& study, const Json& base, std::optional<int> threads = {}, const Settings& settings = {}) {
  const PreparedCase made = prepared_case(study, base, threads, settings);
  CHECK(made.fault.empty());
  return made.json;
}

}  // namespace

TEST_CASE("every entry of an axis meets every entry of the others once, the refined axis fastest", "[engine][study]") {
  const Study study = study_of({axis("ghost", {"1", "2", "3"}, true), axis("grid.cell_size", {"0.5", "0.25"}, true),
                                axis("grid.basis", {"linear", "bspline"}, false)},
                               1);
  const std::vector<PlannedRun> runs = planned_runs(study);
  REQUIRE(runs.size() == 3 * 2 * 2);
  std::set<std::vector<std::string>> combinations;
  for (const PlannedRun& run : runs) combinations.insert(run.labels);
  CHECK(combinations.size() == runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    CAPTURE(k);
    CHECK(runs[k].refinement == (k % 2 == 0 ? 0.5 : 0.25));
    CHECK(runs[k].line == runs[k - k % 2].line);
    CHECK(runs[k].line == runs[k].labels[0] + ", " + runs[k].labels[2]);
    const std::set<std::string> settings(runs[k].settings.begin(), runs[k].settings.end());
    CHECK(runs[k].settings.front() == "ghost=0.1");  // the axes change what the study sets for all
    CHECK(settings == std::set<std::string>{"ghost=0.1", "ghost=" + runs[k].labels[0],
                                            "grid.cell_size=" + runs[k].labels[1], "grid.basis=" + runs[k].labels[2]});
  }
}

TEST_CASE("a study of its refined axis alone has one line, named like the study", "[engine][study]") {
  for (const PlannedRun& run : planned_runs(study_of({axis("grid.cell_size", {"0.5", "0.25"}, true)}, 0)))
    CHECK(run.line == "the title");
  const auto unrefined = planned_runs(study_of({axis("grid.basis", {"linear", "bspline"}, false)}, std::nullopt));
  CHECK(unrefined[1].line == "bspline");
  CHECK_FALSE(unrefined[1].refinement);
}

TEST_CASE("a study changes in a case what makes runs fair, and nothing else", "[engine][study]") {
  const Study study = study_of({}, std::nullopt);
  Json base = half_disc();
  const std::set<std::string> always{"/solver", "/output"};
  std::set<std::string> compared = always;
  compared.insert("/diagnostics");
  CHECK(differences(base, prepared(study, base, 3)) == compared);  // compared by its energy
  CHECK(prepared(study, base, 3)["solver"]["threads"] == 3);
  CHECK(prepared(study, base, 3)["diagnostics"]["strain_energy"] == true);
  CHECK(prepared(study, base, 3)["output"]["pictures"] == false);

  base["exact"] = {{"type", "plate_with_hole"}, {"radius", 1}, {"far_field_stress", 1}};
  std::set<std::string> measured = always;
  measured.insert("/samples");
  CHECK(differences(base, prepared(study, base)) == measured);
  CHECK(prepared(study, base)["samples"] == Study{}.samples);
  Study at_points = study;
  at_points.samples = 0;
  CHECK(differences(base, prepared(at_points, base)) == always);
  Study with_reference = study;
  with_reference.reference = Study::Finest{};
  CHECK(prepared(with_reference, base)["diagnostics"]["strain_energy"] == true);
}

TEST_CASE("what a case or a study says itself is not overruled", "[engine][study]") {
  const Study study = study_of({}, std::nullopt);
  Json base = half_disc();
  base["exact"] = {{"type", "plate_with_hole"}, {"radius", 1}, {"far_field_stress", 1}};
  base["samples"] = 77;
  base["solver"]["threads"] = 5;
  CHECK(prepared(study, base)["samples"] == 77);
  CHECK(prepared(study, base)["solver"]["threads"] == 5);
  CHECK(prepared(study, base, 2)["solver"]["threads"] == 2);  // the command line says otherwise
  CHECK(prepared(study, base, 0)["solver"]["threads"] == omp_get_num_procs());
  CHECK(prepared(study, base, {}, {"output.every=1"})["output"]["every"] == 1);
  CHECK(prepared(study, base, {}, {"samples=30", "samples=40"})["samples"] == 40);
  base["solver"]["threads"] = 0;
  CHECK(prepared(study, base)["solver"]["threads"] == omp_get_num_procs());
}

TEST_CASE("an analysis gets no key that it does not know, also where a run changes it", "[engine][study]") {
  const Study study = study_of({}, std::nullopt);
  Json projection = half_disc();
  projection["analysis"] = {{"type", "projection"}, {"value", "x"}};
  CHECK(differences(projection, prepared(study, projection)) == std::set<std::string>{"/solver", "/output"});
  CHECK_FALSE(prepared(study, projection)["output"].contains("every"));
  CHECK_FALSE(
      prepared(study, half_disc(), {}, {"analysis={\"type\": \"projection\", \"value\": \"x\"}"})["output"].contains(
          "every"));
  Json dynamics = half_disc();
  dynamics["analysis"] = {{"type", "explicit_dynamics"}, {"end_time", 1}};
  dynamics["exact"] = {{"type", "self_weight_column"}, {"height", 1}};
  CHECK(differences(dynamics, prepared(study, dynamics)) == std::set<std::string>{"/solver", "/output"});
}

TEST_CASE("a mesh is found from anywhere, and a title is that of the file", "[engine][study]") {
  const Study study = study_of({}, std::nullopt);
  Json base = half_disc();
  base["grid"] = {{"mesh", "square.msh"}};
  base.erase("title");
  const std::filesystem::path mesh = prepared(study, base)["grid"]["mesh"].get<std::string>();
  CHECK(mesh == std::filesystem::absolute("folder/square.msh"));
  CHECK(prepared(study, base)["title"] == "plate");
}

TEST_CASE("a change that a case cannot take is a fault of the run, and an odd case is left to the run",
          "[engine][study]") {
  const Study study = study_of({}, std::nullopt);
  CHECK_THAT(prepared_case(study, half_disc(), {}, {"boundaries.rin.points=3"}).fault, Contains("nearest: \"rim\""));
  CHECK_THAT(prepared_case(study, half_disc(), {}, {"title.length=3"}).fault, Contains("half a disc"));
  for (const std::string key : {"analysis", "grid", "solver", "diagnostics", "boundaries", "material_points", "exact"})
    for (const Json& odd : {Json("word"), Json(7), Json::array(), Json::array({1, 2})}) {
      Json base = half_disc();
      base["exact"] = {{"type", "plate_with_hole"}, {"radius", 1}, {"far_field_stress", 1}};
      base[key] = odd;
      CAPTURE(key, odd);
      const PreparedCase made = prepared_case(study, base, 2, {"ghost=0.2"});
      CHECK(made.json["ghost"] == 0.2);
      CHECK_THROWS_AS(parse_case(made.json.dump(), "case", {}), CaseError);
    }
}

TEST_CASE("each part of a discretisation is refined alone, and the case stays right", "[engine][study]") {
  const Json json = half_disc();
  const auto parts = parts_of(json);
  CHECK(parts.size() == 5);
  const auto places = [&](const std::string& part) { return differences(json, changed(json, parts.at(part))); };
  CHECK(places("grid") == std::set<std::string>{"/grid/cell_size/0", "/grid/cell_size/1"});
  CHECK(places("points") == std::set<std::string>{"/material_points/per_cell/0", "/material_points/per_cell/1"});
  CHECK(places("boundary points") == std::set<std::string>{"/boundaries/1/arc/points", "/boundaries/2/circle/points"});
  CHECK(places("band") == std::set<std::string>{"/boundaries/0/condition/band"});
  CHECK(places("time step") == std::set<std::string>{"/analysis/load_steps"});

  const Json finer = changed(json, parts.at("boundary points"));
  CHECK(finer["boundaries"][1]["arc"]["points"].get<int>() - 1 == 2 * (9 - 1));  // spans of an open curve
  CHECK(finer["boundaries"][2]["circle"]["points"] == 2 * 12);                   // and of a closed one
  CHECK(changed(json, parts.at("grid"))["grid"]["cell_size"] == Json::array({0.125, 0.0625}));
  CHECK(changed(json, parts.at("points"))["material_points"]["per_cell"] == Json::array({4, 6}));
  CHECK(changed(json, parts.at("band"))["boundaries"][0]["condition"]["band"].get<double>() == Approx(0.002));
  CHECK(changed(json, parts.at("time step"))["analysis"]["load_steps"] == 4);
  for (const auto& [part, settings] : parts) CHECK_NOTHROW(parse_case(changed(json, settings).dump(), "case", {}));
}

TEST_CASE("what a case leaves to its defaults is refined from there", "[engine][study]") {
  Json json = half_disc();
  json["analysis"].erase("load_steps");
  json["boundaries"][0]["condition"] = {{"type", "displacement"}, {"value", {0, 0}}};
  const auto parts = parts_of(json);
  const auto steps_of = [](const Json& one) {
    return std::get<QuasiStatic>(parse_case(one.dump(), "case", {}).analysis).load_steps;
  };
  CHECK(steps_of(changed(json, parts.at("time step"))) == 2 * steps_of(json));
  const auto band_of = [](const Json& one) {
    const Case problem = parse_case(one.dump(), "case", {});
    return std::get<Case::Displacement>(problem.boundaries[0].condition).support.band;
  };
  CHECK(band_of(changed(json, parts.at("band"))) == Approx(0.1 * band_of(json)));
}

TEST_CASE("parts that a case has not are not refined", "[engine][study]") {
  Json json = half_disc();
  json["boundaries"] = {
      {{"name", "base"}, {"points", {{0, 0}, {1, 0}}}, {"condition", {{"type", "roller"}, {"method", "grid"}}}}};
  json["material_points"] = {{"points", {{0, 0.5}}}, {"volumes", {1}}};
  const auto parts = parts_of(json);
  CHECK(parts.count("points") == 0);
  CHECK(parts.count("boundary points") == 0);
  CHECK(parts.count("band") == 0);
  CHECK(parts.count("grid") == 1);
}

TEST_CASE("random points are four times as many, so half as far apart", "[engine][study]") {
  Json json = half_disc();
  json["material_points"] = {{"fill", "random"}, {"per_cell", 3}};
  CHECK(parts_of(json).at("points") == Settings{"material_points.per_cell=12"});
}

TEST_CASE("a shifted grid lies (0.37, 0.21) cells from where it was, in either direction's own cells",
          "[engine][study]") {
  Json json = half_disc();
  const auto moved = [&] {
    const Json lower = changed(json, shifted_grid(json))["grid"]["lower"];
    return Vec2(lower[0].get<double>() + 1.5, lower[1].get<double>() + 0.5);
  };
  CHECK((moved() - Vec2(-0.37 * 0.25, -0.21 * 0.125)).norm() < 1e-15);
  json["grid"]["cell_size"] = 0.5;
  CHECK((moved() - Vec2(-0.37 * 0.5, -0.21 * 0.5)).norm() < 1e-15);
  CHECK(differences(json, changed(json, shifted_grid(json))) ==
        std::set<std::string>{"/grid/lower/0", "/grid/lower/1"});
  json["grid"] = {{"mesh", "square.msh"}};
  CHECK(shifted_grid(json).empty());
}
