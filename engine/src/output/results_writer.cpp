#include "shoreline/engine/results_writer.hpp"

#include <algorithm>
#include <cassert>
#include <functional>
#include <span>
#include <system_error>

#include "atomic_file.hpp"
#include "hdf5_file.hpp"
#include "shoreline/engine/failures.hpp"
#include "xdmf.hpp"

namespace shoreline {
namespace {

constexpr Index most_drawn_cells = 10000;

Eigen::Matrix3Xd in_space(const Eigen::Matrix2Xd& plane) {
  Eigen::Matrix3Xd space = Eigen::Matrix3Xd::Zero(3, plane.cols());
  space.topRows<2>() = plane;
  return space;
}

/// (4, edges) both ends of the edges of all cells, or main triangles; those that two share are there twice.
Eigen::Matrix4Xd edges(const Grid& grid) {
  std::vector<Eigen::Vector4d> found;
  for (Index cell = 0; cell < grid.cells(); ++cell) {
    const std::vector<Vec2> corner = grid.polygon(cell);
    const std::vector<Face> faces = grid.parts() > 1 ? grid.faces(cell) : std::vector<Face>{};
    for (std::size_t i = 0; i < corner.size(); ++i) {
      const auto inside = [&](const Face& f) {
        return f.a == corner[i] && f.neighbour / grid.parts() == cell / grid.parts();
      };
      if (std::ranges::any_of(faces, inside)) continue;
      const Vec2& next = corner[(i + 1) % corner.size()];
      found.emplace_back(corner[i].x(), corner[i].y(), next.x(), next.y());
    }
  }
  return Eigen::Map<const Eigen::Matrix4Xd>(found.data()->data(), 4, static_cast<Eigen::Index>(found.size()));
}

void remove_old(const std::filesystem::path& folder) {
  for (const char* name :
       {"summary.json", "results.xdmf", "deformed.png", "field.png", "history.png", "error_estimate.png"}) {
    std::error_code problem;
    std::filesystem::remove(folder / name, problem);
    if (problem) throw OutputError((folder / name).string() + ": cannot remove: " + problem.message());
  }
}

void write_cells(Hdf5File& file, const std::string& path, Eigen::Index points, bool in_one_line) {
  if (file.contains(path)) return;
  const Eigen::MatrixXi numbers = Eigen::RowVectorXi::LinSpaced(points, 0, static_cast<int>(points - 1));
  file.write_table(path, in_one_line ? Eigen::MatrixXi(numbers.transpose()) : numbers);
}

void write_points(Hdf5File& file, const SavedStep& step, const MaterialPoints& points) {
  const std::string group = step_group(step) + "/points/";
  file.write_rows(group + "position", in_space(points.position), "m");
  file.write_rows(group + "displacement", in_space(points.displacement), "m");
  file.write_rows(group + "stress", points.stress, "Pa");
  file.set_attribute(group + "stress", "components", "xx yy xy zz");
  if (saves_strain(step, points)) {
    file.write_rows(group + "strain", step.strain ? *step.strain : points.strain, "1");
    file.set_attribute(group + "strain", "components", "xx yy xy (engineering)");
  }
  file.write_numbers(group + "volume", points.volume, "m^2");
  if (step.stress_error_estimate)
    file.write_numbers(group + "stress_error_estimate", *step.stress_error_estimate, "Pa");
  if (step.velocity) file.write_rows(group + "velocity", in_space(*step.velocity), "m/s");
  write_cells(file, vertices_table(points.size()), points.size(), false);
}

void write_curve(Hdf5File& file, const std::string& group, const SavedStep::Curve& curve) {
  file.make_group(group);
  file.set_attribute(group, "name", curve.name);
  file.write_rows(group + "/points", in_space(curve.points), "m");
  file.write_rows(group + "/polyline", in_space(curve.polyline), "m");
  write_cells(file, line_table(curve.polyline.cols()), curve.polyline.cols(), true);
}

std::span<const double> numbers(const double& number) { return {&number, 1}; }

template <int n>
std::span<const double> numbers(const Eigen::Matrix<double, n, 1>& vector) {
  return {vector.data(), static_cast<std::size_t>(n)};
}

template <class Vector>
std::span<const double> numbers(const std::optional<Vector>& vector) {
  return vector ? numbers(*vector) : std::span<const double>();
}

/// Appends one row a state, what @p of gives of it; nothing where that is missing.
template <class State, class Of>
void append_each(Hdf5File& file, const std::string& path, const std::string& unit, std::span<const State> states,
                 Of of) {
  const std::size_t width = numbers(std::invoke(of, states.front())).size();
  if (width == 0) return;
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(width), static_cast<Eigen::Index>(states.size()));
  for (std::size_t k = 0; k < states.size(); ++k) {
    const auto& value = std::invoke(of, states[k]);
    assert(numbers(value).size() == width);
    std::ranges::copy(numbers(value), columns.col(static_cast<Eigen::Index>(k)).begin());
  }
  file.append_rows(path, columns, unit);
}

/// @param states  of the probe that are new, at least one
void append_states(Hdf5File& file, const Probe& probe, std::span<const ProbeState> states,
                   const std::string& unit_of_time) {
  const std::string group = "/probes/" + link_name(probe.name);
  if (!file.contains("/probes") || !file.contains(group)) {
    file.make_group(group);
    file.set_attribute(group, "name", probe.name);
    file.set_attribute(group, "on", followed_by(probe));
  }
  append_each(file, group + "/t", unit_of_time, states, &ProbeState::t);
  append_each(file, group + "/position", "m", states, &ProbeState::position);
  append_each(file, group + "/displacement", "m", states, &ProbeState::displacement);
  append_each(file, group + "/stress", "Pa", states, &ProbeState::stress);
  append_each(file, group + "/velocity", "m/s", states, &ProbeState::velocity);
  append_each(file, group + "/exact_displacement", "m", states, &ProbeState::exact_displacement);
  append_each(file, group + "/exact_velocity", "m/s", states, &ProbeState::exact_velocity);
}

/// At least what @p rows more rows of @p width numbers take in arrays that grow, with new pages and HDF5's own records.
std::uintmax_t bytes_of(std::size_t rows, std::size_t width) { return 65536 + rows * (width + 1) * sizeof(double); }

/// At least what a step takes in the file, with HDF5's own records.
std::uintmax_t bytes_of(const SavedStep& step, const MaterialPoints& points) {
  const Eigen::Index of_point =
      12 + (saves_strain(step, points) ? 3 : 0) + (step.velocity ? 3 : 0) + (step.stress_error_estimate ? 1 : 0);
  Eigen::Index numbers = of_point * points.size();
  for (const SavedStep::Curve& curve : step.curves) numbers += 3 * curve.points.cols() + 4 * curve.polyline.cols();
  const std::size_t records = 65536 + 8192 * step.curves.size();
  return static_cast<std::uintmax_t>(numbers) * sizeof(double) + records;
}

}  // namespace

