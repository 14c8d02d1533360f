// A study's rows as study.csv and study.md.

#include <fmt/format.h>

#include <set>

#include "machine.hpp"
#include "study_table.hpp"

namespace shoreline {
namespace {

std::string joined(const std::vector<std::string>& cells) {
  std::vector<std::string> quoted;
  for (const std::string& cell : cells) quoted.push_back(csv_cell(cell));
  return fmt::format("{}\n", fmt::join(quoted, ","));
}

std::string number(const Json& summary, const char* key) {
  return summary.contains(key) ? summary[key].dump() : std::string();
}

std::string looked_up(const std::map<std::string, double>& in, const std::string& name) {
  const auto found = in.find(name);
  return found == in.end() ? std::string() : fmt::format("{:.10g}", found->second);
}

std::vector<std::string> phases_in(const std::vector<StudyRow>& rows) {
  std::set<std::string> names;
  for (const StudyRow& row : rows)
    for (const auto& [phase, seconds] : row.result.phases) names.insert(phase);
  return {names.begin(), names.end()};
}

std::vector<std::string> csv_cells(const StudyRow& row, const std::vector<std::string>& norms,
                                   const std::vector<std::string>& phases) {
  const RunResult& result = row.result;
  std::vector<std::string> cells{row.plan.line};
  cells.insert(cells.end(), row.plan.labels.begin(), row.plan.labels.end());
  cells.push_back(row.plan.refinement ? fmt::format("{:.10g}", *row.plan.refinement) : "");
  cells.push_back(result.completed ? "completed" : "failed");
  cells.push_back(result.reason);
  const Json summary = result.completed ? result.summary : Json::object();
  for (const char* key :
       {"material_points", "degrees_of_freedom", "steps", "threads", "peak_memory_bytes", "condition_estimate"})
    cells.push_back(number(summary, key));
  const auto times = [&](const std::vector<double>& seconds, double Spread::*which) {
    cells.push_back(seconds.empty() || !result.completed ? "" : fmt::format("{:.6g}", spread_of(seconds).*which));
  };
  for (const auto which : {&Spread::median, &Spread::least, &Spread::greatest}) times(result.seconds, which);
  for (const std::string& norm : norms) cells.push_back(looked_up(row.norms, norm));
  for (const std::string& norm : norms) cells.push_back(looked_up(row.rates, norm));
  for (const std::string& phase : phases) {
    const auto found = result.phases.find(phase);
    times(found == result.phases.end() ? std::vector<double>() : found->second, &Spread::median);
  }
  return cells;
}

/// A cell of a Markdown table: one line, bars escaped.
std::string markdown_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  return cell;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::vector<std::string> escaped;
  for (const std::string& cell : cells) escaped.push_back(markdown_cell(cell));
  return fmt::format("| {} |\n", fmt::join(escaped, " | "));
}

/// A number of seconds with its spread, in as many digits as it has.
std::string spread_text(const std::vector<double>& seconds) {
  const Spread spread = spread_of(seconds);
  if (seconds.size() == 1) return fmt::format("{:.3g}", spread.median);
  return fmt::format("{:.3g} ({:.3g} to {:.3g})", spread.median, spread.least, spread.greatest);
}

std::vector<std::string> markdown_cells(const StudyRow& row, const StudyTable& table) {
  std::vector<std::string> cells = row.plan.labels;
  if (!row.result.completed) {
    cells.push_back("failed");
    cells.resize(cells.size() + 3 + 2 * table.errors.size());
    return cells;
  }
  const Json& summary = row.result.summary;
  cells.push_back(summary["material_points"].dump());
  cells.push_back(summary["degrees_of_freedom"].dump());
  for (const std::string& norm : table.errors) {
    const auto error = row.norms.find(norm);
    const auto rate = row.rates.find(norm);
    cells.push_back(error == row.norms.end() ? "" : fmt::format("{:.2e}", error->second));
    cells.push_back(rate == row.rates.end() ? "" : fmt::format("{:.2f}", rate->second));
  }
  cells.push_back(spread_text(row.result.seconds));
  cells.push_back(fmt::format("{:.0f}", summary["peak_memory_bytes"].get<double>() / 1e6));
  return cells;
}

}  // namespace

std::string csv_of(const StudyTable& table) {
  const std::vector<std::string> norms = norms_in(table.rows);
  const std::vector<std::string> phases = phases_in(table.rows);
  std::vector<std::string> columns{"line"};
  for (const std::string& axis : table.axes) columns.push_back("axis." + axis);
  columns.insert(columns.end(),
                 {"refinement", "status", "reason", "points", "unknowns", "steps", "threads", "peak_memory_bytes",
                  "condition_estimate", "seconds", "seconds.least", "seconds.greatest"});
  columns.insert(columns.end(), norms.begin(), norms.end());
  for (const std::string& norm : norms) columns.push_back("rate." + norm);
  for (const std::string& phase : phases) columns.push_back("phase." + phase);
  std::string text = joined(columns);
  for (const StudyRow& row : table.rows) text += joined(csv_cells(row, norms, phases));
  return text;
}

std::string markdown_of(const StudyTable& table) {
  std::vector<std::string> columns = table.axes;
  columns.insert(columns.end(), {"points", "unknowns"});
  for (const std::string& norm : table.errors) columns.insert(columns.end(), {norm, "rate"});
  columns.insert(columns.end(), {"seconds", "memory [MB]"});
  std::string text = markdown_row(columns) + markdown_row(std::vector<std::string>(columns.size(), "---:"));
  for (const StudyRow& row : table.rows) text += markdown_row(markdown_cells(row, table));
  return text +
         fmt::format("\nSeconds of the whole run without output and errors, median (least to greatest); {}; {}; {}.\n",
                     table.device, program_name(), machine_name());
}

}  // namespace shoreline
