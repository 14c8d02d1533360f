#include "shoreline/engine/case_reader.hpp"

#include <catch2/catch.hpp>

#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

const std::string square = R"({
  "analysis": {"type": "quasi_static", "plane": "stress"},
  "material": {"type": "linear_elastic", "youngs_modulus": 2e6, "poissons_ratio": 0.25},
  "grid": {"lower": [-1, 0], "upper": [1, 2], "cell_size": 0.5},
  "boundaries": [
    {"name": "bottom", "points": [[0, 0], [1, 0]], "condition": {"type": "roller"}},
    {"name": "right", "line": {"from": [1, 0], "to": [1, 1], "points": 5}},
    {"name": "top", "points": [[1, 1], [0.5, 1], [0, 1]], "condition": {"type": "traction", "value": [5, "p*x"]}},
    {"name": "left", "points": [[0, 1], [0, 0]], "condition": {"type": "fixed"}}
  ],
  "constants": {"p": 7},
  "material_points": {"per_cell": [2, 3]}
})";

Case with(const std::vector<std::string>& overrides) { return parse_case(square, "square.json", overrides); }

std::string pointer_of(const std::string& override) {
  try {
    static_cast<void>(with({override}));
    return "accepted";
  } catch (const CaseError& error) {
    return error.pointer();
  }
}

const Essential& essential(const Case& problem, std::size_t piece) {
  return std::get<Essential>(problem.boundaries.at(piece).condition);
}

}  // namespace

TEST_CASE("a case says what it does not leave to defaults", "[engine][case_reader]") {
  const Case problem = with({});
  CHECK(problem.title == "square");  // the name of the file
  CHECK(problem.plane == Plane::stress);
  CHECK(problem.material.youngs_modulus == 2e6);
  CHECK(problem.material.poissons_ratio == 0.25);
  CHECK(problem.grid.lower == Vec2(-1, 0));
  CHECK(problem.grid.upper == Vec2(1, 2));
  CHECK(problem.grid.cell_size == Vec2(0.5, 0.5));
  CHECK(problem.boundaries.size() == 4);
  CHECK(problem.boundaries[1].piece.name == "right");
  CHECK(problem.boundaries[1].piece.points.size() == 5);
  CHECK(std::holds_alternative<Case::Free>(problem.boundaries[1].condition));
  CHECK(std::get<LatticeFill>(problem.material_points).per_cell == std::array{2, 3});
}

TEST_CASE("the dilatation is projected where a case says so, in plane stress that is refused with the reason",
          "[engine][case_reader]") {
  CHECK_FALSE(with({}).material.projected_dilatation);
  CHECK_FALSE(with({"material.dilatation=plain"}).material.projected_dilatation);
  CHECK(with({"analysis.plane=strain", "material.dilatation=projected"}).material.projected_dilatation);
  CHECK(pointer_of("material.dilatation=projected") == "/material/dilatation");
  CHECK(pointer_of("material.dilatation=mean") == "/material/dilatation");
  CHECK_THROWS_WITH(with({"material.dilatation=projected"}), Contains("plane stress"));
}

TEST_CASE("what a case leaves out has the default of the table", "[engine][case_reader]") {
  const Case problem = with({});
  CHECK(std::get<QuasiStatic>(problem.analysis).load_steps == 1);
  CHECK(std::get<QuasiStatic>(problem.analysis).loading == Loading::residual);
  CHECK(problem.ghost == 0.0);
  CHECK(problem.threads == 0);
  CHECK(problem.output.every == 1);
  CHECK(problem.output.pictures);
  CHECK_FALSE(problem.condition_estimate);
  CHECK_FALSE(problem.cut_fractions);
  CHECK_FALSE(problem.error_estimate);
  CHECK_FALSE(problem.material.density.has_value());
  CHECK_FALSE(problem.body_force.has_value());
  CHECK_FALSE(problem.gravity.has_value());
  CHECK_FALSE(problem.exact.has_value());
  CHECK_FALSE(problem.samples.has_value());
  CHECK_FALSE(problem.strain_energy);
  CHECK(std::get<LatticeFill>(problem.material_points).volumes == VolumeRule::clipped);
}

