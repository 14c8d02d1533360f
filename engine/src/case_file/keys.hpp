#pragma once
// The keys of a case: one declarative table. Checking, defaults, JSON Schema and reference page all follow it.

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "json_text.hpp"

namespace shoreline::keys {

struct Schema;
struct Key;

/// Numbers between two ends; an open end does not belong.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;
  bool upper_open = false;
};

struct Number {
  Range range;
};
struct Integer {
  int lower;
  int upper;
};
struct Boolean {};
struct Text {};
/// A name that a path and a results file can hold: not empty, no '/', '.' or control character.
struct Name {};
/// One of some words.
struct Choice {
  std::vector<std::string> words;
};
/// A number or a string with a formula; the formula itself is checked by the reader.
struct Formula {};
struct List {
  std::shared_ptr<const Schema> entry;
  std::size_t at_least;
  std::size_t at_most;
};
/// Any JSON value: another table judges it.
struct Anything {};
/// Keys of free choice, each with a value of one kind.
struct Map {
  std::shared_ptr<const Schema> entry;
};
/// The keys of an object, no others; of those in @ref exactly_one there must be one and no more.
struct Object {
  std::vector<Key> keys;
  std::vector<std::string> exactly_one;
};
/// An object with a key that says which further keys it has.
struct Tagged {
  std::vector<std::pair<std::string, Object>> alternatives;
  std::string tag = "type";
  std::string fallback{};  ///< alternative that a missing tag means; empty: it must be there
};
/// An object whose keys depend on the tag of one of them, "type" in an object that every alternative holds under the
/// same key. The first alternative answers where that is missing.
struct Depending {
  std::string on;  ///< that key
  std::vector<std::pair<std::string, Object>> alternatives;
};
/// Alternatives told apart by their JSON type; objects by their first key. The last one answers for what fits none.
struct Either {
  std::vector<Schema> alternatives;
};

struct Schema {
  std::variant<Number, Integer, Boolean, Text, Name, Choice, Formula, Anything, List, Map, Object, Tagged, Depending,
               Either>
      kind;
};

/// One row of the table.
struct Key {
  std::string name;
  Schema schema;
  std::string unit;  ///< "" where there is none
  bool required;
  Json fallback;  ///< null where the key may be missing and has no fixed default
  std::string meaning;
};

/// The table of a case.
[[nodiscard]] const Schema& case_keys();

/// What a value must be, in words: "a number > 0", "a list of 2 numbers".
[[nodiscard]] std::string in_words(const Schema& schema);

/// Which alternative a value is meant to be.
[[nodiscard]] const Schema& alternative(const Either& either, const Json& value);

[[nodiscard]] std::vector<std::string> names(const Object& object);
[[nodiscard]] std::vector<std::string> names(const Tagged& tagged);

/// Checks a value against the table and fills in defaults.
/// @throws CaseError at the first thing that is wrong: where, what was found, what was expected
void check(const Schema& schema, Json& value, const std::string& file);

/// The table as JSON Schema, draft 2020-12.
[[nodiscard]] Json json_schema(const Schema& schema, const std::string& title);

/// The table as a reference page in Markdown.
/// @param whole  heading of the outermost keys: "The case"
[[nodiscard]] std::string reference_page(const Schema& schema, const std::string& whole);

}  // namespace shoreline::keys
