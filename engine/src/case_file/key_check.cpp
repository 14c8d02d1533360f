// Checks JSON against the table of keys, and fills in defaults.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "keys.hpp"
#include "nearest.hpp"
#include "shoreline/boundary/conditions.hpp"

namespace shoreline::keys {
namespace {

bool contains(const Range& range, double x) {
  return (range.lower_open ? x > range.lower : x >= range.lower) &&
         (range.upper_open ? x < range.upper : x <= range.upper);
}

/// Whether a value is, by its JSON type, meant for an alternative.
bool fits_type(const Schema& schema, const Json& value) {
  return std::visit(
      Overloaded{[&](const Object& object) { return value.is_object() && value.contains(object.keys.front().name); },
                 [&](const List&) { return value.is_array(); }, [&](const Number&) { return value.is_number(); },
                 [&](const Integer&) { return value.is_number(); }, [&](const Choice&) { return value.is_string(); },
                 [&](const Tagged&) { return value.is_object(); }, [](const auto&) { return false; }},
      schema.kind);
}

/// The alternative that the tag of a value names; else the first.
const std::pair<std::string, Object>& alternative(const Depending& depending, const Json& value) {
  const Json tag = value.value(depending.on, Json::object());
  const auto meant = std::ranges::find_if(depending.alternatives, [&](const auto& one) {
    return tag.is_object() && tag.value("type", Json()) == one.first;
  });
  return meant == depending.alternatives.end() ? depending.alternatives.front() : *meant;
}

class Checker {
 public:
  explicit Checker(std::string file) : file_(std::move(file)) {}

  void check(const Schema& schema, Json& value) {
    std::visit([&](const auto& kind) { check_kind(kind, schema, value); }, schema.kind);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    Place place{file_, {}};
    for (const std::string& step : path_) place = place / step;
    place.fail(problem);
  }
  void expect(bool holds, const Schema& schema, const Json& value) const {
    if (!holds) fail(fmt::format("found {}, expected {}", described(value), in_words(schema)));
  }
  void check_at(const std::string& step, const Schema& schema, Json& value) {
    path_.push_back(step);
    check(schema, value);
    path_.pop_back();
  }

  void check_kind(const Number& number, const Schema& schema, const Json& value) const {
    expect(value.is_number() && contains(number.range, value.get<double>()), schema, value);
  }
  void check_kind(const Integer& whole, const Schema& schema, Json& value) const {
    expect(value.is_number(), schema, value);
    const double number = value.get<double>();
    expect(number >= whole.lower && number <= whole.upper && number == std::floor(number), schema, value);
    value = static_cast<int>(number);  // 8.0 is a whole number too
  }
  void check_kind(const Boolean&, const Schema& schema, const Json& value) const {
    expect(value.is_boolean(), schema, value);
  }
  void check_kind(const Text&, const Schema& schema, const Json& value) const {
    expect(value.is_string(), schema, value);
  }
  void check_kind(const Name&, const Schema& schema, const Json& value) const {
    expect(value.is_string(), schema, value);
    const auto& name = value.get_ref<const std::string&>();
    const auto refused = [](char c) { return c == '/' || c == '.' || (c >= 0 && c < ' '); };
    expect(!name.empty() && std::ranges::none_of(name, refused), schema, value);
  }
  void check_kind(const Choice& choice, const Schema& schema, const Json& value) const {
    expect(value.is_string(), schema, value);
    const auto& word = value.get_ref<const std::string&>();
    if (!std::ranges::count(choice.words, word))
      fail(fmt::format("found {}, {}", described(value), expected_one_of(choice.words, word)));
  }
  void check_kind(const Formula&, const Schema& schema, const Json& value) const {
    expect(value.is_number() || value.is_string(), schema, value);
  }
  void check_kind(const List& list, const Schema& schema, Json& value) {
    if (value.is_array() && value.size() > list.at_most && list.at_most > list.at_least)
      fail(fmt::format("found {}, expected at most {} entries", described(value), list.at_most));
    expect(value.is_array() && value.size() >= list.at_least && value.size() <= list.at_most, schema, value);
    for (std::size_t i = 0; i < value.size(); ++i) check_at(std::to_string(i), *list.entry, value[i]);
  }
  void check_kind(const Anything&, const Schema&, const Json&) const {}
  void check_kind(const Map& map, const Schema& schema, Json& value) {
    expect(value.is_object(), schema, value);
    for (auto& [name, entry] : value.items()) check_at(name, *map.entry, entry);
  }
  void check_kind(const Either& either, const Schema& schema, Json& value) {
    const Schema& meant = alternative(either, value);
    const bool object = value.is_object() && std::holds_alternative<Object>(meant.kind);  // says which key it lacks
    expect(object || fits_type(meant, value), schema, value);
    for (const Schema& schema_of_other : either.alternatives)
      if (const auto* other = std::get_if<Object>(&schema_of_other.kind); object && other != nullptr)
        refuse_foreign(std::get<Object>(meant.kind), *other, value, [&](const std::string& name) {
          return fmt::format("found \"{}\" beside \"{}\", expected only one of the two", name,
                             std::get<Object>(meant.kind).keys.front().name);
        });
    check(meant, value);
  }
  void check_kind(const Object& object, const Schema& schema, Json& value) {
    expect(value.is_object(), schema, value);
    check_keys(object, names(object), value);
  }
  void check_kind(const Tagged& tagged, const Schema& schema, Json& value) {
    expect(value.is_object(), schema, value);
    const std::vector<std::string> types = names(tagged);
    if (!value.contains(tagged.tag)) {
      if (tagged.fallback.empty())
        fail(fmt::format("key \"{}\" is missing, {}", tagged.tag, expected_one_of(types, "")));
      value[tagged.tag] = tagged.fallback;
    }
    check_at(tagged.tag, {Choice{types}}, value[tagged.tag]);
    const auto chosen = std::ranges::find(types, value[tagged.tag].get_ref<const std::string&>());
    const Object& object = tagged.alternatives[static_cast<std::size_t>(chosen - types.begin())].second;
    std::vector<std::string> allowed = names(object);
    allowed.insert(allowed.begin(), tagged.tag);
    check_keys(object, allowed, value);
  }

