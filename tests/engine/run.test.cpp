#include "shoreline/engine/run.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../scenes.hpp"
#include "output_folder.hpp"
#include "shoreline/boundary/short_forms.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/quasi_static.hpp"
#include "shoreline/engine/report.hpp"
#include "shoreline/engine/strain_energy.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;
using Json = nlohmann::json;
using test::OutputFolder;

namespace {

Case small_square(int steps = 1) {
  Case problem = test::compression_case({.angle = 0.2, .cells = 4, .steps = steps});
  problem.title = "Small square";
  problem.threads = 1;
  problem.output.pictures = false;
  return problem;
}

/// Names of the steps in results.h5.
std::vector<std::string> saved_steps(const std::filesystem::path& folder) {
  const hid_t file = H5Fopen((folder / "results.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t group = H5Gopen(file, "steps", H5P_DEFAULT);
  std::vector<std::string> names;
  const auto note = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    return 0;
  };
  H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, note, &names);
  H5Gclose(group);
  H5Fclose(file);
  return names;
}

Json summary_in(const std::filesystem::path& folder) { return Json::parse(std::ifstream(folder / "summary.json")); }

}  // namespace

TEST_CASE("a run leaves its summary and results, and returns the summary", "[engine][run]") {
  const OutputFolder folder;
  const Case problem = small_square(3);
  const Summary summary = run(problem, {.output = folder.path / "deep" / "out", .quiet = true});
  CHECK(summary.completed);
  CHECK(summary.steps == 3);
  CHECK(summary.material_points == build_scene(problem).points.size());
  CHECK(summary.counters.at("factorisations") == 3);
  CHECK_FALSE(summary.errors);
  CHECK(std::filesystem::file_size(folder.path / "deep" / "out" / "results.h5") > 0);
  CHECK(std::filesystem::file_size(folder.path / "deep" / "out" / "results.xdmf") > 0);

  const Json json = summary_in(folder.path / "deep" / "out");
  CHECK(json["status"] == "completed");
  CHECK(json["title"] == "Small square");
  CHECK(json["steps"] == 3);
  CHECK(json["degrees_of_freedom"] == summary.degrees_of_freedom);
  CHECK(json["loads"].contains("top"));
  CHECK(json["reactions"].size() == 3);

  const double total = json["timings"]["total"];
  double phases = -total;
  for (const auto& seconds : json["timings"]) phases += seconds.get<double>();
  CHECK(phases > 0.0);
  CHECK(phases <= total);
}

TEST_CASE("errors of a run are those of its exact solution", "[engine][run]") {
  const OutputFolder folder;
  test::CompressionSquare square{.cells = 4, .method = EssentialMethod::grid, .load = 1.0, .poissons_ratio = 0.0};
  Case problem = test::compression_case(square);
  problem.threads = 1;
  problem.output.pictures = false;
  problem.exact = Case::ExactExpressions{{Expression("0"), Expression("-t*1e-6*(Y+0.05)")},
                                         {Expression("0"), Expression("-t"), Expression("0")}};
  const Summary summary = run(problem, {.output = folder.path, .quiet = true});
  REQUIRE(summary.errors);
  CHECK(summary.errors->displacement_l2_relative.value() < 1e-12);
  CHECK(summary.errors->stress_l2_relative.value() < 1e-9);
  CHECK(summary.errors->boundary_l2_displacement.at("bottom") < 1e-12);
  CHECK(summary.errors->boundary_l2_displacement.size() == 3);

  std::get<Case::ExactExpressions>(*problem.exact).displacement[1] =
      Expression("0.001-t*1e-6*(Y+0.05)");  // off along the rollers at the sides
  const Summary off = run(problem, {.output = folder.path, .quiet = true});
  CHECK(off.errors->boundary_l2_displacement.at("right") < 1e-12);
  CHECK_THAT(off.errors->boundary_l2_displacement.at("bottom"), WithinRel(0.001 * std::sqrt(0.1), 1e-6));
}

TEST_CASE("errors of a run are measured at sample points where a case asks for them", "[engine][run]") {
  const OutputFolder folder;
  Case problem = small_square(2);
  problem.exact = Case::ExactExpressions{{Expression("0"), Expression("-t*1e-3*(Y+0.05)")},
                                         {Expression("0"), Expression("-t"), Expression("0")}};
  const Summary own = run(problem, {.output = folder.path, .quiet = true});
  const Json at_points = summary_in(folder.path)["errors"];
  CHECK(at_points["measured_at"] == "material points");
  CHECK(at_points["points"] == own.material_points);
  CHECK_FALSE(summary_in(folder.path).contains("strain_energy"));

  problem.samples = 12;
  problem.strain_energy = true;
  const Summary sampled = run(problem, {.output = folder.path, .quiet = true});
  const Json at_samples = summary_in(folder.path)["errors"];
  CHECK(at_samples["measured_at"] == "sample points");
  CHECK(at_samples["points"] == build_scene(problem).samples.value().size());
  CHECK(at_samples["displacement"] != at_points["displacement"]);
  CHECK(at_samples["boundary"] == at_points["boundary"]);
  CHECK(sampled.reactions == own.reactions);

  Scene scene = build_scene(problem);
  RunRecord record;
  run_load_steps(scene, {}, record);
  const ErrorNorms expected = error_norms(*scene.samples, *scene.exact, 1.0);
  CHECK(sampled.errors.value().stress_l2 == expected.stress_l2);
  CHECK(summary_in(folder.path)["strain_energy"] == strain_energy(scene.points));
}

