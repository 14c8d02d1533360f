#include "shoreline/engine/pictures.hpp"

#include <stdlib.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "output_folder.hpp"
#include "shoreline/bases/quadrilateral_grid.hpp"
#include "shoreline/engine/results_writer.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::OutputFolder;

namespace {

/// A square of n² points compressed by @p strain, and its outline.
void write_square(const std::filesystem::path& folder, int n, double strain) {
  ResultsWriter writer(folder, "A square with $ and ß", QuadrilateralGrid(Vec2(-0.5, -0.5), Vec2(0.5, 0.5), {4, 4}));
  for (const double t : {0.0, 1.0}) {
    SavedStep step{.step = static_cast<int>(t),
                   .t = t,
                   .position = Eigen::Matrix2Xd(2, n * n),
                   .displacement = {},
                   .stress = Eigen::Vector4d(-3e3 * t, -8e3 * t, 0, -3e3 * t).replicate(1, n * n),
                   .strain = Eigen::Matrix3Xd::Zero(3, n * n),
                   .volume = Eigen::VectorXd::Constant(n * n, 1.0 / n / n),
                   .curves = {{"outline", Eigen::Matrix2Xd(2, 4), Eigen::Matrix2Xd(2, 5)}}};
    for (int i = 0; i < n * n; ++i) step.position.col(i) = Vec2(i % n + 0.5, i / n + 0.5) / n;
    step.displacement = Eigen::Matrix2Xd::Zero(2, n * n);
    step.displacement.row(1) = t * strain * step.position.row(1);
    step.position += step.displacement;
    step.curves[0].polyline << 0, 1, 1, 0, 0, 0, 0, 1 + t * strain, 1 + t * strain, 0;
    step.curves[0].points = step.curves[0].polyline.leftCols<4>();
    writer.write(step);
  }
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
  write_square(odd, n, strain);
  REQUIRE(make_pictures(odd).value_or("") == "");
  std::string start(8, ' ');
  std::ifstream(odd / "deformed.png", std::ios::binary).read(start.data(), 8);
  CHECK(start == "\x89PNG\r\n\x1a\n");
  CHECK(std::filesystem::file_size(odd / "deformed.png") > 20000);
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
