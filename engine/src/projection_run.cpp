#include "projection_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "body.hpp"
#include "make_basis.hpp"
#include "shoreline/engine/clock.hpp"
#include "shoreline/engine/failures.hpp"
#include "shoreline/engine/linear_solver.hpp"
#include "shoreline/engine/pictures.hpp"
#include "shoreline/engine/results_writer.hpp"
#include "shoreline/engine/summary.hpp"

namespace shoreline {
namespace {

/// What is projected, and onto what.
struct Setup {
  std::unique_ptr<const Basis> basis;
  WeightedPoints points;
};

/// Enough for the errors of smooth functions too.
int integration_degree(const Basis& basis) { return 2 * basis.degree() + 4; }

WeightedPoints weighted(const Basis& basis, const MaterialPoints& points) {
  std::vector<Vec2> x;
  for (Eigen::Index p = 0; p < points.size(); ++p) x.emplace_back(points.position.col(p));
  return points_in(basis.grid(), x, {points.volume.data(), static_cast<std::size_t>(points.volume.size())});
}

/// The listed points in the order of their data.
WeightedPoints weighted(const Basis& basis, const std::vector<Case::ListedPoint>& listed) {
  std::vector<Vec2> x;
  std::vector<double> volume;
  for (const Case::ListedPoint& point : listed) {
    x.push_back(point.position);
    volume.push_back(point.volume);
  }
  return points_in(basis.grid(), x, volume);
}

Setup set_up(const Case& problem, const Projection& projection) {
  const auto* listed = std::get_if<std::vector<Case::ListedPoint>>(&problem.material_points);
  if (projection.at_points && listed == nullptr) {
    Body body = build_body(problem);
    WeightedPoints points = weighted(*body.basis, body.points);
    return {std::move(body.basis), std::move(points)};
  }
  Setup setup{basis_of(problem), {}};
  try {
    setup.points = projection.at_points ? weighted(*setup.basis, *listed)
                                        : integration_points(setup.basis->grid(), integration_degree(*setup.basis));
  } catch (const InvalidArgument& error) {
    throw CaseError(problem.file.string(), "/material_points/points", error.what());
  }
  return setup;
}

double at(const Expression& expression, const Vec2& x) { return expression({.x = x, .origin = x}); }

Eigen::VectorXd values_at(const Projection& projection, const WeightedPoints& points) {
  if (const auto* data = std::get_if<std::vector<double>>(&projection.value))
    return Eigen::Map<const Eigen::VectorXd>(data->data(), static_cast<Eigen::Index>(data->size()));
  Eigen::VectorXd value(static_cast<Eigen::Index>(points.x.size()));
  for (Eigen::Index p = 0; p < value.size(); ++p)
    value[p] = at(std::get<Expression>(projection.value), points.x[static_cast<std::size_t>(p)]);
  return value;
}

/// A field's value and gradient.
Eigen::Vector3d field_at(const Basis& basis, const Eigen::VectorXd& coefficient, Index cell, const Vec2& x) {
  const Support support = basis.support(cell, x);
  Eigen::Vector3d field = Eigen::Vector3d::Zero();
  for (Eigen::Index a = 0; a < support.value.size(); ++a)
    field += coefficient[support.function[a]] *
             Eigen::Vector3d(support.value[a], support.gradient(0, a), support.gradient(1, a));
  return field;
}

ProjectionErrors errors_of(const Setup& setup, const Projection& projection, const Eigen::VectorXd& value,
                           const Eigen::VectorXd& coefficient) {
  Eigen::Vector3d square = Eigen::Vector3d::Zero();
  double whole = 0.0;
  for (std::size_t p = 0; p < setup.points.x.size(); ++p) {
    const Vec2& x = setup.points.x[p];
    const double f = value[static_cast<Eigen::Index>(p)];
    Eigen::Vector3d error = field_at(*setup.basis, coefficient, setup.points.cell[p], x) - Eigen::Vector3d(f, 0.0, 0.0);
    if (projection.gradient)
      error -= Eigen::Vector3d(0.0, at((*projection.gradient)[0], x), at((*projection.gradient)[1], x));
    square += setup.points.weight[p] * error.cwiseAbs2();
    whole += setup.points.weight[p] * f * f;
  }
  ProjectionErrors errors{.l2 = std::sqrt(square[0]), .l2_relative = {}, .derivative_l2 = {}};
  if (whole > 0.0) errors.l2_relative = std::sqrt(square[0] / whole);
  if (projection.gradient) errors.derivative_l2 = {std::sqrt(square[1]), std::sqrt(square[2])};
  return errors;
}

/// Cells of elements that hold points: where the field is determined.
std::vector<Index> determined_cells(const Setup& setup) {
  const Index parts = setup.basis->grid().parts();
  std::vector<char> seen(static_cast<std::size_t>(setup.basis->grid().cells() / parts), 0);
  for (const Index cell : setup.points.cell) seen[static_cast<std::size_t>(cell / parts)] = 1;
  std::vector<Index> cells;
  for (Index cell = 0; cell < setup.basis->grid().cells(); ++cell)
    if (seen[static_cast<std::size_t>(cell / parts)] != 0) cells.push_back(cell);
  return cells;
}

Index count_functions(const Basis& basis, const std::vector<Index>& cells) {
  std::vector<char> seen(static_cast<std::size_t>(basis.functions()), 0);
  for (const Index cell : cells)
    for (const Index function : basis.functions_of(cell)) seen[static_cast<std::size_t>(function)] = 1;
  return static_cast<Index>(std::ranges::count(seen, 1));
}

/// Gathers triangles with a field at their corners.
class Sampler {
 public:
  Sampler(const Setup& setup, const Projection& projection, const Eigen::VectorXd& coefficient)
      : setup_(setup), function_(std::get_if<Expression>(&projection.value)), coefficient_(coefficient) {}

