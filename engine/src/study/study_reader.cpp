// From a study file to a Study.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "case_file/json_text.hpp"
#include "case_file/nearest.hpp"
#include "case_file/node.hpp"
#include "case_file/text_file.hpp"
#include "shoreline/engine/study.hpp"
#include "study_keys.hpp"

namespace shoreline {
namespace {

constexpr double most_runs = 1e5;

/// A change to the case as --set takes it.
std::string assignment(const std::string& path, const Json& value, const Place& place) {
  const std::string between = "." + path + ".";
  if (between.find("..") != std::string::npos || path.find('=') != std::string::npos)
    place.fail(fmt::format("found \"{}\", expected a key of the case by dotted path like grid.cell_size", path));
  return path + "=" + value.dump();
}

std::vector<std::string> assignments(const Node& node) {
  std::vector<std::string> all;
  for (const auto& [path, value] : node.value.items()) all.push_back(assignment(path, value, node.place));
  return all;
}

/// The number of an entry is its value; of a list of numbers the first.
Study::Choice labelled(const Json& value) {
  const Json& number = value.is_array() && !value.empty() ? value.front() : value;
  return {.label = value.is_string()   ? value.get<std::string>()
                   : value.is_number() ? fmt::format("{}", value.get<double>())
                                       : value.dump(),
          .number = number.is_number() ? std::optional(number.get<double>()) : std::nullopt,
          .settings = {}};
}

Study::Axis read_values(const Node& node) {
  const auto path = node["key"].as<std::string>();
  Study::Axis axis{node.has("name") ? node["name"].as<std::string>() : path, {}};
  for (const Json& value : node["values"].value) {
    axis.choices.push_back(labelled(value));
    axis.choices.back().settings.push_back(assignment(path, value, node["key"].place));
  }
  return axis;
}

Study::Axis read_zip(const Node& node) {
  const Node lists = node["zip"];
  if (lists.value.empty()) lists.place.fail("found no key, expected keys of the case with lists of values");
  std::vector<std::string> paths;
  for (const auto& [path, values] : lists.value.items()) paths.push_back(path);
  const std::string label = node.has("label") ? node["label"].as<std::string>() : paths.front();
  if (!lists.has(label.c_str()))
    node["label"].place.fail(fmt::format("found \"{}\", {}", label, expected_one_of(paths, label)));
  Study::Axis axis{node.has("name") ? node["name"].as<std::string>() : label, {}};
  for (const Json& value : lists.value[label]) axis.choices.push_back(labelled(value));
  for (const std::string& path : paths) {
    const Node list = lists[path.c_str()];
    if (list.size() != axis.choices.size())
      list.place.fail(
          fmt::format("found {} values, expected {} as under \"{}\"", list.size(), axis.choices.size(), label));
    for (std::size_t i = 0; i < list.size(); ++i)
      axis.choices[i].settings.push_back(assignment(path, list.entry(i).value, lists.place));
  }
  return axis;
}

Study::Axis read_choices(const Node& node) {
  Study::Axis axis{node["name"].as<std::string>(), {}};
  for (std::size_t i = 0; i < node["choices"].size(); ++i) {
    const Node choice = node["choices"].entry(i);
    axis.choices.push_back({choice["name"].as<std::string>(), std::nullopt, assignments(choice["set"])});
  }
  return axis;
}

Study::Axis read_axis(const Node& node) {
  Study::Axis axis = node.has("choices") ? read_choices(node) : node.has("zip") ? read_zip(node) : read_values(node);
  std::set<std::string> labels;
  for (const Study::Choice& choice : axis.choices)
    if (!labels.insert(choice.label).second)
      node.place.fail(
          fmt::format("found \"{}\" twice in the axis \"{}\", expected different entries", choice.label, axis.name));
  return axis;
}

std::vector<Study::Axis> read_axes(const Node& sweep) {
  std::vector<Study::Axis> axes;
  double runs = 1.0;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    axes.push_back(read_axis(sweep.entry(i)));
    runs *= static_cast<double>(axes.back().choices.size());
    if (std::ranges::count(axes, axes.back().name, &Study::Axis::name) > 1)
      sweep.entry(i).place.fail(fmt::format("found a second axis \"{}\", expected another \"name\"", axes.back().name));
  }
  if (runs > most_runs) sweep.place.fail(fmt::format("found {:.3g} runs, expected at most {:.0f}", runs, most_runs));
  return axes;
}

bool sets_cell_size(const Study::Axis& axis) {
  return std::ranges::any_of(axis.choices.front().settings,
                             [](const std::string& setting) { return setting.starts_with("grid.cell_size="); });
}

/// Numbers > 0, no two alike.
bool has_numbers(const Study::Axis& axis) {
  std::set<double> numbers;
  return std::ranges::all_of(axis.choices, [&](const Study::Choice& c) {
    return c.number && *c.number > 0.0 && numbers.insert(*c.number).second;
  });
}

std::optional<std::size_t> refined_axis(const Node& root, const std::vector<Study::Axis>& axes) {
  if (!root.has("refine")) {
    for (std::size_t i = 0; i < axes.size(); ++i)
      if (sets_cell_size(axes[i]) && has_numbers(axes[i])) return i;
    for (std::size_t i = axes.size(); i-- > 0;)
      if (has_numbers(axes[i])) return i;
    return std::nullopt;
  }
  const auto name = root["refine"].as<std::string>();
  const auto axis = std::ranges::find(axes, name, &Study::Axis::name);
  if (axis == axes.end()) {
    std::vector<std::string> names;
    for (const Study::Axis& one : axes) names.push_back(one.name);
    root["refine"].place.fail(fmt::format("found \"{}\", {}", name, expected_one_of(names, name)));
  }
  if (!has_numbers(*axis))
    root["refine"].place.fail(
        fmt::format("found the axis \"{}\", expected one whose entries are different numbers > 0", name));
  return static_cast<std::size_t>(axis - axes.begin());
}

Study::Reference read_reference(const Node& node) {
  if (node.value.is_object()) return Study::OwnRun{assignments(node["set"])};
  if (node.is("richardson")) return Study::Richardson{};
  return Study::Finest{};
}

/// A file that a study names, relative to its own.
std::filesystem::path file_in(const Node& node, const std::filesystem::path& study) {
  const auto name = node.as<std::string>();
  if (name.empty()) node.place.fail("found \"\", expected the name of a file");
  return study.parent_path() / name;
}

Study study_of(const Node& root, const std::filesystem::path& file) {
  Study study;
  study.file = file;
  study.title = root.has("title") ? root["title"].as<std::string>() : file.stem().string();
  study.base = file_in(root["case"], file);
  study.settings = assignments(root["set"]);
  study.axes = read_axes(root["sweep"]);
  study.refine = refined_axis(root, study.axes);
  study.repeat = root["repeat"].as<int>();
  if (root["budget"].has("seconds")) study.seconds = root["budget"]["seconds"].as<double>();
  if (root["budget"].has("memory")) study.memory = root["budget"]["memory"].as<double>();
  study.samples = root["samples"].as<int>();
  if (study.samples == 1) root["samples"].place.fail("found 1, expected 0, or 2 and more as the case takes them");
  if (root.has("errors")) study.errors = root["errors"].as<std::vector<std::string>>();
  if (root.has("reference")) study.reference = read_reference(root["reference"]);
  if (std::holds_alternative<Study::Richardson>(study.reference.value_or(Study::Finest{})) &&
      (!study.refine || study.axes[*study.refine].choices.size() < 3))
    root["reference"].place.fail("found \"richardson\", expected an axis to refine with at least 3 entries beside it");
  if (root.has("outside"))
    for (std::size_t i = 0; i < root["outside"].size(); ++i)
      study.outside.push_back(file_in(root["outside"].entry(i), file));
  return study;
}

}  // namespace

Study read_study(const std::filesystem::path& file) {
  const Place whole{file.string(), {}};
  Json json = parse_json(text_of(file, "a study file"), whole);
  keys::check(keys::study_keys(), json, file.string());
  Study study = study_of({json, whole}, file);
  const Json base = parse_json(text_of(study.base, "a case file"), {study.base.string(), {}});
  if (!base.is_object()) Place{study.base.string(), {}}.fail(fmt::format("found {}, expected a case", described(base)));
  return study;
}

std::string study_schema() { return keys::json_schema(keys::study_keys(), "Shoreline study").dump(2) + "\n"; }

}  // namespace shoreline
