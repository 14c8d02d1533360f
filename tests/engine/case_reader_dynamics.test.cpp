// What the reader makes of a case of explicit dynamics.

#include <catch2/catch.hpp>

#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;

namespace {

const std::string block = R"({
  "analysis": {"type": "explicit_dynamics", "end_time": 2.5},
  "material": {"type": "neo_hookean", "youngs_modulus": 2e6, "poissons_ratio": 0.25, "density": 1500},
  "grid": {"lower": [-1, 0], "upper": [1, 2], "cell_size": 0.5},
  "material_points": {"points": [[0.1, 0.2], [0.3, 0.4]], "volumes": [2, 3]}
})";

const std::string outline = R"(boundaries=[
  {"name": "base", "points": [[0, 0], [1, 0]], "condition": {"type": "fixed"}},
  {"name": "right", "points": [[1, 0], [1, 1]], "condition": {"type": "roller", "method": "grid"}},
  {"name": "top", "points": [[1, 1], [0, 1]], "condition": {"type": "traction", "value": [5, "2*t"]}},
  {"name": "left", "points": [[0, 1], [0, 0]], "condition": {"type": "displacement", "value": ["t", 0]}}])";

Case with(const std::vector<std::string>& overrides) { return parse_case(block, "block.json", overrides); }

ExplicitDynamics settings(const std::vector<std::string>& overrides) {
  return std::get<ExplicitDynamics>(with(overrides).analysis);
}

