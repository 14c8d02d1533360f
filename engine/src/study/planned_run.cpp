#include "planned_run.hpp"

#include <omp.h>

#include <algorithm>

#include "case_file/overrides.hpp"

namespace shoreline {
namespace {

/// Numbers of axes, slowest first.
std::vector<std::size_t> order_of(const Study& study) {
  std::vector<std::size_t> order;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (a != study.refine) order.push_back(a);
  if (study.refine) order.push_back(*study.refine);
  return order;
}

void add_choice(const Study& study, std::size_t axis, const Study::Choice& choice, PlannedRun& run) {
  run.labels[axis] = choice.label;
  run.settings.insert(run.settings.end(), choice.settings.begin(), choice.settings.end());
  if (axis == study.refine)
    run.refinement = choice.number;
  else
    run.line += (run.line.empty() ? "" : ", ") + choice.label;
}

std::string analysis_of(const Json& json) {
  const Json analysis = json.value("analysis", Json());
  return analysis.is_object() && analysis.contains("type") && analysis["type"].is_string()
             ? analysis["type"].get<std::string>()
             : "quasi_static";
}

/// Sets a key that neither the case nor the study names.
void set_unless_there(Json& json, const std::string& pointer, const Json& value) {
  if (const Json::json_pointer at(pointer); !json.contains(at)) json[at] = value;
}

/// Probes at the same places in all runs: the nearest points differ from one run to the next.
void fix_probes(Json& json) {
  if (json.contains("probes") && json["probes"].is_array())
    for (Json& probe : json["probes"])
      if (probe.is_object() && !probe.contains("at")) probe["at"] = "place";
}

/// What makes runs comparable and their clock fair.
void make_fair(const Study& study, const Json& base, std::optional<int> threads, Json& json) {
  const bool quasi_static = analysis_of(json) == "quasi_static";
  if (threads) json["solver"]["threads"] = *threads;
  set_unless_there(json, "/solver/threads", omp_get_num_procs());
  if (json["solver"]["threads"] == 0) json["solver"]["threads"] = omp_get_num_procs();
  if (quasi_static && json.contains("exact") && study.samples > 0) set_unless_there(json, "/samples", study.samples);
  if (quasi_static) fix_probes(json);
  if (quasi_static && reference_of(study, base)) set_unless_there(json, "/diagnostics/strain_energy", true);
}

}  // namespace

std::vector<PlannedRun> planned_runs(const Study& study) {
  PlannedRun whole;
  whole.labels.resize(study.axes.size());
  whole.settings = study.settings;
  std::vector<PlannedRun> runs{whole};
  for (const std::size_t axis : order_of(study)) {
    std::vector<PlannedRun> finer;
    for (const PlannedRun& run : runs)
      for (const Study::Choice& choice : study.axes[axis].choices) {
        finer.push_back(run);
        add_choice(study, axis, choice, finer.back());
      }
    runs = std::move(finer);
  }
  for (PlannedRun& run : runs)
    if (run.line.empty()) run.line = study.title;
  return runs;
}

std::optional<Study::Reference> reference_of(const Study& study, const Json& base) {
  if (study.reference || base.contains("exact")) return study.reference;
  const bool projection = analysis_of(base) == "projection";
  return projection ? std::nullopt : std::optional<Study::Reference>(Study::Finest{});
}

PreparedCase prepared_case(const Study& study, const Json& base, std::optional<int> threads,
                           const std::vector<std::string>& settings) {
  constexpr int only_the_ends = 1000000;
  PreparedCase prepared{base, ""};
  try {
    Json as_run = base;
    for (const std::string& setting : settings) override_value(as_run, setting);
    override_value(prepared.json, "output.pictures=false");
    if (analysis_of(as_run) != "projection")
      override_value(prepared.json, "output.every=" + std::to_string(only_the_ends));
    for (const std::string& setting : settings) override_value(prepared.json, setting);
    if (const Json::json_pointer mesh("/grid/mesh"); prepared.json.contains(mesh) && prepared.json[mesh].is_string())
      prepared.json[mesh] =
          std::filesystem::absolute(study.base.parent_path() / prepared.json[mesh].get<std::string>()).string();
    set_unless_there(prepared.json, "/title", study.base.stem().string());
    make_fair(study, base, threads, prepared.json);
  } catch (const CaseError& error) {
    prepared.fault = error.what();
  } catch (const Json::exception&) {  // a value where an object should be: the run itself says so better
  }
  return prepared;
}

}  // namespace shoreline