  /// Cuts the triangle abc of a cell in n² alike.
  void add(Index cell, const Vec2& a, const Vec2& b, const Vec2& c, int n) {
    const auto first = static_cast<int>(value_.size());
    const auto number = [&](int i, int j) { return first + j * (n + 1) - j * (j - 1) / 2 + i; };
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i + j <= n; ++i) {
        add_corner(cell, a + (i * (b - a) + j * (c - a)) / n, (a + b + c) / 3.0);
        if (i + j < n) triangle_.emplace_back(number(i, j), number(i + 1, j), number(i, j + 1));
        if (i + j + 1 < n) triangle_.emplace_back(number(i + 1, j), number(i + 1, j + 1), number(i, j + 1));
      }
  }

  [[nodiscard]] SampledField field() const {
    const auto n = static_cast<Eigen::Index>(value_.size());
    SampledField field{.position = Eigen::Map<const Eigen::Matrix2Xd>(position_.data()->data(), 2, n),
                       .value = Eigen::Map<const Eigen::VectorXd>(value_.data(), n),
                       .triangle = Eigen::Map<const Eigen::Matrix3Xi>(triangle_.data()->data(), 3,
                                                                      static_cast<Eigen::Index>(triangle_.size()))};
    if (function_ != nullptr) field.error = Eigen::Map<const Eigen::VectorXd>(error_.data(), n);
    return field;
  }

 private:
  /// The function is taken a trifle inside: a formula such as log(x) may have no value on the edge of the grid.
  void add_corner(Index cell, const Vec2& x, const Vec2& centre) {
    constexpr double trifle = 1e-9;
    position_.push_back(x);
    value_.push_back(field_at(*setup_.basis, coefficient_, cell, x)[0]);
    if (function_ != nullptr) error_.push_back(value_.back() - at(*function_, x + trifle * (centre - x)));
  }

