#include "shoreline/engine/summary.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "atomic_file.hpp"
#include "shoreline/engine/version.hpp"

namespace shoreline {
namespace {

using Json = nlohmann::ordered_json;  // writes numbers that are not finite as null

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

template <std::size_t n>
Json component_norms(double l2, const std::optional<double>& l2_relative,
                     const std::array<ErrorNorms::Component, n>& components) {
  Json norms = {{"l2", l2},
                {"l2_relative", number_or_null(l2_relative)},
                {"mean_relative", Json::array()},
                {"mean_absolute", Json::array()},
                {"max_absolute", Json::array()}};
  for (const ErrorNorms::Component& component : components) {
    norms["mean_relative"].push_back(number_or_null(component.mean_relative));
    norms["mean_absolute"].push_back(component.mean_absolute);
    norms["max_absolute"].push_back(component.max_absolute);
  }
  return norms;
}

Json error_norms(const ErrorNorms& errors) {
  Json boundary = Json::object();
  for (const auto& [name, l2] : errors.boundary_l2_displacement) boundary[name]["l2_displacement"] = l2;
  for (const auto& [name, radius] : errors.boundary_radius)
    boundary[name]["radius"] = {
        {"mean", radius.mean}, {"exact", radius.exact}, {"mean_relative", radius.mean_relative}};
  Json json = {
      {"measured_at", errors.at_samples ? "sample points" : "material points"},
      {"points", errors.places},
      {"displacement", component_norms(errors.displacement_l2, errors.displacement_l2_relative, errors.displacement)},
      {"stress", component_norms(errors.stress_l2, errors.stress_l2_relative, errors.stress)},
      {"boundary", boundary}};
  for (const ErrorNorms::OverTime& error : errors.over_time)
    json["over_time"][error.of] = {{"rms", error.rms}, {"mean_rms", error.mean_rms}};
  return json;
}

Json projection_errors(const ProjectionErrors& errors) {
  Json json = {{"l2", errors.l2}, {"l2_relative", number_or_null(errors.l2_relative)}};
  if (errors.derivative_l2) {
    json["x_derivative_l2"] = (*errors.derivative_l2)[0];
    json["y_derivative_l2"] = (*errors.derivative_l2)[1];
  }
  return {{"projection", json}};
}

Json error_estimate(const ErrorEstimate& estimate) {
  return {{"stress", {{"l2", estimate.stress_l2}, {"l2_relative", number_or_null(estimate.stress_l2_relative)}}}};
}

Json resultants(const std::map<std::string, Vec3>& of_pieces) {
  Json json = Json::object();
  for (const auto& [name, resultant] : of_pieces) json[name] = {resultant[0], resultant[1], resultant[2]};
  return json;
}

Json list(const Eigen::VectorXd& numbers) { return std::vector<double>(numbers.begin(), numbers.end()); }

Json probe(const Probe& probe) {
  const ProbeState& last = probe.history.back();
  Json json = {{"on", followed_by(probe)},
               {"at", list(probe.history.front().position)},
               {"position", list(last.position)},
               {"displacement", list(last.displacement)}};
  if (last.stress) json["stress"] = list(*last.stress);
  if (last.velocity) json["velocity"] = list(*last.velocity);
  return json;
}

Json solver(const SolverUse& use) {
  Json json = {{"type", name_of(use.type)}, {"unknowns", use.unknowns}, {"bytes", use.bytes}};
  if (use.iterations) json["iterations"] = *use.iterations;
  return json;
}

long long peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024LL * usage.ru_maxrss;
}

Json dynamics(const Summary::Dynamics& d) {
  return {{"law", d.law},
          {"objective", d.objective},
          {"mass", d.mass},
          {"pic", d.pic},
          {"damping", d.damping},
          {"end_time", d.end_time},
          {"smallest_step", d.smallest_step},
          {"largest_step", d.largest_step},
          {"critical_step_at_start", d.critical_step_at_start},
          {"smallest_critical_step", d.smallest_critical_step},
          {"time_of_smallest_critical_step", d.time_of_smallest},
          {"courant", d.courant},
          {"dropped_points", d.dropped_points}};
}

Json fitted_weights(const WeightReport& weights) {
  return {{"changed", weights.changed},
          {"bounded", weights.bounded},
          {"unmet", weights.unmet},
          {"cells_unmet", weights.cells_unmet},
          {"unserved", weights.unserved},
          {"iterations", weights.iterations},
          {"factorisations", weights.factorisations}};
}

Json energies(const HistoryState& state) {
  return {{"kinetic", state.kinetic}, {"strain", state.strain}, {"gravity", state.gravity}, {"total", state.total()}};
}

/// Energies and momentum at both ends of a history.
void add_balance(const std::vector<HistoryState>& history, Json& json) {
  const auto [least, most] = std::ranges::minmax(history, {}, &HistoryState::total);
  json["energy"] = {{"start", energies(history.front())},
                    {"end", energies(history.back())},
                    {"largest_total", most.total()},
                    {"smallest_total", least.total()}};
  json["momentum"] = {{"start", list(history.front().momentum)}, {"end", list(history.back().momentum)}};
}

/// What steps know of the boundary.
void add_loads(const Summary& summary, Json& json) {
  json["reactions"] = resultants(summary.reactions);
  json["loads"] = resultants(summary.loads);
  for (const auto& [name, error] : summary.displacement_fit)
    json["displacement_fit"][name] = {{"l2", error.l2}, {"mean", error.mean}};
  json["extended_share"] = summary.extended_share;
}

Json diagnostics(const Diagnostics& d) {
  Json json = Json::object();
  if (d.smallest_cut)
    json["smallest_cut"] = {{"fraction", d.smallest_cut->fraction},
                            {"element", d.smallest_cut->element},
                            {"centre", list(d.smallest_cut->centre)}};
  if (d.smallest_pivot)
    json["smallest_pivot"] = {{"value", d.smallest_pivot->value},
                              {"control_point", list(d.smallest_pivot->control_point)},
                              {"component", d.smallest_pivot->component == 0 ? "x" : "y"}};
  json["stray_points"] = {{"number", d.stray_points}};
  if (d.first_stray) json["stray_points"]["first"] = list(*d.first_stray);
  json["fewest_points_in_element"] = d.fewest_points;
  return json;
}

void add_costs(const Summary& summary, Json& json) {
  json["effects"] = Json::array();
  json["effect_costs"] = Json::object();
  for (const Summary::Effect& effect : summary.effects) {
    json["effects"].push_back(effect.name);
    json["effect_costs"][effect.name] = {{"calls", effect.calls}, {"seconds", effect.seconds}};
  }
  json["timings"] = Json::object();
  for (const auto& [phase, seconds] : summary.timings) json["timings"][phase] = seconds;
  json["counters"] = summary.counters;
  json["peak_memory_bytes"] = peak_memory_bytes();
}

}  // namespace

