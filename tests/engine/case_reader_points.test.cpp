// Material points as a case names them.

#include <catch2/catch.hpp>

#include "shoreline/engine/case_reader.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;

namespace {

const std::string disc = R"({
  "analysis": {"type": "quasi_static", "plane": "stress"},
  "material": {"type": "linear_elastic", "youngs_modulus": 1, "poissons_ratio": 0},
  "grid": {"lower": [-1, 0], "upper": [1, 2], "cell_size": 0.5},
  "boundaries": [{"name": "rim", "circle": {"centre": [0, 1], "radius": 0.8}}],
  "material_points": {"per_cell": 1}
})";

Case with(const std::vector<std::string>& overrides) { return parse_case(disc, "disc.json", overrides); }

}  // namespace

TEST_CASE("fills and listed points", "[engine][case_reader]") {
  const auto points = [](const std::string& json) { return with({"material_points=" + json}).material_points; };
  const auto vertex = std::get<VertexFill>(points(R"({"fill": "vertex", "per_cell": 4})"));
  CHECK(vertex.count == std::array{4, 4});
  CHECK_FALSE(vertex.across);
  CHECK(vertex.volumes == VolumeRule::clipped);
  const auto across = std::get<VertexFill>(points(R"({"fill": "vertex", "across": [28, 8], "volumes": "lattice"})"));
  CHECK(across.count == std::array{28, 8});
  CHECK(across.across);
  CHECK(across.volumes == VolumeRule::lattice);
  const auto lattice = std::get<LatticeFill>(points(R"({"per_cell": 2, "volumes": "equal"})"));
  CHECK(lattice.volumes == VolumeRule::equal);
  const auto block = std::get<BlockFill>(points(R"({"per_block": [2, 3], "volumes": "lattice"})"));
  CHECK(block.per_block == std::array{2, 3});
  CHECK(block.volumes == VolumeRule::lattice);
  const auto body = std::get<AcrossFill>(points(R"({"across": [10, 1]})"));
  CHECK(body.across == std::array{10, 1});
  CHECK(body.volumes == VolumeRule::clipped);
  const auto any = std::get<RandomFill>(points(R"({"fill": "random", "per_cell": 4})"));
  CHECK(any.per_element == 4);
  CHECK(any.seed == 1);
  CHECK(any.volumes == RandomFill::Volumes::voronoi);
  const auto seeded =
      std::get<RandomFill>(points(R"({"fill": "random", "per_cell": 1, "seed": 7, "volumes": "equal"})"));
  CHECK(seeded.seed == 7);
  CHECK(seeded.volumes == RandomFill::Volumes::equal);
  const auto polar = std::get<PolarFill>(points(R"({"fill": "polar", "across": [9, 17], "volumes": "equal"})"));
  CHECK(polar.across == std::array{9, 17});
  CHECK(polar.centre == Vec2::Zero());
  CHECK(polar.volumes == VolumeRule::equal);
  CHECK(std::get<PolarFill>(points(R"({"fill": "polar", "across": [2, 2], "centre": [1, -2]})")).centre == Vec2(1, -2));
  const auto listed =
      std::get<std::vector<Case::ListedPoint>>(points(R"({"points": [[0.1, 0.2], [0.3, 0.4]], "volumes": [2, 3]})"));
  REQUIRE(listed.size() == 2);
  CHECK(listed[1].position == Vec2(0.3, 0.4));
  CHECK(listed[1].volume == 3.0);
}

TEST_CASE("more points than a machine holds are refused with their number", "[engine][case_reader]") {
  CHECK_THROWS_WITH(with({"grid.cell_size=0.001", "material_points.per_cell=1000"}),
                    Contains("/material_points/per_cell") && Contains("4e+12 points"));
  CHECK_THROWS_WITH(with({R"(material_points={"fill": "polar", "across": [100000, 100000]})"}),
                    Contains("/material_points/across") && Contains("1e+10 points"));
  CHECK_THROWS_WITH(with({R"(material_points={"across": [100000, 100000]})"}),
                    Contains("/material_points/across") && Contains("1e+10 points"));
  CHECK_THROWS_WITH(with({"grid.cell_size=0.001", R"(material_points={"per_block": 1000})"}),
                    Contains("/material_points/per_block") && Contains("4e+12 points"));
  CHECK_THROWS_WITH(with({"grid.cell_size=0.001", R"(material_points={"fill": "random", "per_cell": 1000})"}),
                    Contains("/material_points/per_cell") && Contains("4e+09 points"));
}
