#include "overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "nearest.hpp"

namespace shoreline {
namespace {

std::vector<std::string> steps_of(const std::string& path, const Place& place) {
  std::vector<std::string> steps(1);
  for (const char c : path) {
    if (c == '.')
      steps.emplace_back();
    else
      steps.back() += c;
  }
  if (std::ranges::count(steps, "")) place.fail("expected path=value with a path like grid.cell_size");
  return steps;
}

/// JSON, or a bare word; what begins like JSON must be JSON.
Json value_of(const std::string& text, const Place& place) {
  const std::size_t start = text.find_first_not_of(' ');
  if (start == std::string::npos) place.fail("found no value, expected path=value");
  const bool structured = std::string("{[\"").find(text[start]) != std::string::npos;
  const bool number = text.find_first_not_of("0123456789+-.eE") == std::string::npos;
  return structured || number || Json::accept(text) ? parse_json(text, place) : Json(text);
}

/// Number of a list entry, from its number or its "name".
Json& entry_of(Json& list, const std::string& step, const Place& place) {
  std::size_t number = list.size();
  const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), number);
  if (error == std::errc() && end == step.data() + step.size() && number < list.size()) return list[number];
  std::vector<std::string> names;
  for (Json& entry : list) {
    if (!entry.is_object() || !entry.contains("name") || !entry["name"].is_string()) continue;
    if (entry["name"] == step) return entry;
    names.push_back(entry["name"]);
  }
  place.fail(fmt::format("found entry \"{}\", expected a number below {}{}", step, list.size(),
                         names.empty() ? "" : " or a name: " + expected_one_of(names, step)));
}

}  // namespace

void override_value(Json& root, const std::string& assignment) {
  Place place{"--set " + assignment, {}};
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) place.fail("expected path=value");
  Json* at = &root;
  for (const std::string& step : steps_of(assignment.substr(0, equals), place)) {
    if (at->is_array()) {
      at = &entry_of(*at, step, place);
    } else if (at->is_object() || at->is_null()) {
      at = &(*at)[step];
    } else {
      place.fail(fmt::format("found {}, expected an object or a list that can hold \"{}\"", described(*at), step));
    }
    place = place / step;
  }
  *at = value_of(assignment.substr(equals + 1), place);
}

}  // namespace shoreline
