// What results.h5 holds of a dynamic run beside its steps.

#include <catch2/catch.hpp>
#include <chrono>

#include "output_folder.hpp"
#include "results_files.hpp"
#include "shoreline/bases/quadrilateral_grid.hpp"
#include "shoreline/engine/results_writer.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using test::Dataset;
using test::OutputFolder;
using test::read;

namespace {

const QuadrilateralGrid grid(Vec2(0, 0), Vec2(0.5, 0.5), {2, 3});

const MaterialPoints point{.position = Vec2(1, 2),
                           .displacement = Vec2(3, 4),
                           .volume = Eigen::VectorXd::Constant(1, 12.0),
                           .stress = Eigen::Vector4d(5, 6, 7, 8),
                           .strain = Vec3(9, 10, 11),
                           .on_outline = {}};

/// One point that moves.
SavedStep moving_point(int number) {
  return {.step = number, .t = 0.5 * number, .curves = {}, .velocity = Vec2(13.0 + number, -14.0)};
}

/// Different numbers everywhere.
ProbeState probe_state(int k, bool exact) {
  ProbeState state{.t = 0.25 * k, .position = Vec2(k, 1), .displacement = Vec2(2, k), .stress = {}};
  state.velocity = Vec2(k + 0.25, -k);
  if (!exact) return state;
  state.exact_displacement = Vec2(k + 0.5, -2.0 * k);
  state.exact_velocity = Vec2(k + 0.75, -3.0 * k);
  return state;
}

HistoryState history_state(int k) {
  return {.t = 0.25 * k, .kinetic = 1.0 + k, .strain = 10.0 * k, .gravity = -100.0 * k, .momentum = Vec2(k, 0.5 * k)};
}

bool contains(const std::filesystem::path& folder, const std::string& path) {
  const hid_t file = H5Fopen((folder / "results.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const bool found = H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
  H5Fclose(file);
  return found;
}

std::string analysis_in(const std::filesystem::path& folder) {
  const hid_t file = H5Fopen((folder / "results.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const std::string analysis = test::text_attribute(file, "/", "analysis");
  H5Fclose(file);
  return analysis;
}

}  // namespace

TEST_CASE("velocities are saved where there are any, for programs and for viewers", "[engine][results]") {
  const OutputFolder folder;
  {
    ResultsWriter writer(folder.path, "title", grid, "explicit_dynamics");
    writer.write(moving_point(0), point);
    writer.write(moving_point(1), point);
  }
  const Dataset velocity = read(folder.path, "steps/000001/points/velocity");
  CHECK(velocity.shape == std::vector<hsize_t>{1, 3});
  CHECK(velocity.values == std::vector<double>{14.0, -14.0, 0.0});
  CHECK(velocity.unit == "m/s");
  CHECK(test::check_shapes(folder.path) == 2 * 7);
  CHECK_THAT(test::text_of(folder.path / "results.xdmf"), Contains("steps/000001/points/velocity"));

  SavedStep at_rest = moving_point(2);
  at_rest.velocity.reset();
  ResultsWriter(folder.path, "title", grid).write(at_rest, point);
  CHECK_FALSE(contains(folder.path, "steps/000002/points/velocity"));
  CHECK(test::check_shapes(folder.path) == 6);
}

TEST_CASE("results say which analysis they are of", "[engine][results]") {
  const OutputFolder folder;
  { const ResultsWriter writer(folder.path, "title", grid, "explicit_dynamics"); }
  CHECK(analysis_in(folder.path) == "explicit_dynamics");
  { const ResultsWriter writer(folder.path, "title", grid); }
  CHECK(analysis_in(folder.path) == "quasi_static");
}

TEST_CASE("a probe's velocity and exact motion are read as they were saved, in portions of any size",
          "[engine][results]") {
  const OutputFolder folder;
  std::vector<Probe> probes{{"tip", std::nullopt, 0, {}}, {"base", 1, 2, {}}};
  ResultsWriter writer(folder.path, "title", grid, "explicit_dynamics");
  for (const int until : {1, 2, 500, 500, 2000}) {
    for (int k = static_cast<int>(probes[0].history.size()); k < until; ++k) {
      probes[0].history.push_back(probe_state(k, true));
      probes[1].history.push_back(probe_state(k, false));
    }
    writer.append(probes);
  }
  const Dataset t = read(folder.path, "probes/tip/t");
  CHECK(t.shape == std::vector<hsize_t>{2000});
  CHECK(t.unit == "s");
  const Dataset velocity = read(folder.path, "probes/base/velocity");
  CHECK(velocity.shape == std::vector<hsize_t>{2000, 2});
  CHECK(velocity.unit == "m/s");
  const Dataset displacement = read(folder.path, "probes/tip/exact_displacement");
  CHECK(displacement.unit == "m");
  const Dataset exact_velocity = read(folder.path, "probes/tip/exact_velocity");
  CHECK(exact_velocity.unit == "m/s");
  for (int k = 0; k < 2000; ++k) {
    const ProbeState expected = probe_state(k, true);
    const auto row = static_cast<std::size_t>(k);
    CHECK(t.values[row] == expected.t);
    for (const int c : {0, 1}) {
      const std::size_t at = 2 * row + static_cast<std::size_t>(c);
      CHECK(velocity.values[at] == (*expected.velocity)[c]);
      CHECK(displacement.values[at] == (*expected.exact_displacement)[c]);
      CHECK(exact_velocity.values[at] == (*expected.exact_velocity)[c]);
    }
  }
  CHECK_FALSE(contains(folder.path, "probes/base/exact_displacement"));
  CHECK_FALSE(contains(folder.path, "probes/base/exact_velocity"));
}

TEST_CASE("energies and momentum grow by what is new, and the total is their sum", "[engine][results]") {
  const OutputFolder folder;
  ResultsWriter writer(folder.path, "title", grid, "explicit_dynamics");
  writer.append(std::vector<HistoryState>{});
  CHECK_FALSE(contains(folder.path, "history"));
  std::vector<HistoryState> history;
  for (const std::size_t until : {1u, 700u, 700u, 1000u}) {
    while (history.size() < until) history.push_back(history_state(static_cast<int>(history.size())));
    writer.append(history);
  }
  const Dataset momentum = read(folder.path, "history/momentum");
  CHECK(momentum.shape == std::vector<hsize_t>{1000, 2});
  CHECK(momentum.unit == "N s/m");
  CHECK(read(folder.path, "history/t").unit == "s");
  const auto number = [&](const char* name, std::size_t k) {
    const Dataset set = read(folder.path, std::string("history/") + name);
    CHECK(set.shape == std::vector<hsize_t>{1000});
    return set.values[k];
  };
  for (const std::size_t k : {0u, 1u, 699u, 700u, 999u}) {
    const HistoryState& expected = history[k];
    CHECK(number("t", k) == expected.t);
    CHECK(number("kinetic", k) == expected.kinetic);
    CHECK(number("strain", k) == expected.strain);
    CHECK(number("gravity", k) == expected.gravity);
    CHECK(number("total", k) == expected.kinetic + expected.strain + expected.gravity);
    CHECK(momentum.values[2 * k] == expected.momentum.x());
    CHECK(momentum.values[2 * k + 1] == expected.momentum.y());
  }
  for (const char* name : {"kinetic", "strain", "gravity", "total"})
    CHECK(read(folder.path, std::string("history/") + name).unit == "J/m");
}

TEST_CASE("five thousand states of two probes are appended within half a second", "[engine][results]") {
  const OutputFolder folder;
  std::vector<Probe> probes{{"tip", std::nullopt, 0, {}}, {"base", 1, 2, {}}};
  for (int k = 0; k < 5000; ++k)
    for (Probe& probe : probes) probe.history.push_back(probe_state(k, true));
  ResultsWriter writer(folder.path, "title", grid, "explicit_dynamics");
  const auto start = std::chrono::steady_clock::now();
  writer.append(probes);
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 0.5);
  CHECK(read(folder.path, "probes/base/velocity").values.back() == -4999.0);
}
