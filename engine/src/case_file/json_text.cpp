#include "json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

namespace shoreline {
namespace {

constexpr int deepest = 32;

/// Follows the parser through objects and arrays, and refuses what it would let pass.
class Watcher {
 public:
  explicit Watcher(Place place) : place_(std::move(place)) {}

  void see(int depth, Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    if (depth > deepest) where().fail(fmt::format("nested deeper than {} levels", deepest));
    switch (event) {
      case Event::object_start:
      case Event::array_start:
        open_.emplace_back();
        break;
      case Event::key:
        open_.back().key = parsed.get<std::string>();
        if (!open_.back().keys.insert(open_.back().key).second) where().fail("the key is there twice, expected once");
        break;
      case Event::object_end:
      case Event::array_end:
        open_.pop_back();
        [[fallthrough]];
      case Event::value:
        if (!open_.empty()) ++open_.back().entry;
        break;
    }
  }

  /// The value that is being read.
  [[nodiscard]] Place where() const {
    Place place = place_;
    for (const Level& level : open_) place = level.keys.empty() ? place / level.entry : place / level.key;
    return place;
  }

 private:
  struct Level {
    std::set<std::string> keys;  ///< empty in an array
    std::string key;
    std::size_t entry = 0;
  };
  Place place_;
  std::vector<Level> open_;
};

/// "line 3, column 5: problem" out of the parser's "[json.exception.…] parse error at …", not longer than a line or
/// two.
std::string syntax_problem(const std::string& message) {
  constexpr std::size_t longest = 200;
  return message.substr(std::min(message.find("line "), message.size()), longest);
}

std::string kind(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return value.size() == 1 ? "a list of 1" : fmt::format("a list of {}", value.size());
  if (value.is_string()) return "a string";
  if (value.is_boolean()) return "true or false";
  return value.is_null() ? "null" : "a number";
}

}  // namespace

Place Place::operator/(const std::string& key) const {
  std::string escaped;
  for (const char c : key) escaped += c == '~' ? std::string("~0") : c == '/' ? std::string("~1") : std::string(1, c);
  return {file, pointer + "/" + escaped};
}

Json parse_json(const std::string& text, const Place& place) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) place.fail("is empty, expected JSON");
  Watcher watcher(place);
  const auto see = [&](int depth, Json::parse_event_t event, const Json& parsed) {
    watcher.see(depth, event, parsed);
    return true;
  };
  try {
    return Json::parse(text, see);
  } catch (const Json::parse_error& error) {
    place.fail("no valid JSON: " + syntax_problem(error.what()));
  } catch (const Json::out_of_range&) {
    watcher.where().fail("found a number beyond 1.8e308, expected one that a double can hold");
  }
}

std::string described(const Json& value) {
  constexpr std::size_t longest = 60;
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (value.is_number() || value.is_null() || value.is_boolean()) return text;
  if (text.size() > longest) return kind(value);
  return fmt::format("{} ({})", text, kind(value));
}

}  // namespace shoreline