  void check_kind(const Depending& depending, const Schema& schema, Json& value) {
    expect(value.is_object(), schema, value);
    const auto& meant = alternative(depending, value);
    check_tag(depending, *std::ranges::find(meant.second.keys, depending.on, &Key::name), value);
    for (const auto& [tag, other] : depending.alternatives)
      refuse_foreign(meant.second, other, value, [&](const std::string& name) {
        return fmt::format("found \"{}\", expected none with \"type\": \"{}\" in /{}", name, meant.first, depending.on);
      });
    check_keys(meant.second, names(meant.second), value);
  }

  /// Comes first: where the tag is wrong, none of the other keys can be judged.
  void check_tag(const Depending& depending, const Key& tag, Json& value) {
    if (value.contains(tag.name)) return check_at(tag.name, tag.schema, value[tag.name]);
    std::vector<std::string> allowed;
    for (const auto& [type, object] : depending.alternatives)
      for (const std::string& name : names(object))
        if (!std::ranges::count(allowed, name)) allowed.push_back(name);
    refuse_unknown(allowed, value);
    fail_missing(tag);
  }

  [[noreturn]] void fail_missing(const Key& key) const {
    fail(fmt::format("key \"{}\" is missing, expected {}", key.name, in_words(key.schema)));
  }

  void check_keys(const Object& object, const std::vector<std::string>& allowed, Json& value) {
    refuse_unknown(allowed, value);
    check_exactly_one(object, value);
    for (const Key& key : object.keys) {
      if (!value.contains(key.name)) {
        if (key.required) fail_missing(key);
        if (key.fallback.is_null()) continue;
        value[key.name] = key.fallback;
      }
      check_at(key.name, key.schema, value[key.name]);
    }
  }

  /// Tells of a key that is like an allowed one before it tells of a foreign one.
  void refuse_unknown(const std::vector<std::string>& allowed, const Json& value) const {
    std::vector<std::string> unknown;
    for (const auto& [name, entry] : value.items())
      if (!std::ranges::count(allowed, name)) unknown.push_back(name);
    if (unknown.empty()) return;
    const auto typo = std::ranges::find_if(unknown, [&](const auto& name) { return !nearest(name, allowed).empty(); });
    const std::string& name = typo == unknown.end() ? unknown.front() : *typo;
    fail(fmt::format("found unknown key {}, {}", Json(name).dump(), expected_one_of(allowed, name)));
  }

  /// Tells of a key that belongs to another alternative.
  void refuse_foreign(const Object& meant, const Object& other, const Json& value, auto&& problem) {
    const std::vector<std::string> allowed = names(meant);
    for (const std::string& name : names(other))
      if (value.contains(name) && !std::ranges::count(allowed, name)) {
        path_.push_back(name);
        fail(problem(name));
      }
  }

  void check_exactly_one(const Object& object, const Json& value) const {
    if (object.exactly_one.empty()) return;
    std::vector<std::string> found;
    for (const std::string& name : object.exactly_one)
      if (value.contains(name)) found.push_back(name);
    if (found.size() != 1)
      fail(fmt::format("found {}, expected exactly one of \"{}\"",
                       found.empty() ? "none" : fmt::format("\"{}\"", fmt::join(found, "\" and \"")),
                       fmt::join(object.exactly_one, "\", \"")));
  }

  std::string file_;
  std::vector<std::string> path_;
};

}  // namespace

const Schema& alternative(const Either& either, const Json& value) {
  const auto meant = std::ranges::find_if(either.alternatives, [&](const Schema& s) { return fits_type(s, value); });
  return meant == either.alternatives.end() ? either.alternatives.back() : *meant;
}

void check(const Schema& schema, Json& value, const std::string& file) { Checker(file).check(schema, value); }

}  // namespace shoreline::keys
