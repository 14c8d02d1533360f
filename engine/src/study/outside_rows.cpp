#include "outside_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "case_file/nearest.hpp"
#include "case_file/place.hpp"
#include "case_file/text_file.hpp"

namespace shoreline {
namespace {

using Cells = std::vector<std::string>;

/// The rows of a table; a quoted cell may hold commas, line breaks and doubled quotes.
std::vector<Cells> rows_of(const std::string& text) {
  std::vector<Cells> rows{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    std::string& cell = rows.back().back();
    if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"')
      cell += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      rows.back().emplace_back();
    else if (c == '\n' && !quoted)
      rows.push_back({""});
    else if (c != '\r' || quoted)
      cell += c;
  }
  std::erase_if(rows, [](const Cells& row) { return row == Cells{""}; });
  return rows;
}

std::optional<double> number_in(const std::string& cell) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

void take(const std::string& column, const std::string& cell, OutsideRow& row) {
  const std::optional<double> number = number_in(cell);
  if (column == "line")
    row.line = cell;
  else if (column == "refinement")
    row.refinement = number;
  else if (column == "points")
    row.points = number.value_or(0.0);
  else if (column == "unknowns")
    row.unknowns = number.value_or(0.0);
  else if (column == "seconds")
    row.seconds = number.value_or(0.0);
  else if (number)
    row.norms[column] = *number;
}

}  // namespace

std::vector<OutsideRow> read_outside_rows(const std::filesystem::path& file) {
  const Place place{file.string(), {}};
  const std::vector<Cells> table = rows_of(text_of(file, "a table of another program's runs"));
  if (table.empty()) place.fail("is empty, expected a row of column names, then a row a run");
  const Cells& columns = table.front();
  for (const std::string needed : {"line", "seconds"})
    if (!std::ranges::count(columns, needed))
      place.fail(fmt::format("found no column \"{}\" among {}, expected \"line\" and \"seconds\"", needed,
                             fmt::join(columns, ", ")));
  const auto status = static_cast<std::size_t>(std::ranges::find(columns, "status") - columns.begin());
  std::vector<OutsideRow> rows;
  for (std::size_t r = 1; r < table.size(); ++r) {
    if (table[r].size() != columns.size())
      place.fail(fmt::format("row {}: found {} cells, expected {}", r + 1, table[r].size(), columns.size()));
    if (status < columns.size() && table[r][status] != "completed") continue;
    OutsideRow row;
    for (std::size_t c = 0; c < columns.size(); ++c) take(columns[c], table[r][c], row);
    if (!(row.seconds > 0.0)) place.fail(fmt::format("row {}: expected \"seconds\" to be a number > 0", r + 1));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace shoreline
