// Every example reaches the norms that its folder states.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

json read(const fs::path& file) {
  std::ifstream stream(file);
  REQUIRE(stream);
  return json::parse(stream);
}

/// What stands at a path like "stress.mean_relative.1" among the errors, or at "probes.tip…" in the whole summary.
double value_at(const json& summary, std::string path) {
  const json& root = path.starts_with("probes.") ? summary : summary.at("errors");
  std::replace(path.begin(), path.end(), '.', '/');
  return root.at(json::json_pointer("/" + path)).get<double>();
}

}  // namespace

TEST_CASE("every case of every example reaches its expected norms, by the program", "[examples]") {
  const fs::path folder = fs::temp_directory_path() / "shoreline_expected_norms";
  int cases = 0;
  for (const auto& example : fs::directory_iterator(SHORELINE_EXAMPLES)) {
    if (!fs::exists(example.path() / "expected.json")) continue;
    const json all = read(example.path() / "expected.json");
    for (const auto& [name, norms] : all.items()) {
      CAPTURE(example.path(), name);
      const std::string command = std::string(SHORELINE_PROGRAM) + " run '" +
                                  (example.path() / (name + ".json")).string() + "' --quiet --output '" +
                                  folder.string() + "' --set output.pictures=false > /dev/null";
      REQUIRE(std::system(command.c_str()) == 0);
      const json summary = read(folder / "summary.json");
      for (const auto& [norm, expected] : norms.items()) {
        CAPTURE(norm);
        CHECK(value_at(summary, norm) ==
              Approx(expected.at("value").get<double>()).margin(expected.at("tolerance").get<double>()).epsilon(0));
      }
      ++cases;
    }
  }
  CHECK(cases >= 10);
  fs::remove_all(folder);
}