TEST_CASE("the radii of a thick cylinder are measured on its arcs alone", "[engine][run]") {
  const OutputFolder folder;
  const Essential roller{.normal_only = true};
  Case problem = small_square();
  problem.grid = {.lower = Vec2(-0.3, -0.3), .upper = Vec2(2.4, 2.4), .cell_size = Vec2(0.125, 0.125)};
  problem.boundaries = {{line({1.0, 0.0}, {2.0, 0.0}, 2), roller},
                        {arc(Vec2::Zero(), 2.0, 0.0, 90.0, 17), Case::Free{}},
                        {line({0.0, 2.0}, {0.0, 1.0}, 2), roller},
                        {arc(Vec2::Zero(), 1.0, 90.0, 0.0, 17), Case::Pressure{Quantity(100.0)}}};
  const std::array<const char*, 4> names{"bottom", "outer", "left", "inner"};
  for (std::size_t k = 0; k < 4; ++k) problem.boundaries[k].piece.name = names[k];
  problem.material_points = LatticeFill{{3, 3}, VolumeRule::clipped};
  problem.exact = ThickCylinder{.inner_radius = 1.0, .outer_radius = 2.0, .pressure = 100.0};
  const Summary summary = run(problem, {.output = folder.path, .quiet = true});
  const auto& radii = summary.errors.value().boundary_radius;
  REQUIRE(radii.size() == 2);
  const double inner = 100.0 / 3.0 * 1.25 / 1e6 * (0.5 + 4.0);  // p a²/(b² − a²) (1 + ν)/E [(1 − 2ν) a + b²/a]
  CHECK_THAT(radii.at("inner").exact - 1.0, WithinRel(inner, 1e-9));
  CHECK_THAT(radii.at("inner").mean - 1.0, WithinRel(inner, 0.05));
  CHECK(radii.at("inner").mean_relative < 0.05 * inner);
  CHECK(radii.at("outer").mean_relative < 0.05 * inner);
  CHECK(summary_in(folder.path)["errors"]["boundary"]["outer"].contains("radius"));
  CHECK_FALSE(summary_in(folder.path)["errors"]["boundary"]["bottom"].contains("radius"));
}