TEST_CASE("the band and the ghost penalty follow the method unless the case says otherwise", "[engine][case_reader]") {
  CHECK(essential(with({}), 0).band == 1e-3);
  CHECK(essential(with({}), 0).normal_only);
  CHECK_FALSE(essential(with({}), 3).normal_only);

  const Case nitsche = with({"boundaries.left.condition.method=nitsche"});
  CHECK(essential(nitsche, 3).method == EssentialMethod::nitsche);
  CHECK(essential(nitsche, 3).band == 0.01);
  CHECK(nitsche.ghost == 1e-3);
  CHECK(with({"boundaries.left.condition.method=nitsche", "ghost=0"}).ghost == 0.0);
  CHECK(essential(with({"boundaries.left.condition.band=1e-6"}), 3).band == 1e-6);
  CHECK(essential(with({"boundaries.left.condition.method=grid"}), 3).method == EssentialMethod::grid);
}

TEST_CASE("plain numbers ramp in loads and do not in an exact solution", "[engine][case_reader]") {
  const Case problem = with(
      {R"(exact={"type": "expressions", "displacement": [3, "x"], "stress": [0, 1e-5, -2]})", "body_force=[1, \"p\"]"});
  const auto& traction = std::get<Case::Traction>(problem.boundaries[2].condition);
  const auto& value = std::get<std::array<Quantity, 2>>(traction.value);
  const PlaceTime half{.x = {2.0, 0.0}, .t = 0.25, .factor = 0.5};
  CHECK(value[0](half) == 2.5);
  CHECK(value[1](half) == 14.0);
  CHECK((*problem.body_force)[0](half) == 0.5);
  CHECK((*problem.body_force)[1](half) == 7.0);
  const auto& exact = std::get<Case::ExactExpressions>(problem.exact.value());
  CHECK(exact.displacement[0](half) == 3.0);
  CHECK(exact.displacement[1](half) == 2.0);
  CHECK(exact.stress[1](half) == 1e-5);
  CHECK(exact.stress[2](half) == -2.0);
}

TEST_CASE("a piece that ends where it starts is a closed loop of one point less", "[engine][case_reader]") {
  const Case problem =
      with({"boundaries.1={\"name\": \"loop\", \"points\": [[0,0],[1,0],[1,1],[0,0]], \"corners\": [0]}"});
  CHECK(problem.boundaries[1].piece.closed);
  CHECK(problem.boundaries[1].piece.points.size() == 3);
  CHECK(problem.boundaries[1].piece.corners == std::vector{0});
  CHECK_FALSE(problem.boundaries[0].piece.closed);
}

TEST_CASE("arcs and circles place their points on the circle", "[engine][case_reader]") {
  const Case problem =
      with({R"(boundaries.0={"name": "hole", "circle": {"centre": [1, 2], "radius": 0.5, "hole": true}})",
            R"(boundaries.1={"name": "arc", "arc": {"centre": [1, 2], "radius": 0.5, "from": 90, "to": 0}})"});
  CHECK(problem.boundaries[0].piece.closed);
  CHECK(problem.boundaries[0].piece.points.size() == 16);
  CHECK_FALSE(problem.boundaries[1].piece.closed);
  CHECK(problem.boundaries[1].piece.points.front() == Vec2(1.0, 2.5));
  for (const auto& boundary : {problem.boundaries[0], problem.boundaries[1]})
    for (const Vec2& x : boundary.piece.points) CHECK_THAT((x - Vec2(1, 2)).norm(), WithinAbs(0.5, 1e-15));
}

TEST_CASE("a displacement is prescribed as a vector, along the normal, or by the exact solution",
          "[engine][case_reader]") {
  const auto condition = [](const std::string& more) {
    const std::string exact = R"(exact={"type": "plate_with_hole", "radius": 1, "far_field_stress": 1})";
    const Case problem = with({"boundaries.left.condition={\"type\": \"displacement\", " + more + "}", exact});
    return std::get<Case::Displacement>(problem.boundaries[3].condition);
  };
  const PlaceTime late{.x = {2.0, 0.0}, .t = 1.0, .factor = 0.5};
  const Case::Displacement both = condition(R"("value": [4, "p*x"])");
  const auto& value = std::get<std::array<Quantity, 2>>(both.value);
  CHECK(value[0](late) == 2.0);
  CHECK(value[1](late) == 14.0);
  CHECK_FALSE(both.support.normal_only);
  CHECK(both.support.band == 1e-3);

  const Case::Displacement normal = condition(R"("normal": -4, "method": "nitsche")");
  CHECK(std::get<Quantity>(normal.value)(late) == -2.0);
  CHECK(normal.support.normal_only);
  CHECK(normal.support.method == EssentialMethod::nitsche);
  CHECK(normal.support.band == 0.01);

  const Case::Displacement exact = condition(R"("value": "exact", "band": 1e-6)");
  CHECK(std::holds_alternative<Case::FromExact>(exact.value));
  CHECK_FALSE(exact.support.normal_only);
  CHECK(exact.support.band == 1e-6);
  const Case::Displacement across = condition(R"("normal": "exact")");
  CHECK(std::holds_alternative<Case::FromExact>(across.value));
  CHECK(across.support.normal_only);
}

