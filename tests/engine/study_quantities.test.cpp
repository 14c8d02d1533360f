// What runs are compared by, engine/src/study/quantities.hpp and engine/src/output/results_reader.hpp.

#include <catch2/catch.hpp>
#include <limits>

#include "output/results_reader.hpp"
#include "output_folder.hpp"
#include "shoreline/bases/mesh_generators.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/results_writer.hpp"
#include "study/quantities.hpp"

using namespace shoreline;
using test::OutputFolder;

namespace {

/// A step whose curves, one a name, have moved by (0.1, 0.2) a step, point k by k times as much.
SavedStep moved(int step, const std::map<std::string, Eigen::Index>& curves) {
  SavedStep saved{.step = step, .t = 0.5 * step, .curves = {}};
  for (const auto& [name, points] : curves) {
    Eigen::Matrix2Xd line(2, points);
    for (Eigen::Index k = 0; k < points; ++k)
      line.col(k) = Vec2(7.0, static_cast<double>(k)) + static_cast<double>(step * k) * Vec2(0.1, 0.2);
    saved.curves.push_back({name, line.leftCols(1), line});
  }
  return saved;
}

void write(const std::filesystem::path& folder, const std::vector<SavedStep>& steps) {
  const QuadrilateralGrid grid(Vec2(0, 0), Vec2(0.5, 0.5), {2, 3});
  ResultsWriter writer(folder, "title", grid);
  for (const SavedStep& step : steps) writer.write(step, points_at(Vec2::Zero(), Eigen::VectorXd::Ones(1)));
}

}  // namespace

TEST_CASE("curves of results.h5 have moved from the first to the last saved step", "[engine][study]") {
  const OutputFolder folder;
  write(folder.path, {moved(0, {{"edge", 4}, {"hole", 3}}), moved(5, {{"edge", 4}, {"hole", 3}}),
                      moved(12, {{"edge", 4}, {"hole", 3}})});
  const auto displacements = curve_displacements(folder.path / "results.h5");
  REQUIRE(displacements.size() == 2);
  const Eigen::Matrix2Xd& edge = displacements.at("edge");
  REQUIRE(edge.cols() == 4);
  for (Eigen::Index k = 0; k < 4; ++k)
    CHECK((edge.col(k) - static_cast<double>(12 * k) * Vec2(0.1, 0.2)).norm() < 1e-13);
  CHECK(displacements.at("hole").cols() == 3);
}

TEST_CASE("a curve that was given other points on the way has no displacement", "[engine][study]") {
  const OutputFolder folder;
  write(folder.path, {moved(0, {{"edge", 4}, {"hole", 3}}), moved(1, {{"edge", 6}, {"hole", 3}})});
  const auto displacements = curve_displacements(folder.path / "results.h5");
  CHECK(displacements.count("edge") == 0);
  CHECK(displacements.count("hole") == 1);
}

TEST_CASE("results without steps or curves have no displacements, and none at all are told", "[engine][study]") {
  const OutputFolder folder;
  CHECK_THROWS_AS(curve_displacements(folder.path / "results.h5"), OutputError);
  write(folder.path, {});
  CHECK(curve_displacements(folder.path / "results.h5").empty());
  write(folder.path, {moved(0, {}), moved(1, {})});
  CHECK(curve_displacements(folder.path / "results.h5").empty());
}

TEST_CASE("norms are the numbers of the summary's errors by their dotted names", "[engine][study]") {
  const Json summary = {{"material_points", 12},
                        {"errors",
                         {{"measured_at", "sample points"},
                          {"points", 400},
                          {"displacement", {{"l2", 0.5}, {"l2_relative", nullptr}, {"mean_relative", {1.5, nullptr}}}},
                          {"boundary", {{"hole", {{"radius", {{"mean", 2}}}}}}}}},
                        {"error_estimate", {{"stress", {{"l2", 0.25}}}}}};
  CHECK(norms_of(summary) == std::map<std::string, double>{{"displacement.l2", 0.5},
                                                           {"displacement.mean_relative.0", 1.5},
                                                           {"boundary.hole.radius.mean", 2.0},
                                                           {"error_estimate.stress.l2", 0.25}});
  CHECK(norms_of(Json::object()).empty());
  CHECK(norms_of(Json()).empty());
}

TEST_CASE("quantities are the vectors of a summary and the displacements of its curves", "[engine][study]") {
  const OutputFolder folder;
  write(folder.path, {moved(0, {{"edge", 2}}), moved(1, {{"edge", 2}})});
  const Json summary = {
      {"strain_energy", 3.5},
      {"reactions", {{"top", {1.0, 2.0, 9.0}}}},
      {"probes",
       {{"tip", {{"displacement", {0.5, 0.25}}, {"stress", {1, 2, 3, 4}}}}, {"mark", {{"displacement", {0.1, 0.2}}}}}}};
  const Json found = quantities_of(summary, folder.path);
  CHECK(found["energy"] == Json::array({3.5}));
  CHECK(found["reaction.top"] == Json::array({1.0, 2.0}));  // no moment, which hangs on where it is taken
  CHECK(found["probe.tip.displacement"] == Json::array({0.5, 0.25}));
  CHECK(found["probe.tip.stress"] == Json::array({1, 2, 3, 4}));
  CHECK(found["probe.mark.displacement"] == Json::array({0.1, 0.2}));
  CHECK_FALSE(found.contains("probe.mark.stress"));
  REQUIRE(found["curve.edge"].size() == 4);
  const std::vector<double> expected{0.0, 0.0, 0.1, 0.2};
  for (std::size_t k = 0; k < 4; ++k) CHECK(found["curve.edge"][k].get<double>() == Approx(expected[k]).margin(1e-13));
  CHECK(found.size() == 6);
  CHECK(quantities_of({{"energy", {{"end", {{"total", 8.0}}}}}}, folder.path)["energy"] == Json::array({8.0}));
}
