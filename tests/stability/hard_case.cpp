#include "hard_case.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "shoreline/engine/defaults.hpp"
#include "shoreline/engine/error_norms.hpp"
#include "shoreline/engine/linear_solver.hpp"

namespace shoreline::test {
namespace {

using Type = Case::BasisType;

/// Largest error of stress at a point, relative to the largest exact stress.
double largest_stress_error(const Scene& scene) {
  double error = 0.0;
  double scale = 0.0;
  for (Index p = 0; p < scene.points.size(); ++p) {
    const Vec3 exact = scene.exact->stress(scene.points.position.col(p) - scene.points.displacement.col(p), 1.0);
    error = std::max(error, (scene.points.stress.col(p).head<3>() - exact).norm());
    scale = std::max(scale, exact.norm());
  }
  return error / scale;
}

double seconds_of(const Clock& clock, const std::string& name) {
  double seconds = 0.0;
  for (const Clock::Entry& e : clock.entries())
    if (name.empty() || e.name == name) seconds += e.seconds;
  return seconds;
}

bool any_says(const std::vector<std::string>& warnings, const char* what) {
  return std::ranges::any_of(warnings, [&](const std::string& w) { return w.find(what) != std::string::npos; });
}

void take_over(const Scene& scene, const RunRecord& record, Outcome& outcome) {
  for (const std::string& warning : record.warnings)
    if (outcome.warning.empty() || warning.find("the stiffness is") != std::string::npos) outcome.warning = warning;
  outcome.singular = any_says(record.warnings, "the stiffness is singular");
  outcome.indefinite = any_says(record.warnings, "not positive definite");
  outcome.condition = record.condition_estimate.value_or(1.0);
  outcome.displacement = error_norms(scene.points, *scene.exact, 1.0).displacement_l2_relative.value();
  outcome.stress = largest_stress_error(scene);
  const double step = seconds_of(record.phases, "") - seconds_of(record.phases, "condition_estimate");
  outcome.ghost_share = seconds_of(record.effects, "ghost_penalty") / step;
  outcome.weight_share = seconds_of(record.phases, "weights") / step;
}

/// Median and largest of a number of those that went to their end.
Spread spread(const std::vector<Outcome>& outcomes, double Outcome::*number) {
  std::vector<double> values;
  for (const Outcome& o : outcomes)
    if (o.failure.empty()) values.push_back(o.*number);
  if (values.empty()) return {};
  std::ranges::sort(values);
  return {values[values.size() / 2], values.back()};
}

}  // namespace

Discretisation remedied(Type basis, int degree, EssentialMethod method) {
  return {.basis = basis,
          .degree = degree,
          .method = method,
          .ghost = ghost_for_nitsche(basis, degree),
          .band = method == EssentialMethod::nitsche ? nitsche_band(basis) : Essential{}.band,
          .narrows = method == EssentialMethod::nitsche,
          .per_cell = degree == 3 ? 6 : 4};
}

std::vector<Discretisation> every_basis(EssentialMethod method) {
  return {remedied(Type::bilinear, 1, method), remedied(Type::linear, 1, method),
          remedied(Type::powell_sabin, 2, method), remedied(Type::bspline, 2, method),
          remedied(Type::bspline, 3, method)};
}

std::vector<EssentialMethod> both_methods() { return {EssentialMethod::implicit_boundary, EssentialMethod::nitsche}; }

std::string basis_name(const Discretisation& d) {
  switch (d.basis) {
    case Type::linear:
      return "linear";
    case Type::powell_sabin:
      return "powell_sabin";
    case Type::bspline:
      return "bspline " + std::to_string(d.degree);
    case Type::bilinear:
      break;
  }
  return "bilinear";
}

std::string method_name(EssentialMethod method) {
  return method == EssentialMethod::nitsche ? "nitsche" : "implicit_boundary";
}

Outcome compute(const Case& problem) {
  omp_set_num_threads(1);  // systems are small: threads would only wait for each other
  set_blas_threads(1);
  Outcome outcome;
  const auto start = std::chrono::steady_clock::now();
  try {
    Scene scene = build_scene(problem);
    RunRecord record;
    run_load_steps(scene, {.condition_estimate = true}, record);
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    take_over(scene, record, outcome);
  } catch (const Error& error) {
    outcome.failure = error.what();
  }
  return outcome;
}

Case discretised(Case problem, const Discretisation& d) {
  problem.grid.basis = d.basis;
  problem.grid.degree = d.degree;
  problem.ghost = d.ghost;
  problem.fitted = d.fitted;
  const int n = d.fitted ? d.degree + 1 : d.per_cell;
  problem.material_points = LatticeFill{{n, n}, d.fitted ? VolumeRule::fitted : VolumeRule::clipped};
  for (Case::Boundary& side : problem.boundaries) {
    auto* support = std::get_if<Essential>(&side.condition);
    if (auto* moved = std::get_if<Case::Displacement>(&side.condition)) support = &moved->support;
    if (support == nullptr) continue;
    support->method = d.method;
    support->band = d.band;
    support->narrows = d.narrows;
  }
  return problem;
}

Row summarised(std::string label, const Discretisation& on, const std::vector<Outcome>& outcomes) {
  Row row{.label = std::move(label), .on = on, .runs = static_cast<int>(outcomes.size())};
  const Outcome* worst = &outcomes[0];
  for (const Outcome& o : outcomes) {
    row.failures += o.failure.empty() ? 0 : 1;
    row.singular += o.singular ? 1 : 0;
    row.indefinite += o.indefinite ? 1 : 0;
    if (worst->failure.empty() && (!o.failure.empty() || o.displacement > worst->displacement)) worst = &o;
    if (row.said.empty()) row.said = o.failure.empty() ? o.warning : o.failure;
  }
  row.worst = worst->place;
  if (!worst->failure.empty()) row.said = worst->failure;
  row.condition = spread(outcomes, &Outcome::condition);
  row.displacement = spread(outcomes, &Outcome::displacement);
  row.stress = spread(outcomes, &Outcome::stress);
  row.ghost_share = spread(outcomes, &Outcome::ghost_share).median;
  row.weight_share = spread(outcomes, &Outcome::weight_share).median;
  row.seconds = spread(outcomes, &Outcome::seconds).median;
  return row;
}

Row over_offsets(std::string label, const Case& problem, const Discretisation& on, int offsets) {
  const Case at_rest = discretised(problem, on);
  std::vector<Outcome> outcomes;
  for (int k = 1; k <= offsets; ++k) {
    // multiples of the plastic number's inverse powers fill the square evenly
    const Vec2 share(std::fmod(0.7548776662466927 * k, 1.0), std::fmod(0.5698402909980532 * k, 1.0));
    Case moved = at_rest;
    moved.grid.lower -= share.cwiseProduct(moved.grid.cell_size);
    outcomes.push_back(compute(moved));
    outcomes.back().place = fmt::format("({:.4f}, {:.4f}) h", share.x(), share.y());
  }
  return summarised(std::move(label), on, outcomes);
}

}  // namespace shoreline::test
