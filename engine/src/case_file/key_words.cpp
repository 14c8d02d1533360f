// The table of keys in words: for messages and the reference page.

#include <fmt/format.h>

#include <cmath>

#include "keys.hpp"
#include "shoreline/boundary/conditions.hpp"

namespace shoreline::keys {
namespace {

std::string any_of(const std::vector<std::string>& words) {
  if (words.size() == 1) return fmt::format("\"{}\"", words[0]);
  return fmt::format("one of \"{}\"", fmt::join(words, "\", \""));
}

std::string in_words(const Range& range) {
  std::string text = "a number";
  if (std::isfinite(range.lower)) text += fmt::format(" {} {:g}", range.lower_open ? ">" : "≥", range.lower);
  if (std::isfinite(range.upper))
    text += fmt::format("{} {} {:g}", text == "a number" ? "" : " and", range.upper_open ? "<" : "≤", range.upper);
  return text;
}

std::string in_words(const List& list) {
  const std::string entry = keys::in_words(*list.entry);
  if (list.at_least == list.at_most) return fmt::format("a list of {}, each {}", list.at_least, entry);
  return fmt::format("a list of at least {}, each {}", list.at_least, entry);
}

std::string in_words(const Either& either) {
  std::string text;
  for (const Schema& schema : either.alternatives) {
    text += (text.empty() ? "" : ", or ") + keys::in_words(schema);
    if (const auto* object = std::get_if<Object>(&schema.kind)) text += " with \"" + object->keys.front().name + "\"";
  }
  return text;
}

std::string in_words(const Tagged& tagged) {
  const std::string text = fmt::format("an object with \"{}\", {}", tagged.tag, any_of(names(tagged)));
  return tagged.fallback.empty() ? text : fmt::format("{} (default \"{}\")", text, tagged.fallback);
}

}  // namespace

std::string in_words(const Schema& schema) {
  return std::visit(
      Overloaded{
          [](const Number& number) { return in_words(number.range); },
          [](const Integer& whole) { return fmt::format("a whole number from {} to {}", whole.lower, whole.upper); },
          [](const Boolean&) { return std::string("true or false"); },
          [](const Text&) { return std::string("a string"); },
          [](const Name&) { return std::string("a name without \"/\", \".\" and control characters"); },
          [](const Choice& choice) { return any_of(choice.words); },
          [](const Formula&) { return std::string("a number or an expression in a string"); },
          [](const List& list) { return in_words(list); }, [](const Anything&) { return std::string("any value"); },
          [](const Map& map) { return "an object of names, each with " + keys::in_words(*map.entry); },
          [](const Object&) { return std::string("an object"); }, [](const Tagged& tagged) { return in_words(tagged); },
          [](const Depending&) { return std::string("an object"); },
          [](const Either& either) { return in_words(either); }},
      schema.kind);
}

std::vector<std::string> names(const Object& object) {
  std::vector<std::string> all;
  for (const Key& key : object.keys) all.push_back(key.name);
  return all;
}

std::vector<std::string> names(const Tagged& tagged) {
  std::vector<std::string> all;
  for (const auto& [name, object] : tagged.alternatives) all.push_back(name);
  return all;
}

}  // namespace shoreline::keys
