#include "answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case_file/nearest.hpp"
#include "refinements.hpp"
#include "shoreline/engine/failures.hpp"

namespace shoreline {
namespace {

std::optional<double> error_in(const std::map<std::string, double>& norms, const std::string& norm) {
  const auto found = norms.find(norm);
  return found == norms.end() || !std::isfinite(found->second) ? std::nullopt : std::optional(found->second);
}

double seconds_of(const StudyRow& row) { return spread_of(row.result.seconds).median; }

std::string setting_of(const StudyTable& table, const StudyRow& row) {
  std::vector<std::string> words;
  for (std::size_t a = 0; a < table.axes.size(); ++a) words.push_back(table.axes[a] + " " + row.plan.labels[a]);
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Rows whose error is at most so large, the fastest first.
std::vector<std::size_t> within(const StudyTable& table, const std::string& norm, double value) {
  std::vector<std::size_t> rows;
  for (std::size_t r = 0; r < table.rows.size(); ++r)
    if (const auto error = error_in(table.rows[r].norms, norm); error && *error <= value) rows.push_back(r);
  std::ranges::sort(rows, {}, [&](std::size_t r) { return seconds_of(table.rows[r]); });
  return rows;
}

/// Where a line would meet a smaller error, by its last rate and the growth of its last times.
struct Extrapolation {
  std::string line;
  double refinement;
  double seconds;
};

std::optional<Extrapolation> extrapolated(const StudyTable& table, const std::string& norm, double value) {
  std::optional<Extrapolation> best;
  for (std::size_t r = 1; r < table.rows.size(); ++r) {
    const StudyRow& coarse = table.rows[r - 1];
    const StudyRow& fine = table.rows[r];
    const bool last = r + 1 == table.rows.size() || table.rows[r + 1].plan.line != fine.plan.line ||
                      !table.rows[r + 1].result.completed;  // that one may have met its budget
    const auto rate = fine.rates.find(norm);
    if (!last || rate == fine.rates.end() || rate->second < 0.1 || !coarse.result.completed) continue;
    const double ratio = *fine.plan.refinement / *coarse.plan.refinement;
    const double steps = std::log(*error_in(fine.norms, norm) / value) / (rate->second * std::abs(std::log(ratio)));
    const double growth = std::max(seconds_of(fine) / seconds_of(coarse), 1.0);
    const Extrapolation here{fine.plan.line, *fine.plan.refinement * std::pow(ratio, steps),
                             seconds_of(fine) * std::pow(growth, steps)};
    if (!best || here.seconds < best->seconds) best = here;
  }
  return best;
}

std::string next_digits(const StudyTable& table, const Tolerance& tolerance, double seconds) {
  std::string text = "what the next digits cost\n";
  for (const double share : {0.1, 0.01}) {
    const double value = share * tolerance.value;
    if (const auto rows = within(table, tolerance.norm, value); !rows.empty()) {
      const StudyRow& row = table.rows[rows.front()];
      text += fmt::format("  {:<8.1e}{:.3g} s, {:.3g} times as much: {}\n", value, seconds_of(row),
                          seconds_of(row) / seconds, setting_of(table, row));
    } else if (const auto guess = extrapolated(table, tolerance.norm, value)) {
      text += fmt::format("  {:<8.1e}no run of this study; by its last rate and times about {:.2g} s: {}, {} {:.2g}\n",
                          value, guess->seconds, guess->line, table.axes[*table.refine], guess->refinement);
    } else {
      text += fmt::format("  {:<8.1e}no run of this study, and no line that converges\n", value);
    }
  }
  return text;
}

/// The error on a shifted grid, or why there is none.
struct Verified {
  bool possible;
  std::optional<double> error;
  std::string words;
};

Verified verified(const StudyRow& row, const std::string& norm, const Json& json, const RunMore& run) {
  const std::vector<std::string> shift = shifted_grid(json);
  if (shift.empty())
    return {false, {}, "not tried on a shifted grid: a mesh, or supports on grid lines, leave it no other place"};
  const StudyRow shifted = run(row.plan, shift);
  if (!shifted.result.completed) return {true, {}, "on a shifted grid " + shifted.result.reason};
  const auto error = error_in(shifted.norms, norm);
  return {true, error,
          error ? fmt::format("on a grid shifted by (0.37, 0.21) cells {:.2e}", *error)
                : "on a shifted grid it has no such error"};
}

/// What remains of the error with each part refined.
void attribute(const StudyRow& row, const std::string& norm, const Json& json, const RunMore& run, Answer& found) {
  constexpr double telling = 0.9;  // of the error: what a refinement must leave at most to count
  const double error = *error_in(row.norms, norm);
  std::string text = fmt::format("  {:<18}{:>12}{:>10}\n", "part refined", "error left", "share");
  double least = telling * error;
  for (const Refinement& refinement : refinements_of(json)) {
    const StudyRow refined = run(row.plan, refinement.settings);
    const auto left = error_in(refined.norms, norm);
    if (!left) {
      text += fmt::format("  {:<18}{:>12}  {}\n", refinement.part, "failed", refined.result.reason);
      continue;
    }
    text += fmt::format("  {:<18}{:>12.2e}{:>8.0f} %\n", refinement.part, *left, 100.0 * *left / error);
    found.error_left[refinement.part] = *left;
    if (*left >= least) continue;
    least = *left;
    found.dominant = refinement.part;
  }
  found.text += found.dominant.empty()
                    ? "no part dominates the error there: none of these alone takes a tenth of it away\n"
                    : fmt::format("the error there is mostly that of the {}\n", found.dominant);
  found.text += text;
}

std::string chosen_text(const StudyTable& table, const Tolerance& tolerance, const StudyRow& row,
                        const Verified& shifted) {
  return fmt::format("the cheapest setting with {} <= {:g}: {}\n  {:.2e}, {}; {:.3g} s, {} points, {} unknowns\n",
                     tolerance.norm, tolerance.value, setting_of(table, row), *error_in(row.norms, tolerance.norm),
                     shifted.words, seconds_of(row), row.result.summary["material_points"].dump(),
                     row.result.summary["degrees_of_freedom"].dump());
}

void check_norm(const StudyTable& table, const std::string& norm) {
  const std::vector<std::string> norms = norms_in(table.rows);
  if (std::ranges::count(norms, norm)) return;
  throw CaseError("--tolerance " + norm, "",
                  norms.empty() ? "found no run with errors, expected an exact solution or a reference"
                                : "found no such norm, " + expected_one_of(norms, norm));
}

}  // namespace

Answer answer(const StudyTable& table, const Tolerance& tolerance,
              const std::function<Json(const PlannedRun&)>& base_of, const RunMore& run) {
  check_norm(table, tolerance.norm);
  const std::vector<std::size_t> rows = within(table, tolerance.norm, tolerance.value);
  Answer found;
  std::string unmet;
  for (const std::size_t r : rows) {
    const StudyRow& row = table.rows[r];
    const Json json = base_of(row.plan);
    const Verified shifted = verified(row, tolerance.norm, json, run);
    if (!shifted.possible || (shifted.error && *shifted.error <= tolerance.value)) {
      found.chosen = r;
      found.text = chosen_text(table, tolerance, row, shifted) + unmet + next_digits(table, tolerance, seconds_of(row));
      attribute(row, tolerance.norm, json, run, found);
      return found;
    }
    unmet += fmt::format("  not {}: {}\n", setting_of(table, row), shifted.words);
  }
  found.text = fmt::format("no setting of this study has {} <= {:g}{}\n{}", tolerance.norm, tolerance.value,
                           rows.empty() ? "" : " on a shifted grid, too", unmet);
  if (const auto guess = extrapolated(table, tolerance.norm, tolerance.value); guess && rows.empty())
    found.text += fmt::format("  by its last rate and times about {:.2g} s: {}, {} {:.2g}\n", guess->seconds,
                              guess->line, table.axes[*table.refine], guess->refinement);
  return found;
}

}  // namespace shoreline