  const Setup& setup_;
  const Expression* function_;
  const Eigen::VectorXd& coefficient_;
  std::vector<Vec2> position_;
  std::vector<double> value_;
  std::vector<double> error_;
  std::vector<Eigen::Vector3i> triangle_;
};

SampledField sampled(const Setup& setup, const Projection& projection, const Eigen::VectorXd& coefficient,
                     const std::vector<Index>& cells) {
  constexpr double most = 1e5;  // triangles that show what a picture can show
  const double in_cell = most / static_cast<double>(cells.size());
  const int n = static_cast<int>(std::clamp(std::sqrt(in_cell), 1.0, 8.0));
  Sampler sampler(setup, projection, coefficient);
  for (const Index cell : cells) {
    const std::vector<Vec2> p = setup.basis->grid().polygon(cell);
    for (std::size_t k = 2; k < p.size(); ++k) sampler.add(cell, p[0], p[k - 1], p[k], n);
  }
  return sampler.field();
}

Eigen::VectorXd solve(const Case& problem, const Setup& setup, const Projection& projection,
                      const Eigen::VectorXd& value) {
  try {
    return project(*setup.basis, setup.points, value, projection.mass);
  } catch (const InvalidArgument& error) {
    throw CaseError(problem.file.string(), projection.at_points ? "/material_points" : "/grid", error.what());
  }
}

Summary start(const Case& problem, const Setup& setup, const Projection& projection, int threads) {
  Summary summary;
  summary.title = problem.title;
  summary.analysis = "projection";
  name_basis(problem.grid, summary);
  summary.degrees_of_freedom = count_functions(*setup.basis, determined_cells(setup));
  if (projection.at_points) summary.material_points = static_cast<Index>(setup.points.x.size());
  summary.threads = threads;
  summary.blas = blas_name();
  return summary;
}

}  // namespace

Summary run_projection(const Case& problem, const RunOptions& options, int threads) {
  const auto& projection = std::get<Projection>(problem.analysis);
  Clock phases;
  const auto start_time = std::chrono::steady_clock::now();
  const Setup setup = phases.time("setup", [&] { return set_up(problem, projection); });
  Summary summary = start(problem, setup, projection, threads);
  const auto finish = [&](const std::string& message) {
    summary.message = message;
    summary.timings = {{"total", std::chrono::duration<double>(std::chrono::steady_clock::now() - start_time).count()}};
    for (const Clock::Entry& phase : phases.entries()) summary.timings.emplace_back(phase.name, phase.seconds);
    write_summary(summary, options.output);
  };
  try {
    const Eigen::VectorXd value = values_at(projection, setup.points);
    const Eigen::VectorXd coefficient =
        phases.time("projection", [&] { return solve(problem, setup, projection, value); });
    summary.projection_errors = phases.time("errors", [&] { return errors_of(setup, projection, value, coefficient); });
    phases.time("output", [&] {
      ResultsWriter(options.output, problem.title, setup.basis->grid(), "projection")
          .write(sampled(setup, projection, coefficient, determined_cells(setup)));
    });
  } catch (const ComputationError& error) {
    const ResultsWriter empty(options.output, problem.title, setup.basis->grid(), "projection");
    finish(error.what());
    throw;
  }
  summary.completed = true;
  if (problem.output.pictures)
    if (const auto warning = phases.time("pictures", [&] { return make_pictures(options.output); }))
      summary.warnings.push_back(*warning);
  finish("");
  return summary;
}

std::string plan_projection(const Case& problem) {
  const auto& projection = std::get<Projection>(problem.analysis);
  const Setup setup = set_up(problem, projection);
  const Grid& grid = setup.basis->grid();
  const std::vector<Index> cells = determined_cells(setup);
  return fmt::format(
      "{}\n\nwill run\n  projection, {} mass\n\nsizes\n"
      "  basis               {}\n  grid                {} elements of {} cells, {} cells with points\n"
      "  points              {}\n  unknowns            {}\n",
      problem.title, projection.mass == Mass::consistent ? "consistent" : "lumped", name_of(problem.grid.basis),
      grid.cells() / grid.parts(), grid.parts(), cells.size(), setup.points.x.size(),
      count_functions(*setup.basis, cells));
}

}  // namespace shoreline