std::string refusal(const std::vector<std::string>& overrides) {
  try {
    static_cast<void>(with(overrides));
    return "accepted";
  } catch (const CaseError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a case of dynamics says law, density and end time", "[engine][case_reader]") {
  const Case problem = with({});
  CHECK(problem.title == "block");
  CHECK(problem.plane == Plane::strain);
  CHECK(problem.material.law == Case::Law::neo_hookean);
  CHECK(problem.material.youngs_modulus == 2e6);
  CHECK(problem.material.poissons_ratio == 0.25);
  CHECK(problem.material.density == 1500.0);
  CHECK(settings({}).end_time == 2.5);
  CHECK(with({"material.type=linear_large"}).material.law == Case::Law::linear_large);
  CHECK(with({"material.type=hypoelastic"}).material.law == Case::Law::hypoelastic);
}

TEST_CASE("what a case of dynamics leaves out has the default of the table", "[engine][case_reader]") {
  const Case problem = with({});
  CHECK_FALSE(settings({}).time_step);
  CHECK(settings({}).safety == 0.7);
  CHECK(settings({}).mass == MassForm::lumped);
  CHECK(settings({}).pic == 0.0);
  CHECK(settings({}).damping == 0.0);
  CHECK_FALSE(settings({}).drop_outside);
  CHECK(problem.boundaries.empty());
  CHECK_FALSE(problem.gravity);
  CHECK_FALSE(problem.gravity_field);
  CHECK_FALSE(problem.body_force);
  CHECK_FALSE(problem.initial_velocity);
  CHECK_FALSE(problem.history);
  CHECK_FALSE(problem.exact);
  CHECK(problem.probes.empty());
  CHECK(problem.ghost == 0.0);
  CHECK(problem.output.every == 0);
  CHECK(problem.output.pictures);
}

TEST_CASE("settings of the time steps", "[engine][case_reader]") {
  CHECK(settings({"analysis.time_step=1e-3"}).time_step == 1e-3);
  CHECK_FALSE(settings({"analysis.time_step=auto"}).time_step);
  CHECK(settings({"analysis.time_step=auto", "analysis.safety=0.4"}).safety == 0.4);
  CHECK(settings({"analysis.mass=consistent"}).mass == MassForm::consistent);
  CHECK(settings({"analysis.mass=lumped"}).mass == MassForm::lumped);
  CHECK(settings({"analysis.mass=partly_lumped"}).mass == MassForm::partly_lumped);
  CHECK(settings({"analysis.transfer=flip"}).pic == 0.0);
  CHECK(settings({"analysis.transfer=pic"}).pic == 1.0);
  CHECK(settings({"analysis.transfer=0.25"}).pic == 0.25);
  CHECK(settings({"analysis.damping=0.3"}).damping == 0.3);
  CHECK(settings({"analysis.leaving=drop"}).drop_outside);
  CHECK_FALSE(settings({"analysis.leaving=stop"}).drop_outside);
}

TEST_CASE("gravity is two numbers, or formulas", "[engine][case_reader]") {
  CHECK(with({"gravity=[0, -9.81]"}).gravity == Vec2(0.0, -9.81));
  CHECK_FALSE(with({"gravity=[0, -9.81]"}).gravity_field);
  const Case problem = with({R"(gravity=[0, "-g*t*x"])", "constants.g=3"});
  CHECK_FALSE(problem.gravity);
  const PlaceTime at{.x = Vec2(2.0, 0.0), .t = 0.5};
  CHECK((*problem.gravity_field)[0](at) == 0.0);
  CHECK((*problem.gravity_field)[1](at) == -3.0);
}

TEST_CASE("plain numbers do not ramp in time", "[engine][case_reader]") {
  const Case problem = with({"body_force=[2, \"3*t\"]", "initial_velocity=[4, \"y\"]", outline});
  const PlaceTime at{.x = Vec2(0.0, 7.0), .t = 0.5, .factor = 1.0};
  CHECK((*problem.body_force)[0](at) == 2.0);
  CHECK((*problem.body_force)[1](at) == 1.5);
  CHECK((*problem.initial_velocity)[0](at) == 4.0);
  CHECK((*problem.initial_velocity)[1](at) == 7.0);
}

TEST_CASE("supports of dynamics are on grid lines unless a case says otherwise", "[engine][case_reader]") {
  const Case problem = with({outline});
  REQUIRE(problem.boundaries.size() == 4);
  const auto& base = std::get<Essential>(problem.boundaries[0].condition);
  CHECK(base.method == EssentialMethod::grid);
  CHECK_FALSE(base.normal_only);
  CHECK(std::get<Essential>(problem.boundaries[1].condition).normal_only);
  CHECK(std::holds_alternative<Case::Traction>(problem.boundaries[2].condition));
  CHECK(std::get<Case::Displacement>(problem.boundaries[3].condition).support.method == EssentialMethod::grid);
}

TEST_CASE("history, probes and saved steps of dynamics", "[engine][case_reader]") {
  CHECK(with({"history={}"}).history == 1);
  CHECK(with({"history.every=20"}).history == 20);
  const Case problem = with({R"(probes=[{"name": "tip", "position": [1, 2]}])", "output.every=7",
                             "output.pictures=false", "solver.threads=2"});
  REQUIRE(problem.probes.size() == 1);
  CHECK(problem.probes[0].position == Vec2(1, 2));
  CHECK(problem.output.every == 7);
  CHECK_FALSE(problem.output.pictures);
  CHECK(problem.threads == 2);
}

TEST_CASE("exact solutions of dynamics", "[engine][case_reader]") {
  const std::vector<std::string> right{R"(exact={"type": "self_weight_column", "height": 1.5})", "gravity=[0, -9.81]",
                                       "material.type=linear_large"};
  const auto column = std::get<SelfWeightColumn>(*with(right).exact);
  CHECK(column.height == 1.5);
  CHECK(column.density == 1500.0);
  CHECK(column.gravity == 9.81);
  const Case formulas = with({R"(exact={"type": "expressions", "displacement": ["t*X", 0], "stress": [0, "t", 1]})"});
  const auto& exact = std::get<Case::ExactExpressions>(*formulas.exact);
  CHECK(exact.displacement[0]({.origin = Vec2(3.0, 0.0), .t = 2.0}) == 6.0);
  CHECK(exact.stress[2]({}) == 1.0);
}

TEST_CASE("the column under its own weight needs gravity along y, as numbers, and its law", "[engine][case_reader]") {
  const std::string column = R"(exact={"type": "self_weight_column", "height": 1.5})";
  const auto no_gravity = [](const std::string& message) {
    CHECK_THAT(message, Contains("block.json: /exact/type: ") && Contains("\"gravity\""));
  };
  no_gravity(refusal({column, "material.type=linear_large"}));
  no_gravity(refusal({column, "material.type=linear_large", "gravity=[1, -9.81]"}));
  no_gravity(refusal({column, "material.type=linear_large", "gravity=[0, \"-9.81\"]"}));
  CHECK_THAT(refusal({column, "gravity=[0, -9.81]"}),
             Contains("block.json: /material/type: found \"neo_hookean\"") && Contains("\"linear_large\""));
}

TEST_CASE("a safety factor goes with auto alone, and steps are counted before they are made", "[engine][case_reader]") {
  CHECK_THAT(refusal({"analysis.time_step=1e-3", "analysis.safety=0.5"}),
             Contains("block.json: /analysis/safety: ") && Contains("\"auto\""));
  CHECK_THAT(refusal({"analysis.time_step=1e-12"}), Contains("/analysis/time_step: ") && Contains("2.5e+12 steps"));
}

TEST_CASE("schema and reference page name the keys of dynamics", "[engine][case_reader]") {
  const std::string key = GENERATE("time_step", "safety", "end_time", "mass", "transfer", "damping", "leaving",
                                   "initial_velocity", "history", "height", "density");
  CHECK_THAT(case_schema(), Contains("\"" + key + "\""));
  CHECK_THAT(case_format(), Contains("| `" + key + "` |"));
  CHECK_THAT(case_schema(), Contains("self_weight_column") && Contains("hypoelastic"));
}

TEST_CASE("a ghost mass goes with the consistent mass alone, as lumping erases it", "[engine][case_reader]") {
  CHECK(settings({}).ghost == 0.0);
  CHECK(settings({"analysis.mass=consistent", "ghost=1e-3"}).ghost == 1e-3);
  CHECK(settings({"analysis.mass=lumped", "ghost=0"}).ghost == 0.0);
  CHECK_THAT(refusal({"analysis.mass=lumped", "ghost=1e-3"}),
             Contains("/ghost: found 0.001 beside a lumped mass, expected 0") && Contains("lumping erases it"));
  CHECK_THAT(refusal({"analysis.mass=partly_lumped", "ghost=1e-3"}), Contains("partly_lumped mass, expected 0"));
}
