#include "shoreline/engine/summary.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "output_folder.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;
using test::OutputFolder;

namespace {

Json written(const Summary& summary) {
  const OutputFolder folder;
  write_summary(summary, folder.path);
  CHECK_FALSE(std::filesystem::exists(folder.path / "summary.json.part"));
  return Json::parse(std::ifstream(folder.path / "summary.json"));
}

}  // namespace

TEST_CASE("summary.json has the keys of the contract", "[engine][summary]") {
  Summary summary;
  summary.completed = true;
  summary.effects = {{"material stiffness", 3, 0.5}, {"traction", 2, 0.25}};
  summary.timings = {{"total", 3.0}, {"setup", 1.0}, {"assembly", 2.0}};
  summary.reactions["left/upper"] = Vec3(1, 2, 3);
  summary.loads["ß"] = Vec3(4, 5, 6);

  const Json json = written(summary);
  for (const char* key :
       {"title", "status", "message", "analysis", "basis", "degrees_of_freedom", "material_points", "steps", "threads",
        "version", "effects", "timings", "reactions", "loads", "peak_memory_bytes"})
    CHECK(json.contains(key));
  CHECK(json["status"] == "completed");
  CHECK(json["effects"] == Json({"material stiffness", "traction"}));
  CHECK(json["effect_costs"]["traction"] == Json({{"calls", 2}, {"seconds", 0.25}}));
  CHECK(json["timings"].dump() == R"({"total":3.0,"setup":1.0,"assembly":2.0})");  // in the order given
  CHECK(json["reactions"]["left/upper"] == Json({1.0, 2.0, 3.0}));
  CHECK(json["loads"]["ß"] == Json({4.0, 5.0, 6.0}));
}

TEST_CASE("peak memory grows with what a process has touched", "[engine][summary]") {
  const auto before = written({})["peak_memory_bytes"].get<long long>();
  const std::size_t bytes = 64u << 20;
  const auto more = static_cast<std::size_t>(before) + bytes;  // the peak may lie far above what is in use now
  const std::vector<char> touched(more, 'x');
  CHECK(written({})["peak_memory_bytes"].get<long long>() >= before + static_cast<long long>(bytes));
  CHECK(touched[more / 2] == 'x');
}

TEST_CASE("errors and condition estimate appear only if they were computed", "[engine][summary]") {
  Summary summary;
  CHECK_FALSE(written(summary).contains("errors"));
  CHECK_FALSE(written(summary).contains("condition_estimate"));
  CHECK_FALSE(written(summary).contains("diagnostics"));
  CHECK(written(summary)["status"] == "failed");

  ErrorNorms errors;
  errors.displacement_l2_relative = 1e-3;
  errors.displacement[1] = {.mean_relative = 2e-3, .mean_absolute = 3e-3, .max_absolute = 4e-3};
  errors.stress[2] = {.mean_relative = std::nullopt, .mean_absolute = 5.0, .max_absolute = 6.0};
  errors.boundary_l2_displacement["left"] = 7e-3;
  errors.displacement_l2 = 8e-3;
  errors.stress_l2 = 9.0;
  summary.errors = errors;
  summary.condition_estimate = 1e6;
  const Json json = written(summary);
  CHECK(json["condition_estimate"] == 1e6);
  const Json& u = json["errors"]["displacement"];
  CHECK(u["l2_relative"] == 1e-3);
  CHECK(u["l2"] == 8e-3);
  CHECK(u["mean_relative"] == Json({nullptr, 2e-3}));
  CHECK(u["mean_absolute"] == Json({0.0, 3e-3}));
  CHECK(u["max_absolute"] == Json({0.0, 4e-3}));
  const Json& stress = json["errors"]["stress"];
  CHECK(stress["l2_relative"].is_null());
  CHECK(stress["l2"] == 9.0);
  CHECK(stress["mean_relative"] == Json({nullptr, nullptr, nullptr}));
  CHECK(stress["mean_absolute"] == Json({0.0, 0.0, 5.0}));
  CHECK(json["errors"]["boundary"]["left"].dump() == R"({"l2_displacement":0.007})");
  CHECK_FALSE(json["errors"].contains("over_time"));
}