TEST_CASE("a displacement by Nitsche's method comes with the ghost penalty", "[engine][case_reader]") {
  const std::string moved = R"(boundaries.left.condition={"type": "displacement", "value": [0, 0]})";
  CHECK(with({moved}).ghost == 0.0);
  CHECK(with({moved, "boundaries.left.condition.method=nitsche"}).ghost == 1e-3);
}

TEST_CASE("a condition may be exact only where the case says what is exact", "[engine][case_reader]") {
  const std::string exact = R"(exact={"type": "thick_cylinder", "inner_radius": 1, "outer_radius": 2, "pressure": 3})";
  const std::string traction = "boundaries.top.condition.value=exact";
  const Case problem = with({traction, exact});
  CHECK(std::holds_alternative<Case::FromExact>(std::get<Case::Traction>(problem.boundaries[2].condition).value));
  CHECK_THROWS_WITH(with({traction}), Contains("/boundaries/2/condition/value: ") && Contains("the key \"exact\""));
}

TEST_CASE("closed forms of exact solutions", "[engine][case_reader]") {
  const Case ring = with({R"(exact={"type": "thick_cylinder", "inner_radius": 1, "outer_radius": 5, "pressure": -3})"});
  const auto& cylinder = std::get<ThickCylinder>(ring.exact.value());
  CHECK(cylinder.inner_radius == 1.0);
  CHECK(cylinder.outer_radius == 5.0);
  CHECK(cylinder.pressure == -3.0);
  const Case holed = with({R"(exact={"type": "plate_with_hole", "radius": 0.5, "far_field_stress": 1e6})"});
  const auto& plate = std::get<PlateWithHole>(holed.exact.value());
  CHECK(plate.radius == 0.5);
  CHECK(plate.far_field_stress == 1e6);
}

namespace {
const QuasiStatic& load_steps(const Case& problem) { return std::get<QuasiStatic>(problem.analysis); }
}  // namespace

TEST_CASE("the load factor is a formula of t alone", "[engine][case_reader]") {
  CHECK_FALSE(load_steps(with({})).load.has_value());
  const Case rooted = with({"analysis.load=p*sqrt(t)"});
  CHECK((*load_steps(rooted).load)({.t = 0.25}) == 3.5);
  const Case held = with({"analysis.load=1"});
  CHECK((*load_steps(held).load)({.t = 0.25}) == 1.0);
  for (const char* place : {"x", "y", "X", "Y"})
    CHECK(pointer_of(std::string("analysis.load=t*") + place) == "/analysis/load");
}

TEST_CASE("probes and re-spacing are there only where asked for", "[engine][case_reader]") {
  CHECK(with({}).probes.empty());
  CHECK(with({}).respacing == 0.0);
  const Case problem = with({R"(probes=[{"name": "tip", "position": [1, 2]}, {"name": "root", "position": [3, 4]}])",
                             "probes.tip.position.0=-1", "tracking.respace=4"});
  REQUIRE(problem.probes.size() == 2);
  CHECK(problem.probes[0].name == "tip");
  CHECK(problem.probes[0].position == Vec2(-1, 2));
  CHECK(problem.probes[1].name == "root");
  CHECK_FALSE(problem.probes[0].at_place);
  CHECK(with({R"(probes=[{"name": "tip", "position": [1, 2], "at": "place"}])"}).probes[0].at_place);
  CHECK(problem.respacing == 4.0);
}

