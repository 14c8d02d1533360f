#include "shoreline/engine/pictures.hpp"

#include <stdlib.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>

#include "output_folder.hpp"
#include "shoreline/bases/quadrilateral_grid.hpp"
#include "shoreline/engine/results_writer.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::OutputFolder;

namespace {

ResultsWriter results_in(const std::filesystem::path& folder, const std::string& analysis) {
  return {folder, "A square with $ and ß", QuadrilateralGrid(Vec2(-0.5, -0.5), Vec2(0.5, 0.5), {4, 4}), analysis};
}

/// A square of n² points compressed by @p strain, and its outline.
void write_square(ResultsWriter& writer, int n, double strain) {
  for (const double t : {0.0, 1.0}) {
    MaterialPoints points = points_at(Eigen::Matrix2Xd(2, n * n), Eigen::VectorXd::Constant(n * n, 1.0 / n / n));
    points.stress.colwise() = Eigen::Vector4d(-3e3 * t, -8e3 * t, 0, -3e3 * t);
    SavedStep step{
        .step = static_cast<int>(t), .t = t, .curves = {{"outline", Eigen::Matrix2Xd(2, 4), Eigen::Matrix2Xd(2, 5)}}};
    for (int i = 0; i < n * n; ++i) points.position.col(i) = Vec2(i % n + 0.5, i / n + 0.5) / n;
    points.displacement.row(1) = t * strain * points.position.row(1);
    points.position += points.displacement;
    step.curves[0].polyline << 0, 1, 1, 0, 0, 0, 0, 1 + t * strain, 1 + t * strain, 0;
    step.curves[0].points = step.curves[0].polyline.leftCols<4>();
    writer.write(step, points);
  }
}

/// A damped oscillation of 1 mm and 20 ms, its velocity and its exact course, which has no damping.
std::vector<ProbeState> oscillation(bool stressed) {
  std::vector<ProbeState> states;
  const double omega = 2.0 * std::numbers::pi / 0.02, decay = 10.0;
  for (double t = 0.0; t <= 0.1; t += 1e-4) {
    const double u = 1e-3 * std::exp(-decay * t) * std::sin(omega * t);
    const double v = 1e-3 * std::exp(-decay * t) * omega * std::cos(omega * t) - decay * u;
    ProbeState state{.t = t, .position = Vec2(1, 1 + u), .displacement = Vec2(0.1 * u, u), .stress = {}};
    state.velocity = Vec2(0.1 * v, v);
    state.exact_displacement = Vec2(0, 1e-3 * std::sin(omega * t));
    state.exact_velocity = Vec2(0, 1e-3 * omega * std::cos(omega * t));
    if (stressed) state.stress = Stress(1e6 * u, 1e9 * u, 0, 3e8 * u);
    states.push_back(state);
  }
  return states;
}

std::vector<HistoryState> energies() {
  std::vector<HistoryState> history;
  for (const ProbeState& s : oscillation(false)) {
    const double u = s.displacement.y();
    history.push_back({.t = s.t,
                       .kinetic = 500.0 * s.velocity->y() * s.velocity->y(),
                       .strain = 5e7 * u * u,
                       .gravity = 2e4 * (1.0 + u)});
  }
  return history;
}

/// Height of a PNG picture, from its header.
int height_of(const std::filesystem::path& picture) {
  std::ifstream stream(picture, std::ios::binary);
  std::array<unsigned char, 24> head{};
  stream.read(reinterpret_cast<char*>(head.data()), head.size());
  REQUIRE(stream);
  return (head[20] << 24) | (head[21] << 16) | (head[22] << 8) | head[23];
}

/// SHORELINE_PYTHON and PATH for the time of a test.
class Environment {
 public:
  Environment(const char* python, const char* path) : path_(getenv("PATH")) {
    setenv("SHORELINE_PYTHON", python, 1);
    setenv("PATH", path, 1);
  }
  ~Environment() {
    unsetenv("SHORELINE_PYTHON");
    setenv("PATH", path_.c_str(), 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::string path_;
};

}  // namespace

TEST_CASE("a run gives a PNG picture, whatever the number of points, the motion and the folder's name",
          "[engine][pictures]") {
  const auto [n, strain] = GENERATE(table<int, double>({{1, -0.5}, {8, -6.7e-3}, {8, 0.0}, {460, -0.1}}));
  CAPTURE(n, strain);
  const OutputFolder folder;
  const std::filesystem::path odd = folder.path / "it's $HOME `x` ß";
  {
    ResultsWriter writer = results_in(odd, "quasi_static");
    write_square(writer, n, strain);
  }
  REQUIRE(make_pictures(odd).value_or("") == "");
  std::string start(8, ' ');
  std::ifstream(odd / "deformed.png", std::ios::binary).read(start.data(), 8);
  CHECK(start == "\x89PNG\r\n\x1a\n");
  CHECK(std::filesystem::file_size(odd / "deformed.png") > 20000);
}

TEST_CASE("the energies of a dynamic run are one panel over time, displacements, velocities and stresses one each",
          "[engine][pictures]") {
  const OutputFolder folder;
  std::vector<int> heights;
  const std::vector<std::vector<Probe>> probes_of_runs{
      {},
      {{"tip $", 1, 2, oscillation(false)}},
      {{"tip $", 1, 2, oscillation(false)}, {"in", {}, 0, oscillation(true)}}};
  for (const std::vector<Probe>& probes : probes_of_runs) {
    ResultsWriter writer = results_in(folder.path, "explicit_dynamics");
    write_square(writer, 8, -0.1);
    writer.append(energies());
    writer.append(probes);
    REQUIRE(make_pictures(folder.path).value_or("") == "");
    CHECK(std::filesystem::file_size(folder.path / "deformed.png") > 20000);
    heights.push_back(height_of(folder.path / "history.png"));
  }
  const int panel = heights[2] - heights[1];
  CHECK(panel > 200);
  CHECK(std::abs(heights[1] - heights[0] - 2 * panel) <= 2);
}

TEST_CASE("a history is drawn of dynamics alone, and only where there is one", "[engine][pictures]") {
  const OutputFolder folder;
  {
    ResultsWriter writer = results_in(folder.path, "quasi_static");
    write_square(writer, 2, -0.1);
    writer.append(std::vector<Probe>{{"tip", 1, 2, oscillation(false)}});
  }
  REQUIRE(make_pictures(folder.path).value_or("") == "");
  CHECK_FALSE(std::filesystem::exists(folder.path / "history.png"));
  {
    ResultsWriter writer = results_in(folder.path, "explicit_dynamics");
    write_square(writer, 2, -0.1);
  }
  REQUIRE(make_pictures(folder.path).value_or("") == "");
  CHECK_FALSE(std::filesystem::exists(folder.path / "history.png"));
}

TEST_CASE("a projected field gives a PNG picture, with or without its error", "[engine][pictures]") {
  const OutputFolder folder;
  SampledField field{.position = Eigen::Matrix2Xd(2, 3), .value = Eigen::Vector3d(1, 2, 3), .triangle = {}};
  field.position << 0, 1, 0, 0, 0, 1;
  field.triangle = Eigen::Vector3i(0, 1, 2);
  const QuadrilateralGrid cell(Vec2(0, 0), Vec2(1, 1), {1, 1});
  std::uintmax_t size = 0;
  for (const bool known : {false, true}) {
    if (known) field.error = Eigen::Vector3d(0.5, 0, -0.5);
    ResultsWriter(folder.path, "A field with $", cell).write(field);
    REQUIRE(make_pictures(folder.path).value_or("") == "");
    CHECK(std::filesystem::file_size(folder.path / "field.png") > size + 10000);  // one panel, then two
    size = std::filesystem::file_size(folder.path / "field.png");
  }
}

TEST_CASE("a script that fails gives its reason, not an exception", "[engine][pictures]") {
  const OutputFolder folder;
  CHECK_THAT(make_pictures(folder.path).value(), Contains("no picture") && Contains("results.h5"));
  { const ResultsWriter writer(folder.path, "empty", QuadrilateralGrid(Vec2(0, 0), Vec2(1, 1), {1, 1})); }
  CHECK_THAT(make_pictures(folder.path).value(), Contains("no saved step"));
}

TEST_CASE("an interpreter that is missing, no program or without libraries is passed over", "[engine][pictures]") {
  const OutputFolder folder;
  const auto program = [&](const char* name, const char* text) {
    std::ofstream(folder.path / name) << text;
    std::filesystem::permissions(folder.path / name, std::filesystem::perms::owner_all);
    return (folder.path / name).string();
  };
  const std::string without_libraries = program("bare", "#!/bin/sh\ncat > /dev/null\nexit 77\n");
  const std::string succeeds = program("python3", "#!/bin/sh\ncat > \"$2/script\"\n");
  const std::string no_program = folder.path.string();
  for (const std::string& first : {std::string("/no/such/python"), without_libraries, no_program}) {
    CAPTURE(first);
    const Environment environment(first.c_str(), (folder.path.string() + ":/usr/bin:/bin").c_str());
    std::filesystem::remove(folder.path / "script");
    CHECK(make_pictures(folder.path) == std::nullopt);
    CHECK(std::filesystem::file_size(folder.path / "script") > 1000);  // python3 of the path was given it on stdin
  }
  const Environment environment(succeeds.c_str(), "/no/such/path:/usr/bin:/bin");
  CHECK(make_pictures(folder.path) == std::nullopt);
}
