#include "shoreline/engine/study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "answer.hpp"
#include "case_file/nearest.hpp"
#include "case_file/text_file.hpp"
#include "comparison.hpp"
#include "output/atomic_file.hpp"
#include "quantities.hpp"
#include "shoreline/engine/pictures.hpp"
#include "study_progress.hpp"

namespace shoreline {
namespace {

/// A study at work: what its parts share.
struct Work {
  const Study& study;
  const StudyOptions& options;
  Json base;
  Runner runner;

  [[nodiscard]] PreparedCase prepared(const std::vector<std::string>& settings) const {
    return prepared_case(study, base, options.threads, settings);
  }
};

StudyRow row_of(const PlannedRun& plan, RunResult result) {
  StudyRow row{plan, std::move(result), {}, {}};
  if (row.result.completed) row.norms = norms_of(row.result.summary);
  return row;
}

std::vector<StudyRow> run_all(Work& work) {
  const std::vector<PlannedRun> plans = planned_runs(work.study);
  const std::size_t levels = work.study.refine ? work.study.axes[*work.study.refine].choices.size() : 1;
  StudyProgress progress(plans, levels, work.options.quiet);
  std::vector<StudyRow> rows;
  for (const PlannedRun& plan : plans) {
    const PreparedCase prepared = work.prepared(plan.settings);
    const bool known = work.runner.recorded(prepared, work.study.repeat).has_value();
    RunResult result = work.runner.result_of(prepared, work.study.repeat);
    progress.finished(rows.size(), result, known);
    rows.push_back(row_of(plan, std::move(result)));
  }
  return rows;
}

Comparison comparison_of(Work& work, const Study::Reference& reference, const std::vector<StudyRow>& rows) {
  if (std::holds_alternative<Study::Finest>(reference)) return finest_run(rows);
  if (std::holds_alternative<Study::Richardson>(reference)) return richardson_limit(rows);
  std::vector<std::string> settings = work.study.settings;
  for (const std::string& setting : std::get<Study::OwnRun>(reference).settings) settings.push_back(setting);
  const RunResult result = work.runner.result_of(work.prepared(settings), 1);
  if (!result.completed) return {"the reference failed: " + result.reason, Json(), {}};
  return {"differences from a reference run of their own", result.quantities, {}};
}

/// Norms to show where the study does not say: of an exact solution, else what is compared first.
std::vector<std::string> usual_norms(const std::vector<StudyRow>& rows) {
  constexpr std::size_t most = 4;
  const std::vector<std::string> norms = norms_in(rows);
  std::vector<std::string> shown;
  for (const std::string norm : {"displacement.l2_relative", "stress.l2_relative", "projection.l2_relative"})
    if (std::ranges::count(norms, norm)) shown.push_back(norm);
  for (const std::string start : {"probe.", "curve.", "energy", "reaction."})
    for (const std::string& norm : norms)
      if (shown.size() < most && norm.starts_with(start) && !std::ranges::count(shown, norm)) shown.push_back(norm);
  return shown;
}

/// Where errors are measured: the same in all runs that completed, or not.
std::string device_of(const std::vector<StudyRow>& rows) {
  for (const StudyRow& row : rows) {
    if (!row.result.completed || !row.result.summary.contains("errors")) continue;
    const Json& errors = row.result.summary["errors"];
    if (errors.value("measured_at", "") == "sample points")
      return fmt::format("errors at {} sample points, the same in every run", errors["points"].dump());
    return "errors at each run's own points";
  }
  return "no exact solution";
}

void write_files(const StudyTable& table, const std::optional<Answer>& found, const StudyOptions& options) {
  Json json = json_of(table);
  if (found && found->chosen)
    json["tolerance"] = {{"norm", options.tolerance->norm},
                         {"value", options.tolerance->value},
                         {"chosen", *found->chosen},
                         {"error_left", found->error_left},
                         {"dominant", found->dominant}};
  write_atomically(options.output / "study.json", json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  write_atomically(options.output / "study.csv", csv_of(table));
  write_atomically(options.output / "study.md", markdown_of(table));
}

std::string failures_of(const StudyTable& table) {
  std::string text;
  for (const StudyRow& row : table.rows)
    if (!row.result.completed)
      text += fmt::format("failed: {}: {}\n", fmt::join(row.plan.labels, ", "), row.result.reason);
  return text;
}

/// Compares every row but the reference itself.
void compare_all(const Comparison& comparison, std::vector<StudyRow>& rows) {
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (r != comparison.row) compare(comparison, rows[r]);
}

Answer answer_of(Work& work, const StudyTable& table, const Comparison& comparison) {
  return answer(
      table, *work.options.tolerance, [&](const PlannedRun& plan) { return work.prepared(plan.settings).json; },
      [&](const PlannedRun& plan, const std::vector<std::string>& more) {
        std::vector<std::string> settings = plan.settings;
        settings.insert(settings.end(), more.begin(), more.end());
        StudyRow row = row_of(plan, work.runner.result_of(work.prepared(settings), 1));
        compare(comparison, row);
        return row;
      });
}

/// Norms to show that no run has, as warnings.
std::string unknown_norms(const StudyTable& table) {
  const std::vector<std::string> norms = norms_in(table.rows);
  std::string text;
  for (const std::string& norm : table.errors)
    if (!norms.empty() && !std::ranges::count(norms, norm))
      text += fmt::format("warning: no run has the norm \"{}\", {}\n", norm, expected_one_of(norms, norm));
  return text;
}

}  // namespace

StudyOutcome run_study(const Study& study, const StudyOptions& options) {
  StudyTable table{.title = study.title,
                   .device = "",
                   .axes = {},
                   .refine = study.refine,
                   .errors = study.errors,
                   .rows = {},
                   .outside = {}};
  for (const Study::Axis& axis : study.axes) table.axes.push_back(axis.name);
  for (const std::filesystem::path& file : study.outside)
    for (OutsideRow& row : read_outside_rows(file)) table.outside.push_back(std::move(row));
  const Json base = parse_json(text_of(study.base, "a case file"), {study.base.string(), {}});
  Work work{study, options, base, Runner(study, options.program, options.output / "runs")};

  table.rows = run_all(work);
  table.device = device_of(table.rows);
  Comparison comparison;
  if (const auto reference = reference_of(study, base)) {
    comparison = comparison_of(work, *reference, table.rows);
    compare_all(comparison, table.rows);
    table.device = (table.device == "no exact solution" ? "" : table.device + "; ") + comparison.with;
  }
  add_rates(table.rows);
  if (table.errors.empty()) table.errors = usual_norms(table.rows);
  write_files(table, {}, options);

  std::optional<Answer> found;
  const auto completed = [](const StudyRow& row) { return row.result.completed; };
  if (options.tolerance && std::ranges::any_of(table.rows, completed)) {
    found = answer_of(work, table, comparison);
    write_files(table, found, options);
  }
  StudyOutcome outcome;
  outcome.runs = static_cast<int>(table.rows.size());
  outcome.failures = outcome.runs - static_cast<int>(std::ranges::count_if(table.rows, completed));
  const auto no_picture = make_study_pictures(options.output);
  outcome.report =
      fmt::format("{}: {} runs, {} failed\n\n{}\n{}{}{}{}results: {}\n", study.title, outcome.runs, outcome.failures,
                  markdown_of(table), failures_of(table), unknown_norms(table), found ? found->text + "\n" : "",
                  no_picture ? "warning: " + *no_picture + "\n" : "", options.output.string());
  return outcome;
}

}  // namespace shoreline