TEST_CASE("samples go with an exact solution", "[engine][case_reader]") {
  const std::string exact = R"(exact={"type": "expressions", "displacement": [0, 0], "stress": [0, 0, 0]})";
  CHECK(with({exact, "samples=40"}).samples == 40);
  CHECK(pointer_of("samples=40") == "/samples");
  CHECK_THROWS_WITH(with({"samples=40"}), Contains("found sample points") && Contains("expected the key \"exact\""));
  CHECK(with({"diagnostics.strain_energy=true"}).strain_energy);
}

TEST_CASE("an override sets what its path leads to", "[engine][case_reader]") {
  CHECK(with({"grid.cell_size=[0.25, 0.5]"}).grid.cell_size == Vec2(0.25, 0.5));
  CHECK(with({"grid.lower.1=-3"}).grid.lower == Vec2(-1, -3));
  CHECK(with({"boundaries.0.name=base"}).boundaries[0].piece.name == "base");
  CHECK(with({"boundaries.bottom.name=base"}).boundaries[0].piece.name == "base");
  CHECK(with({"solver.threads=2"}).threads == 2);         // an object that was missing
  CHECK(with({"title=two words"}).title == "two words");  // no JSON: the text as it stands
  CHECK(with({"title=\"5\""}).title == "5");              // JSON
  CHECK(with({"title=a=b"}).title == "a=b");              // only the first = divides
  CHECK(with({"title=a", "title=b"}).title == "b");       // in order
  CHECK(with({"output.pictures=false"}).output.pictures == false);
}

TEST_CASE("overrides are checked like the file", "[engine][case_reader]") {
  CHECK(pointer_of("grid.cell_size=-1") == "/grid/cell_size");
  CHECK(pointer_of("grid.cellsize=1") == "/grid");
  CHECK(pointer_of("boundaries.top.condition.value.1=q") == "/boundaries/2/condition/value/1");
  CHECK(pointer_of("gravity=[0, -9.81]") == "/gravity");  // no density
  CHECK(pointer_of("boundaries.tpo.name=x") == "/boundaries");
}

TEST_CASE("a whole number may be written with a decimal point", "[engine][case_reader]") {
  CHECK(load_steps(with({"analysis.load_steps=4.0"})).load_steps == 4);
  CHECK(pointer_of("analysis.load_steps=4.5") == "/analysis/load_steps");
}

TEST_CASE("a message names file, place, what was found and what was expected", "[engine][case_reader]") {
  CHECK_THROWS_WITH(with({"grid.basis=billinear"}),
                    Contains("square.json: /grid/basis: found \"billinear\"") && Contains("nearest: \"bilinear\""));
  CHECK_THROWS_WITH(
      with({"boundaries.left.condition.metod=grid"}),
      Contains("square.json: /boundaries/3/condition: found unknown key \"metod\"") && Contains("nearest: \"method\""));
  CHECK_THROWS_WITH(parse_case("{\"a\": 1,\n \"b\": }", "x.json"), Contains("x.json") && Contains("line 2, column 7"));
  CHECK_THROWS_WITH(parse_case("{\"a\": [1, {\"b~/c\": 1, \"b~/c\": 2}]}", "x.json"),
                    Contains("x.json: /a/1/b~0~1c: ") && Contains("twice"));
}

TEST_CASE("a grid of more cells than a machine holds is refused with their number", "[engine][case_reader]") {
  CHECK_THROWS_WITH(with({"grid.cell_size=[1e-5, 1e-5]"}), Contains("/grid/cell_size") && Contains("4e+10 cells"));
  CHECK_THROWS_WITH(with({"grid.cell_size=[1e-12, 1e3]"}), Contains("/grid/cell_size") && Contains("2e+12 x 1"));
}

TEST_CASE("schema and reference page name every key that a case may have", "[engine][case_reader]") {
  const std::string key =
      GENERATE("title", "plane", "youngs_modulus", "cell_size", "corners", "band", "hole", "per_cell", "gravity",
               "ghost", "displacement", "condition_estimate", "cut_fractions", "error_estimate", "pictures", "load",
               "normal", "across", "centre", "far_field_stress", "inner_radius", "probes", "position", "respace",
               "per_block", "seed", "samples", "strain_energy");
  CHECK_THAT(case_schema(), Contains("\"" + key + "\""));
  CHECK_THAT(case_format(), Contains("| `" + key + "` |"));
}
