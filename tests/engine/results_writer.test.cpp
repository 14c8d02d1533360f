#include "shoreline/engine/results_writer.hpp"

#include <hdf5.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>

#include "output_folder.hpp"
#include "results_files.hpp"
#include "shoreline/bases/mesh_generators.hpp"
#include "shoreline/bases/powell_sabin.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::Dataset;
using test::OutputFolder;
using test::read;
using test::text_attribute;
using test::text_of;

namespace {

const QuadrilateralGrid grid(Vec2(0, 0), Vec2(0.5, 0.5), {2, 3});

/// Material points and what else is saved of a step.
struct Step {
  MaterialPoints points;
  SavedStep saved;
};

void write(ResultsWriter&& writer, const Step& step) { writer.write(step.saved, step.points); }
void write(ResultsWriter& writer, const Step& step) { writer.write(step.saved, step.points); }

/// Different numbers everywhere, so that a wrong order shows.
Step step(int number, Eigen::Index points = 3, const std::string& curve = "edge") {
  const auto counted = [&](Eigen::Index rows, Eigen::Index columns, double first) {
    Eigen::MatrixXd m(rows, columns);
    for (Eigen::Index i = 0; i < m.size(); ++i) m(i % rows, i / rows) = first + static_cast<double>(i) + 100.0 * number;
    return m;
  };
  return {.points = {.position = counted(2, points, 0.25),
                     .displacement = counted(2, points, 1000.25),
                     .volume = counted(1, points, 4000.25).transpose(),
                     .stress = counted(4, points, 2000.25),
                     .strain = counted(3, points, 3000.25),
                     .on_outline = {}},
          .saved = {
              .step = number, .t = 0.5 * number, .curves = {{curve, counted(2, 2, 5000.25), counted(2, 5, 6000.25)}}}};
}

/// The attribute "name" of every group in @p path.
std::vector<std::string> names_in(const std::filesystem::path& folder, const std::string& path) {
  std::vector<std::string> names;
  const auto append_name = [](hid_t group, const char* link, const H5L_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->push_back(text_attribute(group, link, "name"));
    return 0;
  };
  const hid_t file = H5Fopen((folder / "results.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t group = H5Gopen2(file, path.c_str(), H5P_DEFAULT);
  H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, append_name, &names);
  H5Gclose(group);
  H5Fclose(file);
  return names;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("what is read from results.h5 is what was saved, one row a point", "[engine][results]") {
  const OutputFolder folder;
  const Step saved = step(7);
  write(ResultsWriter(folder.path, "title", grid), saved);

  const Dataset stress = read(folder.path, "steps/000007/points/stress");
  CHECK(stress.shape == std::vector<hsize_t>{3, 4});
  CHECK(stress.values == std::vector<double>(saved.points.stress.data(), saved.points.stress.data() + 12));
  CHECK(stress.unit == "Pa");
  const Dataset strain = read(folder.path, "steps/000007/points/strain");
  CHECK(strain.values == std::vector<double>(saved.points.strain.data(), saved.points.strain.data() + 9));
  const Dataset volume = read(folder.path, "steps/000007/points/volume");
  CHECK(volume.shape == std::vector<hsize_t>{3});
  CHECK(volume.values == std::vector<double>(saved.points.volume.data(), saved.points.volume.data() + 3));

  const auto check_in_space = [&](const std::string& path, const Eigen::Matrix2Xd& plane) {
    const Dataset space = read(folder.path, "steps/000007/" + path);
    Eigen::Matrix3Xd expected = Eigen::Matrix3Xd::Zero(3, plane.cols());
    expected.topRows<2>() = plane;
    CHECK(space.shape == std::vector<hsize_t>{static_cast<hsize_t>(plane.cols()), 3});
    CHECK(space.values == std::vector<double>(expected.data(), expected.data() + expected.size()));
    CHECK(space.unit == "m");
  };
  check_in_space("points/position", saved.points.position);
  check_in_space("points/displacement", saved.points.displacement);
  check_in_space("curves/edge/points", saved.saved.curves[0].points);
  check_in_space("curves/edge/polyline", saved.saved.curves[0].polyline);
  CHECK(read(folder.path, "grid/edges").shape == std::vector<hsize_t>{24, 4});
}

TEST_CASE("the history of probes grows by what is new, whatever steps are saved", "[engine][results]") {
  const OutputFolder folder;
  const auto state = [](double k, bool stressed) {
    ProbeState at{.t = k / 600.0, .position = Vec2(k, -k), .displacement = Vec2(2.0 * k, 3.0 * k), .stress = {}};
    if (stressed) at.stress = Stress(k, k + 0.25, k + 0.5, k + 0.75);
    return at;
  };
  std::vector<Probe> probes{{"left|1", std::nullopt, 0, {state(0, true)}},
                            {"tip", 1, 2, {state(0, false)}},
                            {"there", std::nullopt, 0, {state(0, true)}, false, true}};
  ResultsWriter writer(folder.path, "title", grid);
  writer.append(probes);
  for (int k = 1; k <= 600; ++k) {
    probes[0].history.push_back(state(k, true));
    probes[1].history.push_back(state(k, false));
    probes[2].history.push_back(state(k, true));
    if (k % 7 == 0 || k == 600) writer.append(probes);
  }
  writer.append(probes);

  const Dataset time = read(folder.path, "probes/left%7C1/t");
  CHECK(time.shape == std::vector<hsize_t>{601});
  const Dataset stress = read(folder.path, "probes/left%7C1/stress");
  CHECK(stress.shape == std::vector<hsize_t>{601, 4});
  CHECK(stress.unit == "Pa");
  const Dataset displacement = read(folder.path, "probes/tip/displacement");
  CHECK(displacement.shape == std::vector<hsize_t>{601, 2});
  CHECK(displacement.unit == "m");
  const Dataset position = read(folder.path, "probes/tip/position");
  for (std::size_t k = 0; k <= 600; ++k) {
    const auto number = static_cast<double>(k);
    CHECK(time.values[k] == number / 600.0);
    CHECK(stress.values[4 * k + 3] == number + 0.75);
    CHECK(position.values[2 * k + 1] == -number);
    CHECK(displacement.values[2 * k] == 2.0 * number);
  }
  CHECK(names_in(folder.path, "probes") == std::vector<std::string>{"left|1", "there", "tip"});
  const hid_t file = H5Fopen((folder.path / "results.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  CHECK(H5Lexists(file, "probes/tip/stress", H5P_DEFAULT) == 0);
  CHECK(text_attribute(file, "probes/left%7C1", "on") == "material point");
  CHECK(text_attribute(file, "probes/tip", "on") == "tracking point");
  CHECK(text_attribute(file, "probes/there", "on") == "place");
  H5Fclose(file);
}

TEST_CASE("without probes nothing is built for them", "[engine][results]") {
  const OutputFolder folder;
  ResultsWriter(folder.path, "title", grid).append(std::vector<Probe>{});
  const hid_t file = H5Fopen((folder.path / "results.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  CHECK(H5Lexists(file, "probes", H5P_DEFAULT) == 0);
  H5Fclose(file);
}

TEST_CASE("a run that is killed leaves every finished step readable", "[engine][results]") {
  const OutputFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    ResultsWriter writer(folder.path, "title", grid);
    write(writer, step(0));
    write(writer, step(1));
    raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  REQUIRE(WIFSIGNALED(status));
  for (const int number : {0, 1})
    CHECK(read(folder.path, "steps/00000" + std::to_string(number) + "/points/volume").values[0] ==
          step(number).points.volume[0]);
  CHECK_THAT(text_of(folder.path / "results.xdmf"), Contains("/steps/000001/points/stress"));
}

TEST_CASE("a disk that fills up costs no step that was saved before", "[engine][results]") {
  const OutputFolder folder;
  ResultsWriter writer(folder.path, "title", grid);
  write(writer, step(0));

  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit full{.rlim_cur = std::filesystem::file_size(folder.path / "results.h5") + 4096,
                    .rlim_max = before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  CHECK_THROWS_WITH(write(writer, step(1)), Contains("results.h5") && Contains("File too large"));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);

  CHECK(read(folder.path, "steps/000000/points/volume").values[0] == step(0).points.volume[0]);
  write(writer, step(1));
  CHECK(read(folder.path, "steps/000001/points/volume").values[0] == step(1).points.volume[0]);
}

TEST_CASE("every array that results.xdmf names exists with the shape it says", "[engine][results]") {
  const OutputFolder folder;
  const std::string name = GENERATE("edge", "left/upper", "ß 10 % \"a\" <b> & c", ".", "", "a:b|c");
  CAPTURE(name);
  {
    ResultsWriter writer(folder.path, "title", grid);
    write(writer, step(0, 3, name));
    write(writer, step(1, 4, name));
  }
  const std::string xdmf = text_of(folder.path / "results.xdmf");
  CHECK(count(xdmf, "<Time Value=\"0.5\"/>") == 2);
  for (std::size_t at = xdmf.find('&'); at != std::string::npos; at = xdmf.find('&', at + 1)) {
    const std::string entity = xdmf.substr(at, xdmf.find(';', at) - at + 1);
    CHECK((entity == "&lt;" || entity == "&gt;" || entity == "&quot;" || entity == "&amp;"));
  }
  CHECK(names_in(folder.path, "steps/000001/curves") == std::vector<std::string>{name});

  CHECK(test::check_shapes(folder.path) == 2 * (6 + 2));
}

TEST_CASE("a projected field is read as it was saved, and results.xdmf names its arrays", "[engine][results]") {
  const OutputFolder folder;
  SampledField field{.position = Eigen::Matrix2Xd(2, 4), .value = Eigen::Vector4d(1, 2, 3, 4), .triangle = {}};
  field.position << 0, 1, 1, 0, 0, 0, 1, 1;
  field.triangle = (Eigen::Matrix3Xi(3, 2) << 0, 0, 1, 2, 2, 3).finished();
  ResultsWriter(folder.path, "title", grid).write(field);
  CHECK(test::check_shapes(folder.path) == 3);
  field.error = Eigen::Vector4d(0.5, 0, 0, -0.5);
  ResultsWriter(folder.path, "title", grid).write(field);
  CHECK(test::check_shapes(folder.path) == 4);
  CHECK(read(folder.path, "field/value").values == std::vector<double>{1, 2, 3, 4});
  CHECK(read(folder.path, "field/error").values == std::vector<double>{0.5, 0, 0, -0.5});
  CHECK(read(folder.path, "field/position").values == std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  CHECK(read(folder.path, "connectivity/triangles").values == std::vector<double>{0, 1, 2, 0, 2, 3});
}

TEST_CASE("the parts of a Powell-Sabin triangle are not drawn", "[engine][results]") {
  const OutputFolder folder;
  const PowellSabinBasis basis(triangulate(grid, TrianglePattern::diagonal));
  const ResultsWriter writer(folder.path, "title", basis.grid());
  const Dataset edges = read(folder.path, "grid/edges");
  CHECK(edges.shape == std::vector<hsize_t>{12 * 6, 4});  // two halves a side of 12 triangles
  double length = 0.0;
  for (std::size_t e = 0; e < edges.values.size(); e += 4)
    length += std::hypot(edges.values[e + 2] - edges.values[e], edges.values[e + 3] - edges.values[e + 1]);
  CHECK(length == Approx(12 * (1.0 + std::sqrt(0.5))));
}

TEST_CASE("results.xdmf knows every step once the writer is gone", "[engine][results]") {
  const OutputFolder folder;
  const int steps = 120;
  {
    ResultsWriter writer(folder.path, "title", grid);
    for (int k = 0; k < steps; ++k) write(writer, step(k, 1));
    CHECK(count(text_of(folder.path / "results.xdmf"), "points/stress") >= steps * 98 / 100);
  }
  CHECK(count(text_of(folder.path / "results.xdmf"), "points/stress") == steps);
}

TEST_CASE("a new run removes the results of the old one", "[engine][results]") {
  const OutputFolder folder;
  for (const char* name :
       {"summary.json", "results.xdmf", "deformed.png", "field.png", "history.png", "error_estimate.png"})
    std::ofstream(folder.path / name) << "old";
  write(ResultsWriter(folder.path, "old", grid), step(3));
  const ResultsWriter writer(folder.path, "new", grid);
  CHECK_FALSE(std::filesystem::exists(folder.path / "summary.json"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "deformed.png"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "field.png"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "history.png"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "results.xdmf"));
  const hid_t file = H5Fopen((folder.path / "results.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  CHECK(H5Lexists(file, "steps/000003", H5P_DEFAULT) == 0);
  H5Fclose(file);
}

TEST_CASE("results that cannot be written name the path and the reason", "[engine][results]") {
  const OutputFolder folder;
  std::ofstream(folder.path / "file") << "not a folder";
  const std::filesystem::path below_a_file = folder.path / "file" / "out";
  CHECK_THROWS_AS(ResultsWriter(below_a_file, "title", grid), OutputError);
  CHECK_THROWS_WITH(ResultsWriter(below_a_file, "title", grid),
                    Contains(below_a_file.string()) && Contains("Not a directory"));

  std::filesystem::create_directory(folder.path / "results.h5");
  CHECK_THROWS_WITH(ResultsWriter(folder.path, "title", grid), Contains("results.h5") && Contains("Is a directory"));

  const OutputFolder vanished;
  ResultsWriter writer(vanished.path, "title", grid);
  std::filesystem::remove(vanished.path / "results.h5");
  CHECK_THROWS_WITH(write(writer, step(0)), Contains("results.h5") && Contains("No such file"));
}
