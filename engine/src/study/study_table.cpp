#include "study_table.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "machine.hpp"

namespace shoreline {
namespace {

Json label_of(const std::string& label) {
  const Json value = Json::parse(label, nullptr, false);
  return value.is_number() ? value : Json(label);
}

Json json_of(const StudyRow& row, const StudyTable& table) {
  Json json = {{"line", row.plan.line},
               {"refinement", row.plan.refinement ? Json(*row.plan.refinement) : Json()},
               {"status", row.result.completed ? "completed" : "failed"},
               {"reason", row.result.reason},
               {"folder", "runs/" + row.result.folder.filename().string()}};
  for (std::size_t a = 0; a < table.axes.size(); ++a) json["labels"][table.axes[a]] = label_of(row.plan.labels[a]);
  if (!row.result.completed) return json;
  const Json& summary = row.result.summary;
  const Spread seconds = spread_of(row.result.seconds);
  json.update({{"points", summary["material_points"]},
               {"unknowns", summary["degrees_of_freedom"]},
               {"steps", summary["steps"]},
               {"threads", summary["threads"]},
               {"errors", row.norms},
               {"rates", row.rates},
               {"seconds", {{"median", seconds.median}, {"least", seconds.least}, {"greatest", seconds.greatest}}},
               {"peak_memory_bytes", summary["peak_memory_bytes"]},
               {"warnings", summary["warnings"]}});
  for (const auto& [phase, times] : row.result.phases) json["phases"][phase] = spread_of(times).median;
  if (summary.contains("condition_estimate")) json["condition_estimate"] = summary["condition_estimate"];
  return json;
}

Json json_of(const OutsideRow& row) {
  return {{"line", row.line},
          {"refinement", row.refinement ? Json(*row.refinement) : Json()},
          {"points", row.points},
          {"unknowns", row.unknowns},
          {"seconds", {{"median", row.seconds}}},
          {"errors", row.norms}};
}

}  // namespace

Spread spread_of(std::vector<double> seconds) {
  std::ranges::sort(seconds);
  const std::size_t n = seconds.size();
  return {0.5 * (seconds[(n - 1) / 2] + seconds[n / 2]), seconds.front(), seconds.back()};
}

void add_rates(std::vector<StudyRow>& rows) {
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const StudyRow& coarse = rows[k - 1];
    StudyRow& fine = rows[k];
    if (coarse.plan.line != fine.plan.line || !coarse.plan.refinement || !fine.plan.refinement) continue;
    const double ratio = std::abs(std::log(*coarse.plan.refinement / *fine.plan.refinement));
    for (const auto& [norm, error] : fine.norms)
      if (const auto before = coarse.norms.find(norm); before != coarse.norms.end() && before->second > 0 && error > 0)
        fine.rates[norm] = std::log(before->second / error) / ratio;
  }
}

std::vector<std::string> norms_in(std::span<const StudyRow> rows) {
  std::set<std::string> names;
  for (const StudyRow& row : rows)
    for (const auto& [name, error] : row.norms) names.insert(name);
  return {names.begin(), names.end()};
}

Json json_of(const StudyTable& table) {
  Json json = {{"title", table.title},   {"program", program_name()}, {"machine", machine_name()},
               {"device", table.device}, {"errors", table.errors},    {"refine", Json()},
               {"axes", Json::array()},  {"rows", Json::array()},     {"outside", Json::array()}};
  if (table.refine) json["refine"] = table.axes[*table.refine];
  for (std::size_t a = 0; a < table.axes.size(); ++a) {
    Json values = Json::array();
    for (const StudyRow& row : table.rows)
      if (const Json label = label_of(row.plan.labels[a]); !std::ranges::count(values, label)) values.push_back(label);
    json["axes"].push_back({{"name", table.axes[a]}, {"values", values}});
  }
  for (const StudyRow& row : table.rows) json["rows"].push_back(json_of(row, table));
  for (const OutsideRow& row : table.outside) json["outside"].push_back(json_of(row));
  return json;
}

}  // namespace shoreline
