#include "shoreline/engine/run.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../scenes.hpp"
#include "output_folder.hpp"
#include "shoreline/engine/failures.hpp"

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
  problem.exact = Case::Exact{{Expression("0"), Expression("-t*1e-6*(Y+0.05)")},
                              {Expression("0"), Expression("-t"), Expression("0")}};
  const Summary summary = run(problem, {.output = folder.path, .quiet = true});
  REQUIRE(summary.errors);
  CHECK(summary.errors->displacement_l2_relative.value() < 1e-12);
  CHECK(summary.errors->stress_l2_relative.value() < 1e-9);
  CHECK(summary.errors->boundary_l2_displacement.at("bottom") < 1e-12);
  CHECK(summary.errors->boundary_l2_displacement.size() == 3);

  problem.exact->displacement[1] = Expression("0.001-t*1e-6*(Y+0.05)");  // off along the rollers at the sides
  const Summary off = run(problem, {.output = folder.path, .quiet = true});
  CHECK(off.errors->boundary_l2_displacement.at("right") < 1e-12);
  CHECK_THAT(off.errors->boundary_l2_displacement.at("bottom"), WithinRel(0.001 * std::sqrt(0.1), 1e-6));
}

TEST_CASE("a run that fails leaves a summary that says so, and throws", "[engine][run]") {
  const OutputFolder folder;
  Case problem = small_square(4);
  problem.boundaries[2].condition = Case::Traction{{Quantity(0.0), Quantity(5e6)}};  // the body leaves the grid
  CHECK_THROWS_AS(run(problem, {.output = folder.path, .quiet = true}), ComputationError);
  const Json json = summary_in(folder.path);
  CHECK(json["status"] == "failed");
  CHECK_THAT(json["message"].get<std::string>(), Contains("load step ") && Contains("outside the grid"));
  CHECK(json["steps"].get<int>() >= 1);
  CHECK(std::filesystem::exists(folder.path / "results.h5"));
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
  CHECK_THAT(text.substr(will_not),
             Contains("ghost penalty") && Contains("gravity") && Contains("load steps          5"));
  problem.boundaries.pop_back();
  CHECK_THROWS_AS(plan(problem), CaseError);
}