ResultsWriter::ResultsWriter(std::filesystem::path folder, const std::string& title, const Grid& grid,
                             const std::string& analysis)
    : folder_(std::move(folder)), unit_of_time_(analysis == "explicit_dynamics" ? "s" : "1") {
  make_folder(folder_);
  remove_old(folder_);
  Hdf5File file(folder_ / "results.h5", Hdf5File::Mode::create);
  file.set_attribute("/", "title", title);
  file.set_attribute("/", "analysis", analysis);
  file.make_group("/steps");
  file.make_group("/connectivity");
  if (grid.cells() / grid.parts() <= most_drawn_cells) file.write_rows("/grid/edges", edges(grid), "m");
  file.close();
}

ResultsWriter::~ResultsWriter() {
  try {
    if (indexed_ < saved_) write_index();
  } catch (const OutputError&) {  // results.h5 is complete; the index lacks the last 2 % of its steps
  }
}

void ResultsWriter::write(const SavedStep& step, const MaterialPoints& points) {
  reserve(folder_ / "results.h5", bytes_of(step, points));
  Hdf5File file(folder_ / "results.h5", Hdf5File::Mode::append);
  file.make_group(step_group(step));
  file.set_attribute(step_group(step), "step", step.step);
  file.set_attribute(step_group(step), "t", step.t);
  write_points(file, step, points);
  for (const SavedStep::Curve& curve : step.curves)
    write_curve(file, step_group(step) + "/curves/" + link_name(curve.name), curve);
  file.close();

  point_grids_ += point_grid(step, points);
  curve_grids_ += curve_grid(step);
  ++saved_;
  if (saved_ > indexed_ + indexed_ / 50) write_index();
}

void ResultsWriter::write(const SampledField& field) {
  const auto numbers = 6 * field.value.size() + 3 * field.triangle.cols();
  reserve(folder_ / "results.h5", static_cast<std::uintmax_t>(numbers) * sizeof(double) + 65536);
  Hdf5File file(folder_ / "results.h5", Hdf5File::Mode::append);
  file.write_rows("/field/position", in_space(field.position), "m");
  file.write_numbers("/field/value", field.value, "1");
  if (field.error) file.write_numbers("/field/error", *field.error, "1");
  file.write_table(triangle_table(), field.triangle);
  file.close();
  write_atomically(folder_ / "results.xdmf", xdmf(field));
}

void ResultsWriter::append(const std::vector<Probe>& probes) {
  const std::size_t states = probes.empty() ? 0 : probes.front().history.size();
  if (recorded_ == states) return;
  constexpr std::size_t numbers_a_state = 15;
  reserve(folder_ / "results.h5", probes.size() * bytes_of(states - recorded_, numbers_a_state));
  Hdf5File file(folder_ / "results.h5", Hdf5File::Mode::append);
  for (const Probe& probe : probes)
    append_states(file, probe, std::span(probe.history).subspan(recorded_), unit_of_time_);
  file.close();
  recorded_ = states;
}

void ResultsWriter::append(const std::vector<HistoryState>& history) {
  const auto states = std::span(history).subspan(energies_);
  if (states.empty()) return;
  constexpr std::size_t numbers_a_state = 7;
  reserve(folder_ / "results.h5", bytes_of(states.size(), numbers_a_state));
  Hdf5File file(folder_ / "results.h5", Hdf5File::Mode::append);
  append_each(file, "/history/t", unit_of_time_, states, &HistoryState::t);
  append_each(file, "/history/kinetic", "J/m", states, &HistoryState::kinetic);
  append_each(file, "/history/strain", "J/m", states, &HistoryState::strain);
  append_each(file, "/history/gravity", "J/m", states, &HistoryState::gravity);
  append_each(file, "/history/total", "J/m", states, &HistoryState::total);
  append_each(file, "/history/momentum", "N s/m", states, &HistoryState::momentum);
  file.close();
  energies_ = history.size();
}

void ResultsWriter::write_index() {
  write_atomically(folder_ / "results.xdmf", xdmf(curve_grids_, point_grids_));
  indexed_ = saved_;
}

}  // namespace shoreline
