// Projection as an analysis: from a case to its files.

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "output_folder.hpp"
#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/run.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Case projection(const std::string& analysis, const std::string& grid, const std::string& more = "") {
  return parse_case(R"({"analysis": {"type": "projection", )" + analysis + R"(},
    "grid": {"lower": [0, 0], "upper": [1, 1], )" +
                        grid + R"(}, "output": {"pictures": false})" + more + "}",
                    "case.json");
}

Summary run(const Case& problem) {
  const test::OutputFolder folder;
  return run(problem, {.output = folder.path, .quiet = true});
}

const std::string sines = R"json("value": "sin(pi*x)*sin(pi*y)",
  "gradient": ["pi*cos(pi*x)*sin(pi*y)", "pi*sin(pi*x)*cos(pi*y)"])json";

}  // namespace

TEST_CASE("a case projects onto Powell-Sabin splines with the published error", "[engine][projection]") {
  const Summary summary = run(projection(sines, R"("cell_size": 0.125, "basis": "powell_sabin")"));
  CHECK(summary.completed);
  CHECK(summary.analysis == "projection");
  CHECK(summary.basis == "powell_sabin");
  CHECK(summary.degrees_of_freedom == 3 * 81);
  const ProjectionErrors& errors = summary.projection_errors.value();
  CHECK_THAT(errors.l2, WithinRel(1.317e-4, 0.015));
  CHECK_THAT(errors.l2_relative.value(), WithinRel(2.0 * errors.l2, 1e-6));  // ‖f‖ = ½
  const auto& slopes = errors.derivative_l2.value();
  CHECK(slopes[0] > 10.0 * errors.l2);
  CHECK_THAT(slopes[1], WithinRel(slopes[0], 0.1));  // both alike, but for the diagonals
}

TEST_CASE("the derivatives of a consistent projection converge, of a lumped one onto Powell-Sabin splines not",
          "[engine][projection]") {
  const auto slope = [](const std::string& mass, const std::string& size) {
    const Case problem =
        projection(sines + R"(, "mass": ")" + mass + "\"", R"("basis": "powell_sabin", "cell_size": )" + size);
    return run(problem).projection_errors.value().derivative_l2.value()[0];
  };
  CHECK(std::log2(slope("consistent", "0.125") / slope("consistent", "0.0625")) > 1.9);
  CHECK(std::log2(slope("lumped", "0.125") / slope("lumped", "0.0625")) < 0.3);
}

TEST_CASE("data at listed points are projected with the points' volumes as weights", "[engine][projection]") {
  const std::string points =
      R"(, "material_points": {"points": [[0.2, 0.3], [0.7, 0.1], [0.9, 0.8], [0.1, 0.9], [0.5, 0.5]],
    "volumes": [1, 2, 3, 4, 5]})";
  const Summary linear = run(projection(R"("data": [2.1, 3.3, 3.0, 1.3, 2.5])", R"("cell_size": 1)", points));
  CHECK(linear.material_points == 5);
  CHECK_THAT(linear.projection_errors.value().l2, WithinAbs(0.0, 1e-12));  // they are 2 + 2x − y
  // 0 and 1 at one place with volumes 1 and 3: the mean is ¾, and √(1·¾² + 3·¼²) its error
  const Summary mean =
      run(projection(R"("data": [0, 1], "mass": "lumped")", R"("cell_size": 1)",
                     R"(, "material_points": {"points": [[0.5, 0.5], [0.5, 0.5]], "volumes": [1, 3]})"));
  CHECK_THAT(mean.projection_errors.value().l2, WithinRel(std::sqrt(0.75), 1e-12));
  CHECK_FALSE(mean.projection_errors.value().derivative_l2.has_value());
}

TEST_CASE("the points of a fill determine the functions of their cells", "[engine][projection]") {
  const Case problem = projection(R"("value": "x*y")", R"("cell_size": 0.25)",
                                  R"(, "material_points": {"per_cell": 3}, "boundaries": [
    {"name": "body", "points": [[0, 0], [0.5, 0], [0.5, 0.5], [0, 0.5], [0, 0]], "corners": [0, 1, 2, 3]}])");
  const Summary summary = run(problem);
  CHECK(summary.material_points == 4 * 9);
  CHECK(summary.degrees_of_freedom == 9);
  CHECK_THAT(summary.projection_errors.value().l2, WithinAbs(0.0, 1e-12));
}

TEST_CASE("a projection leaves its field, an index for viewers and a summary", "[engine][projection]") {
  const test::OutputFolder folder;
  static_cast<void>(run(projection(sines, R"("cell_size": 0.5, "basis": "bspline", "degree": 3)"),
                        {.output = folder.path, .quiet = true}));
  CHECK(std::filesystem::exists(folder.path / "results.h5"));
  std::ifstream index(folder.path / "results.xdmf");
  const std::string xdmf{std::istreambuf_iterator<char>(index), {}};
  CHECK_THAT(xdmf,
             Contains("TopologyType=\"Triangle\" NumberOfElements=\"512\"") && Contains("results.h5:/field/error"));
  const auto summary = nlohmann::json::parse(std::ifstream(folder.path / "summary.json"));
  CHECK(summary.at("status") == "completed");
  CHECK(summary.at("degree") == 3);
  CHECK(summary.at("errors").at("projection").contains("x_derivative_l2"));
  CHECK_FALSE(summary.contains("reactions"));
}

TEST_CASE("points that cannot determine a field are the case's fault", "[engine][projection]") {
  const Case one = projection(R"("data": [1])", R"("cell_size": 1)",
                              R"(, "material_points": {"points": [[0.5, 0.5]], "volumes": [1]})");
  CHECK_THROWS_AS(run(one), CaseError);
  CHECK_THROWS_WITH(run(one), Contains("case.json: /material_points: ") && Contains("singular"));
}

TEST_CASE("a formula without a value fails the run, and the summary says so", "[engine][projection]") {
  const test::OutputFolder folder;
  const Case problem = projection(R"json("value": "1/(x-x)")json", R"("cell_size": 0.5)");
  CHECK_THROWS_AS(run(problem, {.output = folder.path, .quiet = true}), ComputationError);
  const auto summary = nlohmann::json::parse(std::ifstream(folder.path / "summary.json"));
  CHECK(summary.at("status") == "failed");
  CHECK_THAT(summary.at("message").get<std::string>(), Contains("1/(x-x)"));
}

TEST_CASE("a formula without a value on the edge of the grid is projected", "[engine][projection]") {
  CHECK(run(projection(R"json("value": "log(x)")json", R"("cell_size": 0.5)")).completed);
}

TEST_CASE("the plan of a projection names its basis and sizes", "[engine][projection]") {
  const std::string text = plan(projection(sines, R"("cell_size": 0.5, "basis": "powell_sabin")"));
  CHECK_THAT(text, Contains("powell_sabin") && Contains("8 elements of 6 cells") && Contains("unknowns            27"));
}