TEST_CASE("a radius stands beside the other errors of its piece", "[engine][summary]") {
  Summary summary;
  summary.errors.emplace();
  summary.errors->boundary_l2_displacement["inner"] = 8e-3;
  summary.errors->boundary_radius["inner"] = {.mean = 2.5, .exact = 2.0, .mean_relative = 0.25};
  CHECK(written(summary)["errors"]["boundary"] ==
        Json::parse(
            R"({"inner": {"l2_displacement": 0.008, "radius": {"mean": 2.5, "exact": 2.0, "mean_relative": 0.25}}})"));
}

TEST_CASE("the summary of a dynamic run has its steps in time, its balance and its errors over time",
          "[engine][summary]") {
  Summary summary;
  for (const char* key : {"dynamics", "energy", "momentum"}) CHECK_FALSE(written(summary).contains(key));
  summary.analysis = "explicit_dynamics";
  summary.dynamics = Summary::Dynamics{.law = "neo_hookean",
                                       .objective = false,
                                       .mass = "lumped",
                                       .pic = 0.01,
                                       .damping = 0.02,
                                       .end_time = 3.0,
                                       .smallest_step = 4.0,
                                       .largest_step = 5.0,
                                       .critical_step_at_start = 6.0,
                                       .smallest_critical_step = 7.0,
                                       .time_of_smallest = 8.0,
                                       .courant = 0.5,
                                       .dropped_points = 9};
  summary.history = {{.t = 0.0, .kinetic = 1.0, .strain = 2.0, .gravity = 3.0, .momentum = Vec2(4, 5)},
                     {.t = 0.5, .kinetic = 10.0, .strain = 0.0, .gravity = 0.0, .momentum = Vec2(6, 7)},
                     {.t = 0.7, .kinetic = 0.0, .strain = 0.0, .gravity = -2.0, .momentum = Vec2(6, 7)},
                     {.t = 1.0, .kinetic = 2.0, .strain = 1.0, .gravity = 1.0, .momentum = Vec2(8, 9)}};
  summary.errors.emplace();
  summary.errors->over_time = {{"displacement", 1.5, 2.5}, {"velocity", 3.5, 4.5}, {"stress", 5.5, 6.5}};
  const Json json = written(summary);
  CHECK(json["dynamics"] == Json::parse(R"({"law": "neo_hookean", "objective": false, "mass": "lumped", "pic": 0.01,
      "damping": 0.02, "end_time": 3.0, "smallest_step": 4.0, "largest_step": 5.0, "critical_step_at_start": 6.0,
      "smallest_critical_step": 7.0, "time_of_smallest_critical_step": 8.0, "courant": 0.5, "dropped_points": 9})"));
  CHECK(json["energy"] == Json::parse(R"({"start": {"kinetic": 1.0, "strain": 2.0, "gravity": 3.0, "total": 6.0},
      "end": {"kinetic": 2.0, "strain": 1.0, "gravity": 1.0, "total": 4.0}, "largest_total": 10.0,
      "smallest_total": -2.0})"));
  CHECK(json["momentum"] == Json::parse(R"({"start": [4.0, 5.0], "end": [8.0, 9.0]})"));
  CHECK(json["errors"]["over_time"] == Json::parse(R"({"displacement": {"rms": 1.5, "mean_rms": 2.5},
      "velocity": {"rms": 3.5, "mean_rms": 4.5}, "stress": {"rms": 5.5, "mean_rms": 6.5}})"));
  for (const char* key : {"reactions", "loads", "extended_share"}) CHECK(json.contains(key));
}

TEST_CASE("probes and fits of prescribed displacements appear only where there are any", "[engine][summary]") {
  Summary summary;
  CHECK_FALSE(written(summary).contains("probes"));
  CHECK_FALSE(written(summary).contains("displacement_fit"));

  const ProbeState start{.t = 0.0, .position = Vec2(1, 2), .displacement = Vec2(0, 0), .stress = {}};
  ProbeState end{.t = 1.0, .position = Vec2(4, 6), .displacement = Vec2(3, 4), .stress = Stress(5, 6, 7, 8)};
  summary.probes.push_back({"inside", std::nullopt, 9, {start, end}});
  summary.probes.push_back({"there", std::nullopt, 0, {start, end}, false, true});
  end.stress.reset();
  end.velocity = Vec2(9, 10);
  summary.probes.push_back({"tip", 2, 9, {start, end}});
  summary.displacement_fit["edge"] = {.l2 = 1e-3, .mean = 2e-3};
  const Json json = written(summary);
  CHECK(json["displacement_fit"] == Json::parse(R"({"edge": {"l2": 0.001, "mean": 0.002}})"));
  CHECK(json["probes"]["inside"] == Json::parse(R"({"on": "material point", "at": [1.0, 2.0], "position": [4.0, 6.0],
                                                    "displacement": [3.0, 4.0], "stress": [5.0, 6.0, 7.0, 8.0]})"));
  CHECK(json["probes"]["there"]["on"] == "place");
  CHECK(json["probes"]["tip"] == Json::parse(R"({"on": "tracking point", "at": [1.0, 2.0], "position": [4.0, 6.0],
                                                 "displacement": [3.0, 4.0], "velocity": [9.0, 10.0]})"));
}