void write_summary(const Summary& summary, const std::filesystem::path& folder) {
  Json json = {{"title", summary.title},       {"status", summary.completed ? "completed" : "failed"},
               {"message", summary.message},   {"warnings", summary.warnings},
               {"analysis", summary.analysis}, {"basis", summary.basis}};
  if (summary.degree) json["degree"] = *summary.degree;
  json.update({{"degrees_of_freedom", summary.degrees_of_freedom},
               {"material_points", summary.material_points},
               {"steps", summary.steps},
               {"threads", summary.threads},
               {"version", version()},
               {"blas", summary.blas}});
  if (summary.solver) json["solver"] = solver(*summary.solver);
  if (summary.errors) json["errors"] = error_norms(*summary.errors);
  if (summary.error_estimate) json["error_estimate"] = error_estimate(*summary.error_estimate);
  if (summary.projection_errors) json["errors"] = projection_errors(*summary.projection_errors);
  if (summary.analysis != "projection") add_loads(summary, json);
  if (summary.dynamics) json["dynamics"] = dynamics(*summary.dynamics);
  if (summary.fitted_weights) json["fitted_weights"] = fitted_weights(*summary.fitted_weights);
  if (!summary.history.empty()) add_balance(summary.history, json);
  for (const Probe& p : summary.probes) json["probes"][p.name] = probe(p);
  add_costs(summary, json);
  if (summary.condition_estimate) json["condition_estimate"] = *summary.condition_estimate;
  if (summary.strain_energy) json["strain_energy"] = *summary.strain_energy;
  if (summary.diagnostics) json["diagnostics"] = diagnostics(*summary.diagnostics);
  write_atomically(folder / "summary.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace shoreline