TEST_CASE("probes are followed at every step, whatever steps are saved", "[engine][run]") {
  const OutputFolder folder;
  Case problem = small_square(5);
  problem.probes = {{"centre", Vec2::Zero()}, {"corner", Vec2(0.07, 0.07)}, {"side", Vec2(0.03, 0.01), true}};
  problem.output.every = 4;
  const Summary summary = run(problem, {.output = folder.path, .quiet = true});
  REQUIRE(summary.probes.size() == 3);
  const ProbeState& last = summary.probes[0].history.back();
  const Json json = summary_in(folder.path)["probes"];
  CHECK(json["centre"]["on"] == "material point");
  CHECK(json["corner"]["on"] == "tracking point");
  CHECK(json["side"]["on"] == "place");
  CHECK(json["side"]["at"] == std::vector{0.03, 0.01});
  CHECK(json["side"]["stress"][1] < 0.0);
  CHECK_THAT(report(summary, folder.path), Contains("place from (0.03, 0.01)"));
  CHECK(json["centre"]["displacement"] == std::vector{last.displacement.x(), last.displacement.y()});
  CHECK(json["centre"]["displacement"][1] < 0.0);

  const hid_t file = H5Fopen((folder.path / "results.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t time = H5Dopen2(file, "probes/corner/t", H5P_DEFAULT);
  std::array<double, 6> t{};
  REQUIRE(H5Dget_storage_size(time) >= sizeof t);
  REQUIRE(H5Dread(time, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, t.data()) >= 0);
  CHECK(t == std::array{0.0, 0.2, 0.4, 0.6, 0.8, 1.0});
  H5Dclose(time);
  H5Fclose(file);
}

TEST_CASE("a run that fails leaves a summary that says so, and throws", "[engine][run]") {
  const OutputFolder folder;
  Case problem = small_square(4);
  problem.boundaries[2].condition =
      Case::Traction{std::array{Quantity(0.0), Quantity(5e6)}};  // the body leaves the grid
  problem.probes = {{"corner", Vec2(0.07, 0.07)}};
  CHECK_THROWS_AS(run(problem, {.output = folder.path, .quiet = true}), ComputationError);
  const Json json = summary_in(folder.path);
  CHECK(json["status"] == "failed");
  CHECK_THAT(json["message"].get<std::string>(), Contains("load step ") && Contains("outside the grid"));
  CHECK(json["steps"].get<int>() >= 1);
  CHECK(json["probes"]["corner"]["displacement"][1] > 0.01);
  CHECK(std::filesystem::exists(folder.path / "results.h5"));
}

TEST_CASE("a run that fails leaves its last step on disk, also where steps are left out", "[engine][run]") {
  const OutputFolder folder;
  Case problem = small_square(8);
  problem.boundaries[2].condition =
      Case::Traction{std::array{Quantity(0.0), Quantity(2e6)}};  // the body leaves the grid
  problem.output.every = 100;
  CHECK_THROWS_AS(run(problem, {.output = folder.path, .quiet = true}), ComputationError);
  const int last = summary_in(folder.path)["steps"].get<int>();
  CHECK(last > 1);
  CHECK(saved_steps(folder.path) == std::vector<std::string>{"000000", fmt::format("{:06}", last)});
}

TEST_CASE("results are written where no curve runs through the moved tracking points any more", "[engine][run]") {
  const OutputFolder folder;
  test::CompressionSquare square{
      .cells = 8, .per_cell = 2, .method = EssentialMethod::grid, .load = 0.0, .poissons_ratio = 0.0};
  Case problem = test::compression_case(square);
  problem.output.pictures = false;
  // a bar between two walls under its weight along it: -0.98 is the strain of its last cell
  problem.body_force = {Quantity(0.98 * 2.0 * square.youngs_modulus / (square.side * 7.0 / 8.0)), Quantity(0.0)};
  std::vector<Vec2>& top = problem.boundaries[2].piece.points;
  top.insert(top.begin() + 1, top.front() - Vec2(4e-14, 0.0));  // hardly further apart than an outline's points may be
  CHECK_THROWS_WITH(run(problem, {.output = folder.path, .quiet = true}),
                    Contains("load step 1: piece 'top': points 0 and 1 are the same"));
  CHECK(saved_steps(folder.path).back() == "000001");
}

TEST_CASE("a case that makes no scene touches no folder", "[engine][run]") {
  const OutputFolder folder;
  Case problem = small_square();
  problem.boundaries.pop_back();
  CHECK_THROWS_AS(run(problem, {.output = folder.path / "out", .quiet = true}), CaseError);
  CHECK_FALSE(std::filesystem::exists(folder.path / "out"));
}

TEST_CASE("results that cannot be written are an output error", "[engine][run]") {
  CHECK_THROWS_AS(run(small_square(), {.output = "/dev/null/out", .quiet = true}), OutputError);
}

TEST_CASE("a run with the same number of threads repeats itself to the last digit", "[engine][run]") {
  const OutputFolder folder;
  Case problem = small_square();
  problem.threads = 2;
  const Summary first = run(problem, {.output = folder.path, .quiet = true});
  const Summary second = run(problem, {.output = folder.path, .quiet = true});
  CHECK(first.reactions == second.reactions);
  CHECK(first.threads == 2);
}

TEST_CASE("a plan names what will run and what not, and its sizes", "[engine][run]") {
  Case problem = small_square(5);
  problem.boundaries[0].condition = Essential{.normal_only = true, .method = EssentialMethod::nitsche};
  const std::string text = plan(problem);
  const auto will_not = text.find("will not run");
  REQUIRE(will_not != std::string::npos);
  for (const char* effect : {"linear_elastic", "nitsche:bottom", "implicit_boundary:left", "traction:top"})
    CHECK(text.find(effect) < will_not);
  CHECK_THAT(text.substr(will_not), Contains("ghost_penalty") && Contains("gravity") && Contains("no key probes") &&
                                        Contains("load steps          5"));
  problem.probes = {{"tip", Vec2::Zero()}};
  CHECK_THAT(plan(problem), Contains("\n  probes  ") && !Contains("no key probes"));
  CHECK_THAT(text, Contains("no key samples") && Contains("diagnostics.strain_energy is false"));
  problem.samples = 10;
  problem.strain_energy = true;
  CHECK_THAT(plan(problem), Contains("\n  samples  ") && Contains("\n  strain_energy  ") &&
                                !Contains("no key samples") && !Contains("diagnostics.strain_energy is false"));
  problem.boundaries.pop_back();
  CHECK_THROWS_AS(plan(problem), CaseError);
}