TEST_CASE("a number that is not finite and a text that is no UTF-8 still give valid JSON", "[engine][summary]") {
  Summary summary;
  summary.message = "caf\xe9";
  summary.timings = {{"total", std::numeric_limits<double>::quiet_NaN()}};
  summary.reactions["left"] = Vec3::Constant(std::numeric_limits<double>::infinity());
  const Json json = written(summary);
  CHECK(json["timings"]["total"].is_null());
  CHECK(json["reactions"]["left"] == Json({nullptr, nullptr, nullptr}));
  CHECK_THAT(json["message"].get<std::string>(), Contains("caf"));
}

TEST_CASE("a summary that cannot be written leaves the old one and says why", "[engine][summary]") {
  const OutputFolder folder;
  CHECK_THROWS_AS(write_summary({}, folder.path / "missing"), OutputError);
  CHECK_THROWS_WITH(write_summary({}, folder.path / "missing"), Contains("summary.json") && Contains("No such file"));

  std::ofstream(folder.path / "summary.json") << "old";
  std::filesystem::create_directory(folder.path / "summary.json.part");
  CHECK_THROWS_WITH(write_summary({}, folder.path), Contains("Is a directory"));
  std::string kept;
  std::ifstream(folder.path / "summary.json") >> kept;
  CHECK(kept == "old");
}

TEST_CASE("the summary of a projection has its errors, and nothing of loads", "[engine][summary]") {
  Summary summary;
  summary.analysis = "projection";
  summary.basis = "bspline";
  summary.degree = 3;
  summary.projection_errors = ProjectionErrors{.l2 = 0.5, .l2_relative = {}, .derivative_l2 = {}};
  Json json = written(summary);
  CHECK(json["degree"] == 3);
  CHECK(json["errors"]["projection"] == Json{{"l2", 0.5}, {"l2_relative", nullptr}});
  for (const char* key : {"reactions", "loads", "extended_share", "displacement_fit"}) CHECK_FALSE(json.contains(key));
  summary.projection_errors->derivative_l2 = {1.5, 2.5};
  json = written(summary);
  CHECK(json["errors"]["projection"]["x_derivative_l2"] == 1.5);
  CHECK(json["errors"]["projection"]["y_derivative_l2"] == 2.5);
  CHECK_FALSE(written(Summary{}).contains("degree"));
}

TEST_CASE("weak spots have their places", "[engine][summary]") {
  Summary summary;
  summary.diagnostics = Diagnostics{.smallest_cut = Diagnostics::Cut{1e-9, 7, Vec2(0.5, 1.5)},
                                    .smallest_pivot = Diagnostics::Pivot{1e-8, Vec2(1.0, 2.0), 1},
                                    .stray_points = 2,
                                    .first_stray = Vec2(3.0, 4.0),
                                    .fewest_points = 1};
  const Json json = written(summary)["diagnostics"];
  CHECK(json["smallest_cut"] == Json({{"fraction", 1e-9}, {"element", 7}, {"centre", {0.5, 1.5}}}));
  CHECK(json["smallest_pivot"] == Json({{"value", 1e-8}, {"control_point", {1.0, 2.0}}, {"component", "y"}}));
  CHECK(json["stray_points"] == Json({{"number", 2}, {"first", {3.0, 4.0}}}));
  CHECK(json["fewest_points_in_element"] == 1);

  summary.diagnostics = Diagnostics{.fewest_points = 4};
  CHECK(written(summary)["diagnostics"] == Json({{"stray_points", {{"number", 0}}}, {"fewest_points_in_element", 4}}));
}
